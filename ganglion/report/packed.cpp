#include "ganglion/report/packed.h"

#include <bit>
#include <vector>

#include "ganglion/base/base64.h"

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
