#include "ganglion/random/draws.h"

#include <algorithm>
#include <cmath>

#include "ganglion/base/expects.h"
#include "ganglion/base/hash.h"
#include "ganglion/math/functions.h"
#include "ganglion/random/normals_avx2.h"
#include "ganglion/units/angle.h"

namespace ganglion {

std::array<std::uint32_t, 4> philox(std::array<std::uint32_t, 4> c, std::array<std::uint32_t, 2> key) noexcept {
  constexpr std::uint64_t kMultiply0 = 0xD2511F53, kMultiply1 = 0xCD9E8D57;
  constexpr std::uint32_t kWeyl0 = 0x9E3779B9, kWeyl1 = 0xBB67AE85;
  for (int round = 0; round < 10; ++round) {
    const std::uint64_t p0 = kMultiply0 * c[0];
    const std::uint64_t p1 = kMultiply1 * c[2];
    c = {static_cast<std::uint32_t>(p1 >> 32) ^ c[1] ^ key[0], static_cast<std::uint32_t>(p1),
         static_cast<std::uint32_t>(p0 >> 32) ^ c[3] ^ key[1], static_cast<std::uint32_t>(p0)};
    key[0] += kWeyl0;
    key[1] += kWeyl1;
  }
  return c;
}

Draws::Draws(const StreamId& stream, std::uint32_t tick) noexcept {
  const std::uint64_t key = combine(stream.seed, stream.component);
  key_ = {static_cast<std::uint32_t>(key), static_cast<std::uint32_t>(key >> 32)};
  counter_ = {0, tick, stream.robot, stream.episode};
}

std::uint64_t Draws::bits() noexcept {
  counter_[0] = draw_++;
  const auto words = philox(counter_, key_);
  return (std::uint64_t{words[1]} << 32) | words[0];
}

double Draws::uniform() noexcept { return static_cast<double>(bits() >> 11) * 0x1.0p-53; }

std::uint32_t Draws::below(std::uint32_t count) noexcept {
  expects(count >= 1);
  return static_cast<std::uint32_t>(((bits() >> 32) * count) >> 32);
}

double Draws::normal() noexcept {
  if (foreseen_ && draw_ == 0) {
    draw_ = 2;
    return first_normal_;
  }
  const double radius = std::sqrt(-2 * math::log(1 - uniform()));
  return radius * math::cos(2 * kPi * uniform());
}

void Draws::foresee_normals(std::span<Draws> fresh) noexcept {
#if defined(__x86_64__)
  static const bool wide = __builtin_cpu_supports("avx2");
  for (std::size_t at = 0; wide && at < fresh.size(); at += kNormalLanes) {
    const std::size_t count = std::min(kNormalLanes, fresh.size() - at);
    NormalLanes lanes;
    for (std::size_t n = 0; n < kNormalLanes; ++n) {  // pads repeat the last
      const Draws& draws = fresh[at + std::min(n, count - 1)];
      for (std::size_t word = 0; word < 2; ++word) lanes.key[word][n] = draws.key_[word];
      for (std::size_t word = 1; word < 4; ++word) lanes.counter[word - 1][n] = draws.counter_[word];
    }
    first_normals_avx2(lanes);
    for (std::size_t n = 0; n < count; ++n) {
      fresh[at + n].first_normal_ = lanes.normal[n];
      fresh[at + n].foreseen_ = true;
    }
  }
#else
  static_cast<void>(fresh);
#endif
}

}  // namespace ganglion
