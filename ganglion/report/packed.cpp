#include "ganglion/report/packed.h"

#include <bit>
#include <vector>

namespace ganglion::report {
namespace {

template <class Unsigned>
void append(std::vector<std::uint8_t>& bytes, Unsigned value) {
  for (std::size_t i = 0; i < sizeof(Unsigned); ++i) bytes.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
}

template <class Unsigned>
std::string pack(std::span<const Unsigned> values) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(values.size() * sizeof(Unsigned));
  for (const Unsigned value : values) append(bytes, value);
  return base64(bytes);
}

}  // namespace

std::string base64(std::span<const std::uint8_t> bytes) {
  static constexpr char kLetters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t left = bytes.size() - i;
    const std::uint32_t three = bytes[i] << 16 | (left > 1 ? bytes[i + 1] << 8 : 0) | (left > 2 ? bytes[i + 2] : 0);
    text += kLetters[three >> 18];
    text += kLetters[three >> 12 & 63];
    text += left > 1 ? kLetters[three >> 6 & 63] : '=';
    text += left > 2 ? kLetters[three & 63] : '=';
  }
  return text;
}

std::string pack_f32(std::span<const double> values) {
  std::vector<std::uint32_t> bits;
  bits.reserve(values.size());
  for (const double value : values) bits.push_back(std::bit_cast<std::uint32_t>(static_cast<float>(value)));
  return pack_u32(bits);
}

std::string pack_u32(std::span<const std::uint32_t> values) { return pack(values); }
std::string pack_u16(std::span<const std::uint16_t> values) { return pack(values); }
std::string pack_u8(std::span<const std::uint8_t> values) { return base64(values); }

}  // namespace ganglion::report
