#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string_view>

#include "ganglion/base/result.h"

namespace ganglion::mcap {

/// What becomes of a file that is closed.
enum class Placing {
  Replace,      ///< Whole, it takes the place of the file of its name; else nothing is left of it.
  UnderOwnName  ///< It stays where it was written, whole or not: its owner names it.
};

/// A file being written from start to end (NewFile), with the CRC of all its bytes. The first failure (disk full...) is
/// kept, and nothing is written after it: what is on the disk stays a good beginning.
class OutputFile {
 public:
  /// Makes missing parent folders. Fails with Unwritable.
  static Result<OutputFile> create(const std::filesystem::path& path, Placing placing = Placing::Replace);
  OutputFile(OutputFile&&) noexcept;
  OutputFile& operator=(OutputFile&&) noexcept;
  ~OutputFile();

  /// Hands the bytes to the operating system.
  void write(std::string_view bytes);
  /// Asks for what was written to reach the disk. Returns at once: a helper thread waits for the disk, started by the
  /// first call, so that a run of less than a second has none.
  void start_sync();
  /// Waits until everything is on the disk (if `durable`), closes, puts it in its place, and gives the first failure.
  Result<void> close(bool durable);

  /// Where it is written.
  std::filesystem::path path() const;
  /// False once closed or moved from.
  bool is_open() const noexcept;
  std::uint64_t position() const noexcept { return position_; }
  std::uint32_t crc() const noexcept { return crc_; }
  bool failed() const noexcept;
  /// The first failure so far.
  Result<void> status() const;

 private:
  struct Handle;
  explicit OutputFile(std::unique_ptr<Handle> handle) noexcept;
  std::unique_ptr<Handle> handle_;
  std::uint64_t position_ = 0;
  std::uint32_t crc_ = 0;
};

}  // namespace ganglion::mcap
