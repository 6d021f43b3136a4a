#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace ganglion::mcap {

/// zstd with contexts that are kept from chunk to chunk, since making one costs more than a small chunk.
class Compressor {
 public:
  explicit Compressor(int level);
  /// Replaces `out` by the compressed bytes, a frame that states its content's size. False when out of memory.
  bool compress(std::string_view bytes, std::string& out);

 private:
  struct Free {
    void operator()(void* context) const noexcept;
  };
  std::unique_ptr<void, Free> context_;
};

class Decompressor {
 public:
  Decompressor();
  /// Replaces `out` by the content, which must have exactly `size` bytes. False when damaged or of another size.
  /// `size` is the caller's to limit.
  bool decompress(std::string_view bytes, std::size_t size, std::string& out);

 private:
  struct Free {
    void operator()(void* context) const noexcept;
  };
  std::unique_ptr<void, Free> context_;
};

}  // namespace ganglion::mcap
