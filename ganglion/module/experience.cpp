#include "ganglion/module/experience.h"

#include <bit>

namespace ganglion {
namespace {

void append(std::vector<std::byte>& bytes, std::uint64_t value, int count) {
  for (int i = 0; i < count; ++i) bytes.push_back(static_cast<std::byte>((value >> (8 * i)) & 0xff));
}

std::uint64_t take(std::span<const std::byte>& bytes, bool& ok, std::size_t count) noexcept {
  if (bytes.size() < count) {
    ok = false;
    bytes = {};
    return 0;
  }
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < count; ++i) value |= std::to_integer<std::uint64_t>(bytes[i]) << (8 * i);
  bytes = bytes.subspan(count);
  return value;
}

}  // namespace

void ByteWriter::u8(std::uint8_t value) { append(bytes_, value, 1); }
void ByteWriter::u32(std::uint32_t value) { append(bytes_, value, 4); }
void ByteWriter::u64(std::uint64_t value) { append(bytes_, value, 8); }
void ByteWriter::f64(double value) { u64(std::bit_cast<std::uint64_t>(value)); }

std::uint8_t ByteReader::u8() noexcept { return static_cast<std::uint8_t>(take(bytes_, ok_, 1)); }
std::uint32_t ByteReader::u32() noexcept { return static_cast<std::uint32_t>(take(bytes_, ok_, 4)); }
std::uint64_t ByteReader::u64() noexcept { return take(bytes_, ok_, 8); }
double ByteReader::f64() noexcept { return std::bit_cast<double>(u64()); }

void encode_part(Encode encode, std::string_view part, std::span<const std::byte> raw, std::vector<std::byte>& stored) {
  if (encode != nullptr) {
    encode(part, raw, stored);
  } else {
    stored.assign(raw.begin(), raw.end());
  }
}

}  // namespace ganglion
