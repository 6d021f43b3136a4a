#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ganglion/base/result.h"

namespace ganglion {

/// A named piece of what a module has learned, as it is stored. Small pieces let the store write only what changed.
struct ExperiencePart {
  std::string name;
  std::vector<std::byte> bytes;
};

/// A part as its component has it now.
struct PartState {
  std::string_view name;         ///< Valid until the component changes.
  std::uint64_t generation = 0;  ///< Another one whenever the part is another.
};

/// A parameter that what was learned rests on, and its value as text: a map of cells, on their size.
struct RestsOn {
  std::string parameter;
  std::string value;
  friend bool operator==(const RestsOn&, const RestsOn&) = default;
};

/// Makes of a part's raw bytes, as Learner::copy() gives them, those that are stored. Runs on the thread that writes, while
/// the component goes on: it may look at nothing else.
using Encode = void (*)(std::string_view part, std::span<const std::byte> raw, std::vector<std::byte>& stored);

/// Appends numbers to a part, little-endian on every machine.
class ByteWriter {
 public:
  ByteWriter() = default;
  /// Into memory that is used again; what it held is gone.
  explicit ByteWriter(std::vector<std::byte> reused) noexcept : bytes_(std::move(reused)) { bytes_.clear(); }
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
  /// Its parts, each under a name of its own, in a fixed order. A part that is not among them any more is gone.
  virtual std::span<const PartState> parts() const noexcept { return {}; }
  /// Makes `into` the raw bytes of the n-th part, in the memory it has: as little work as can be, the run waits for it.
  virtual void copy(std::size_t /*part*/, std::vector<std::byte>& /*into*/) const {}
  /// Takes parts stored by this or an earlier version. Fails with Corrupt or Unsupported, leaving the component as it
  /// was.
  virtual Result<void> load(std::uint32_t /*version*/, std::span<const ExperiencePart> /*parts*/) { return {}; }
};

/// A component that learns, as whoever keeps its experience sees it. Valid as long as its controller.
struct LearningComponent {
  std::string component;  ///< Its id.
  std::string kind;
  const Learner* learner = nullptr;
  Encode encode = nullptr;  ///< Null: raw bytes are stored as they are.
  std::vector<RestsOn> rests_on;
};

/// What is stored for a part's raw bytes.
void encode_part(Encode encode, std::string_view part, std::span<const std::byte> raw, std::vector<std::byte>& stored);

/// All parts of whatever has parts() and copy(), as they are stored.
template <class Learned>
std::vector<ExperiencePart> stored_parts(const Learned& learned, Encode encode) {
  std::vector<ExperiencePart> stored;
  std::vector<std::byte> raw;
  const std::span<const PartState> parts = learned.parts();
  for (std::size_t i = 0; i < parts.size(); ++i) {
    learned.copy(i, raw);
    ExperiencePart& part = stored.emplace_back(ExperiencePart{std::string(parts[i].name), {}});
    encode_part(encode, part.name, raw, part.bytes);
  }
  return stored;
}

}  // namespace ganglion
