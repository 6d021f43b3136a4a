#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace ganglion {

/// Bijective 64-bit mixing, the finaliser of SplitMix64 (Steele, Lea, Flood 2014). Not for secrets.
constexpr std::uint64_t mix(std::uint64_t x) noexcept {
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

/// Depends on the order of its arguments.
constexpr std::uint64_t combine(std::uint64_t seed, std::uint64_t value) noexcept { return mix(seed ^ mix(value)); }

/// FNV-1a over the bytes: the same on every machine, for names of components and random streams.
constexpr std::uint64_t hash_name(std::string_view name) noexcept {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  return hash;
}

/// The same over raw bytes, 8 at a time.
std::uint64_t hash_bytes(std::span<const std::byte> bytes) noexcept;

/// A double's bits with the many spellings of NaN made one, and -0 made 0.
inline std::uint64_t canonical_bits(double value) noexcept {
  if (value != value) return 0x7ff8000000000000u;
  return std::bit_cast<std::uint64_t>(value == 0 ? 0.0 : value);
}

/// The same number with those bits.
inline double canonical(double value) noexcept { return std::bit_cast<double>(canonical_bits(value)); }

}  // namespace ganglion
