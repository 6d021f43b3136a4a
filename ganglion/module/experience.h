#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ganglion/base/result.h"

namespace ganglion {

/// A named piece of what a module has learned. Small pieces let the store write only what changed.
struct ExperiencePart {
  std::string name;
  std::vector<std::byte> bytes;
};

/// Appends numbers to a part, little-endian on every machine.
class ByteWriter {
 public:
  void u8(std::uint8_t value);
  void u32(std::uint32_t value);
  void i32(std::int32_t value) { u32(static_cast<std::uint32_t>(value)); }
  void u64(std::uint64_t value);
  void f64(double value);
  std::vector<std::byte> take() noexcept { return std::move(bytes_); }

 private:
  std::vector<std::byte> bytes_;
};

/// Reads them back; never beyond the end: what is missing reads as 0 and ok() turns false.
class ByteReader {
 public:
  explicit ByteReader(std::span<const std::byte> bytes) noexcept : bytes_(bytes) {}
  std::uint8_t u8() noexcept;
  std::uint32_t u32() noexcept;
  std::int32_t i32() noexcept { return static_cast<std::int32_t>(u32()); }
  std::uint64_t u64() noexcept;
  double f64() noexcept;
  bool ok() const noexcept { return ok_; }
  /// True when everything was read and nothing was missing.
  bool complete() const noexcept { return ok_ && bytes_.empty(); }

 private:
  std::span<const std::byte> bytes_;
  bool ok_ = true;
};

/// What every component can do with its experience. Called between ticks, so allocation is allowed.
class Learner {
 public:
  virtual ~Learner() = default;
  /// Version of the parts' layout; 0 = this kind learns nothing.
  virtual std::uint32_t experience_version() const noexcept { return 0; }
  /// Adds its parts, each under a name of its own, in a fixed order.
  virtual void save(std::vector<ExperiencePart>&) const {}
  /// Takes parts saved by this or an earlier version. Fails with Corrupt or Unsupported, leaving the component as it
  /// was.
  virtual Result<void> load(std::uint32_t /*version*/, std::span<const ExperiencePart> /*parts*/) { return {}; }
};

}  // namespace ganglion
