// Internal: the sums over a point set that a differentiable support function is made of, four points at a time.
// Compiled apart for AVX2, and from nothing that other translation units instantiate too: such code must not end up
// where the processor has none.
#pragma once

#include <cstddef>
#include <cstdint>
#include <numbers>

namespace dgd_test::dsf_internal {

/// Points whose offsets from the inner point are summed at once: the coordinates of each block's are x, x, x, x, y, y,
/// y, y, z, z, z, z. Padding is the offset 0.
inline constexpr std::size_t kLanes = 4;
inline constexpr std::size_t kBlock = 3 * kLanes;

/// What is summed.
struct Powers {
  double exponent;      ///< p > 2, finite.
  std::uint32_t whole;  ///< p - 2 if that is a whole number, else 0.
  double least_part;    ///< Heights below this part of the highest one are left out.
};

/// Sums of the heights of offsets w_j along a direction, as parts r_j of the highest one's, w_0: over those with r_j >
/// 0, of u_j = w_j - r_j w_0, which is across the direction.
struct Sums {
  double highest = 0;     ///< Height of w_0; if not positive, or NaN, the rest is as it was.
  double top[3] = {};     ///< w_0.
  double powers = 0;      ///< Sum of r_j^p.
  double offset[3] = {};  ///< Sum of r_j^(p-1) u_j.
  double spread[6] = {};  ///< Sum of r_j^(p-2) u_j u_j^T: xx, xy, xz, yy, yz, zz; 0 without `with_spread`.
};

/// @param offsets      `blocks` of them; no alignment needed.
/// @param direction    Three coordinates, the largest of which is 1 by its absolute value.
/// Each operation is rounded, and all versions give the same bits.
using SumKernel = void (*)(const double* offsets, std::size_t blocks, const double* direction, const Powers& powers,
                           bool with_spread, Sums& sums);
/// The same for processors that have AVX2.
void SumAvx2(const double* offsets, std::size_t blocks, const double* direction, const Powers& powers, bool with_spread,
             Sums& sums);
/// Whether this processor, and the system on it, can run AVX2.
bool HasAvx2();

namespace {

// Vectors that are wider than the processor's are split by the compiler. They do not leave this file.
using Lanes __attribute__((vector_size(8 * kLanes))) = double;
using LaneBits __attribute__((vector_size(8 * kLanes))) = std::uint64_t;
using LoadLanes __attribute__((vector_size(8 * kLanes), aligned(alignof(double)), may_alias)) = double;

inline Lanes Load(const double* from) { return *reinterpret_cast<const LoadLanes*>(from); }
inline Lanes Broadcast(double value) { return value - Lanes{}; }
inline LaneBits BitsOf(const Lanes& lanes) { return reinterpret_cast<LaneBits>(lanes); }
inline Lanes FromBits(const LaneBits& bits) { return reinterpret_cast<Lanes>(bits); }
/// The pairwise sum.
inline double SumOf(const Lanes& lanes) { return (lanes[0] + lanes[1]) + (lanes[2] + lanes[3]); }

/// The sum of c_i x^i, by halves (Estrin): Horner's chain would have each operation wait for the last.
template <std::size_t N, class Coefficient>
inline Lanes Polynomial(const Coefficient (&c)[N], const Lanes& x) {
  if constexpr (N == 1) {
    return c[0];
  } else {
    Lanes half[(N + 1) / 2];
    for (std::size_t i = 0; i < N / 2; ++i) half[i] = c[2 * i] + c[2 * i + 1] * x;
    if constexpr (N % 2 == 1) half[N / 2] = c[N - 1] - Lanes{};
    return Polynomial(half, x * x);
  }
}

/// Adding it to a number leaves that, rounded, in the sum's last bits: AVX2 has no conversion to 64-bit integers.
constexpr double kWhole = 0x1.8p52;

/// Logarithm to base 2 of normal positive numbers: off by a last digit of it, or of 1.
inline Lanes Log2(const Lanes& x) {
  // x = 2^e m, m within sqrt(2) of 1: the exponent of x / sqrt(1/2) is e.
  constexpr std::uint64_t kBias = 1023, kSqrtHalf = 0x3fe6a09e667f3bcd;
  const LaneBits biased = (BitsOf(x) - kSqrtHalf + (kBias << 52)) >> 52;
  const Lanes m = FromBits(BitsOf(x) - (biased << 52) + (kBias << 52));
  const Lanes e = FromBits(BitsOf(Broadcast(kWhole)) + biased) - (kWhole + double(kBias));
  // log2(m) = 2 atanh(s) / ln 2 with s = (m - 1) / (m + 1), s^2 < 0.03.
  constexpr double k = 2 / std::numbers::ln2;
  constexpr double kSeries[] = {k, k / 3, k / 5, k / 7, k / 9, k / 11, k / 13, k / 15, k / 17, k / 19, k / 21};
  const Lanes s = (m - 1) / (m + 1);
  return e + s * Polynomial(kSeries, s * s);
}

/// 2^x for |x| < 1000.
inline Lanes Exp2(const Lanes& x) {
  const Lanes rounded = x + kWhole;
  const Lanes f = (x - (rounded - kWhole)) * std::numbers::ln2;
  constexpr double kSeries[] = {
      1.0,        1.0,         1.0 / 2,      1.0 / 6,       1.0 / 24,       1.0 / 120,       1.0 / 720,
      1.0 / 5040, 1.0 / 40320, 1.0 / 362880, 1.0 / 3628800, 1.0 / 39916800, 1.0 / 479001600, 1.0 / 6227020800};
  return FromBits(BitsOf(Polynomial(kSeries, f)) + (BitsOf(rounded) << 52));
}

/// x^n for n > 0, by squares: half of the time of an exponential of a logarithm.
inline Lanes WholePower(Lanes x, std::uint32_t n) {
  Lanes power = Broadcast(1);
  for (;; x *= x) {
    if ((n & 1) != 0) power *= x;
    n >>= 1;
    if (n == 0) return power;
  }
}

/// Finds the highest offset, and the first of several.
inline void FindTop(const double* offsets, std::size_t blocks, const double* direction, Sums& sums) {
  const double x = direction[0], y = direction[1], z = direction[2];
  Lanes highest{}, place{}, block{};
  for (std::size_t i = 0; i < blocks; ++i, block = block + 1) {
    const double* at = offsets + i * kBlock;
    const Lanes height = Load(at) * x + Load(at + kLanes) * y + Load(at + 2 * kLanes) * z;
    place = height > highest ? block : place;
    highest = height > highest ? height : highest;
  }
  std::size_t lane = 0;
  for (std::size_t i = 1; i < kLanes; ++i) {
    if (highest[i] > highest[lane] || (highest[i] == highest[lane] && place[i] < place[lane])) lane = i;
  }
  sums.highest = highest[lane];
  const double* top = offsets + static_cast<std::size_t>(place[lane]) * kBlock + lane;
  for (std::size_t i = 0; i < 3; ++i) sums.top[i] = top[i * kLanes];
}

template <bool kWithSpread>
inline void SumAll(const double* offsets, std::size_t blocks, const double* direction, const Powers& powers,
                   Sums& sums) {
  FindTop(offsets, blocks, direction, sums);
  if (!(sums.highest > 0)) return;
  const double inverse = 1 / sums.highest;
  const double x = direction[0] * inverse, y = direction[1] * inverse, z = direction[2] * inverse;
  const Lanes least = Broadcast(powers.least_part);
  Lanes total{}, offset[3] = {}, spread[6] = {};
  for (std::size_t i = 0; i < blocks; ++i) {
    const double* at = offsets + i * kBlock;
    const Lanes w[3] = {Load(at), Load(at + kLanes), Load(at + 2 * kLanes)};
    const Lanes part = w[0] * x + w[1] * y + w[2] * z;
    const LaneBits counts = reinterpret_cast<LaneBits>(part > least);
    if ((counts[0] | counts[1] | counts[2] | counts[3]) == 0) continue;
    const Lanes r = part > least ? part : least;
    const Lanes power = powers.whole > 0 ? WholePower(r, powers.whole) : Exp2(Log2(r) * (powers.exponent - 2));
    const Lanes weight = FromBits(BitsOf(power) & counts);
    const Lanes first = weight * r;
    total += first * r;
    Lanes u[3];
    for (std::size_t k = 0; k < 3; ++k) {
      u[k] = w[k] - r * sums.top[k];
      offset[k] += first * u[k];
    }
    if constexpr (kWithSpread) {
      const Lanes weighted[3] = {weight * u[0], weight * u[1], weight * u[2]};
      spread[0] += weighted[0] * u[0];
      spread[1] += weighted[0] * u[1];
      spread[2] += weighted[0] * u[2];
      spread[3] += weighted[1] * u[1];
      spread[4] += weighted[1] * u[2];
      spread[5] += weighted[2] * u[2];
    }
  }
  sums.powers = SumOf(total);
  for (std::size_t k = 0; k < 3; ++k) sums.offset[k] = SumOf(offset[k]);
  if constexpr (kWithSpread) {
    for (std::size_t k = 0; k < 6; ++k) sums.spread[k] = SumOf(spread[k]);
  }
}

inline void Sum(const double* offsets, std::size_t blocks, const double* direction, const Powers& powers,
                bool with_spread, Sums& sums) {
  if (with_spread) {
    SumAll<true>(offsets, blocks, direction, powers, sums);
  } else {
    SumAll<false>(offsets, blocks, direction, powers, sums);
  }
}

}  // namespace
}  // namespace dgd_test::dsf_internal
