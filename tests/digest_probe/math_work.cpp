#include <cmath>
#include <limits>
#include <vector>

#include "ganglion/base/hash.h"
#include "ganglion/geometry/pose2.h"
#include "ganglion/math/functions.h"
#include "ganglion/random/draws.h"
#include "tests/digest_probe/work.h"

namespace ganglion::probe {
namespace {

using Function = double (*)(double);
using Function2 = double (*)(double, double);

/// Both signs of: steps over a few turns, powers of two from the smallest to the largest, multiples of pi / 2 far out,
/// and the values that are none.
std::vector<double> arguments() {
  std::vector<double> list = {
      0, 1e300, 1e22, 0x1p-1074, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()};
  for (int i = 1; i <= 400; ++i) list.push_back(i * 0.0173);
  for (int i = -1000; i <= 1000; i += 50) list.push_back(std::ldexp(1.1, i));
  for (int i = 1; i <= 40; ++i) list.push_back(i * 1e3 * kPi / 2);
  const std::size_t positive = list.size();
  for (std::size_t i = 0; i < positive; ++i) list.push_back(-list[i]);
  return list;
}

/// `volatile` keeps compilers from working out at compile time what processors are asked for.
double opaque(double value) {
  const volatile double kept = value;
  return kept;
}

void probe_one(std::string_view name, Function function) {
  std::uint64_t hash = 0;
  for (const double x : arguments()) hash = combine(hash, canonical_bits(function(opaque(x))));
  tell(name, hash);
}

void probe_two(std::string_view name, Function2 function) {
  std::uint64_t hash = 0;
  const std::vector<double> list = arguments();
  for (std::size_t i = 0; i < list.size(); ++i) {
    for (std::size_t j = i % 7; j < list.size(); j += 7) {
      hash = combine(hash, canonical_bits(function(opaque(list[i]), opaque(list[j]))));
    }
  }
  tell(name, hash);
}

}  // namespace

void probe_math() {
  probe_one("math sin", math::sin);
  probe_one("math cos", math::cos);
  probe_one("math tan", math::tan);
  probe_one("math asin", math::asin);
  probe_one("math acos", math::acos);
  probe_one("math exp", math::exp);
  probe_one("math log", math::log);
  probe_one("math sincos", [](double x) {
    const math::SinCos both = math::sincos(x);
    return both.sin * 3 + both.cos;  // a sum of a product: the place where fused multiply-add would show
  });
  probe_one("std sqrt", [](double x) { return std::sqrt(x); });
  probe_one("angle wrapped", [](double x) { return Angle::from_rad(x).wrapped().rad(); });
  probe_two("math atan2", math::atan2);
  probe_two("math pow", math::pow);
  probe_two("math hypot", math::hypot);
  probe_two("std fmod", [](double x, double y) { return std::fmod(x, y); });
}

void probe_draws() {
  std::uint64_t bits = 0, uniform = 0, below = 0, normal = 0;
  for (std::uint32_t tick = 0; tick < 2000; ++tick) {
    const StreamId stream{.seed = tick % 5, .episode = tick % 3, .robot = tick % 4, .component = hash_name("sonar")};
    Draws draws(stream, tick);
    bits = combine(bits, draws.bits());
    uniform = combine(uniform, canonical_bits(draws.uniform(-1, 2)));
    below = combine(below, draws.below(tick + 1));
    normal = combine(normal, canonical_bits(draws.normal()));
  }
  tell("draws bits", bits);
  tell("draws uniform", uniform);
  tell("draws below", below);
  tell("draws normal", normal);
}

}  // namespace ganglion::probe
