// Four normals side by side: AVX2. SLEEF's "cinz" forms give the same bits at any width; no fused products.
#if defined(__x86_64__)
#include "ganglion/random/normals_avx2.h"

#include <immintrin.h>
#include <sleef.h>

#include "ganglion/units/angle.h"

namespace ganglion {
namespace {

using Words = __m256i;

Words load(const std::uint64_t* from) noexcept { return _mm256_load_si256(reinterpret_cast<const Words*>(from)); }
Words all(std::uint64_t value) noexcept { return _mm256_set1_epi64x(static_cast<long long>(value)); }

/// philox() of draws.h, in the low halves of the lanes; high halves are of no account on the way. Gives the first two
/// words as one number.
Words philox_bits(std::uint64_t draw, const NormalLanes& lanes) noexcept {
  Words c0 = all(draw), c1 = load(lanes.counter[0]), c2 = load(lanes.counter[1]), c3 = load(lanes.counter[2]);
  Words key0 = load(lanes.key[0]), key1 = load(lanes.key[1]);
  const Words multiply0 = all(0xD2511F53), multiply1 = all(0xCD9E8D57);
  const Words weyl0 = all(0x9E3779B9), weyl1 = all(0xBB67AE85);
  for (int round = 0; round < 10; ++round) {
    const Words p0 = _mm256_mul_epu32(multiply0, c0), p1 = _mm256_mul_epu32(multiply1, c2);
    c0 = _mm256_xor_si256(_mm256_xor_si256(_mm256_srli_epi64(p1, 32), c1), key0);
    c2 = _mm256_xor_si256(_mm256_xor_si256(_mm256_srli_epi64(p0, 32), c3), key1);
    c1 = p1;
    c3 = p0;
    key0 = _mm256_add_epi32(key0, weyl0);
    key1 = _mm256_add_epi32(key1, weyl1);
  }
  return _mm256_or_si256(_mm256_slli_epi64(c1, 32), _mm256_and_si256(c0, all(0xFFFFFFFF)));
}

/// Draws::uniform(): both halves of the upper 53 bits become exact doubles by way of the bits of 2^52.
__m256d uniform(Words bits) noexcept {
  const Words upper = _mm256_srli_epi64(bits, 43);
  const Words lower = _mm256_and_si256(_mm256_srli_epi64(bits, 11), all(0xFFFFFFFF));
  const __m256d two52 = _mm256_set1_pd(0x1p52);
  auto exact = [&](Words whole) {
    return _mm256_sub_pd(_mm256_castsi256_pd(_mm256_or_si256(whole, _mm256_castpd_si256(two52))), two52);
  };
  const __m256d whole = _mm256_add_pd(_mm256_mul_pd(exact(upper), _mm256_set1_pd(0x1p32)), exact(lower));
  return _mm256_mul_pd(whole, _mm256_set1_pd(0x1p-53));
}

}  // namespace

void first_normals_avx2(NormalLanes& lanes) noexcept {
  const __m256d first = uniform(philox_bits(0, lanes)), second = uniform(philox_bits(1, lanes));
  const __m256d logarithm = Sleef_cinz_logd4_u10avx(_mm256_sub_pd(_mm256_set1_pd(1), first));
  const __m256d radius = _mm256_sqrt_pd(_mm256_mul_pd(_mm256_set1_pd(-2), logarithm));
  const __m256d cosine = Sleef_cinz_cosd4_u10avx(_mm256_mul_pd(_mm256_set1_pd(2 * kPi), second));
  _mm256_store_pd(lanes.normal, _mm256_mul_pd(radius, cosine));
}

}  // namespace ganglion
#endif
