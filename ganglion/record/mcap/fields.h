#pragma once

#include <bit>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

#include "ganglion/record/mcap/format.h"

namespace ganglion::mcap {

/// Appends the fields of MCAP records to a buffer: little-endian numbers, strings and maps with a u32 length.
class FieldWriter {
 public:
  explicit FieldWriter(std::string& out) noexcept : out_(out) {}
  void u8(std::uint8_t value) { out_.push_back(static_cast<char>(value)); }
  void u16(std::uint16_t value) { number(value); }
  void u32(std::uint32_t value) { number(value); }
  void u64(std::uint64_t value) { number(value); }
  void bytes(std::string_view value) { out_.append(value); }
  void string(std::string_view value);
  void map(const Fields& fields);
  /// Starts a record whose length end_record() fills in.
  std::size_t begin_record(Opcode opcode);
  void end_record(std::size_t start);

 private:
  template <class T>
  void number(T value) {
    static_assert(std::endian::native == std::endian::little && std::is_unsigned_v<T>);
    char raw[sizeof(T)];
    __builtin_memcpy(raw, &value, sizeof(T));
    out_.append(raw, sizeof(T));
  }
  std::string& out_;
};

/// Reads them back; never beyond the end: what is missing reads as 0 or "" and ok() turns false for good.
class FieldReader {
 public:
  explicit FieldReader(std::string_view bytes) noexcept : bytes_(bytes) {}
  std::uint8_t u8() noexcept { return number<std::uint8_t>(); }
  std::uint16_t u16() noexcept { return number<std::uint16_t>(); }
  std::uint32_t u32() noexcept { return number<std::uint32_t>(); }
  std::uint64_t u64() noexcept { return number<std::uint64_t>(); }
  std::string_view bytes(std::uint64_t count) noexcept;
  std::string_view string() noexcept { return bytes(u32()); }
  Fields map();
  std::string_view rest() const noexcept { return bytes_; }
  bool ok() const noexcept { return ok_; }

 private:
  template <class T>
  T number() noexcept {
    T value = 0;
    const std::string_view raw = bytes(sizeof(T));
    if (ok_) __builtin_memcpy(&value, raw.data(), sizeof(T));
    return value;
  }
  std::string_view bytes_;
  bool ok_ = true;
};

/// One record of a sequence of records.
struct RecordView {
  Opcode opcode{};
  std::string_view content;
  std::size_t offset = 0;  ///< Of its opcode, from the start of the sequence [bytes].
  std::size_t size() const noexcept { return kRecordHeadBytes + content.size(); }
};

/// The record at `offset`; none if it does not fit into `records`.
std::optional<RecordView> record_at(std::string_view records, std::size_t offset) noexcept;

/// CRC32 as MCAP, zlib and PNG have it, continued from `crc`.
std::uint32_t crc32(std::string_view bytes, std::uint32_t crc = 0) noexcept;

}  // namespace ganglion::mcap
