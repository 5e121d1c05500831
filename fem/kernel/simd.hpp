#pragma once

#include <cstdint>
#include <cstring>

/// Vectors of doubles over cells, for the kernel files alone. Those are each
/// compiled for one instruction set; nothing here may be an inline function
/// of a type shared between them, or the linker could pick the wrong copy.
/// The width is part of every type, and each kernel file has its own width.
namespace rebound::fem {

template <int width>
struct VectorOf {
  typedef double Real __attribute__((vector_size(8 * width)));
  typedef std::uint64_t Integer __attribute__((vector_size(8 * width)));
};

template <class V>
inline V load(const double* p) {
  V v;
  std::memcpy(&v, p, sizeof(V));
  return v;
}

template <class V>
inline void store(double* p, V v) {
  std::memcpy(p, &v, sizeof(V));
}

/// Real vectors only: keeps these functions out of overload resolution for double.
template <class V, int width = sizeof(V) / 8, class = decltype(V{}[0])>
using OnlyVector = V;

/// Is any lane other than zero?
template <class I>
[[gnu::always_inline]] inline bool any_lane(I lanes) {
  constexpr int width = sizeof(I) / 8;
  if constexpr (width == 8)
    return any_lane(__builtin_shufflevector(lanes, lanes, 0, 1, 2, 3) |
                    __builtin_shufflevector(lanes, lanes, 4, 5, 6, 7));
  else if constexpr (width == 4)
    return any_lane(__builtin_shufflevector(lanes, lanes, 0, 1) |
                    __builtin_shufflevector(lanes, lanes, 2, 3));
  else
    return (lanes[0] | lanes[1]) != 0;
}

/// Is `x` above `bound` in any lane?
template <class V>
[[gnu::always_inline]] inline bool any_above(V x, double bound) {
  return any_lane(x > bound);
}

/// Natural logarithm of positive normal numbers.
///
///   x = 2^k m,  m in [√½, √2);   ln x = k ln 2 + 2 artanh((m − 1)/(m + 1))
///
/// Error: below 3 units in the last place (or 1e-16 absolute near x = 1)
///        -> test SimdMath.LogAgainstLibrary
template <class V>
[[gnu::always_inline]] inline OnlyVector<V> log(V x) {
  using Integer = typename VectorOf<sizeof(V) / 8>::Integer;
  Integer bits;
  std::memcpy(&bits, &x, sizeof(V));
  // Shift so that the exponent field changes at √½ instead of 1; the bias
  // keeps it positive, for AVX2 has no arithmetic shift of 64-bit lanes.
  const Integer biased_k = (bits - 0x3fe6a09e667f3bcd + 0x3ff0000000000000) >> 52;
  const Integer mantissa_bits = bits - ((biased_k - 1023) << 52);
  V m;
  std::memcpy(&m, &mantissa_bits, sizeof(V));
  // Exact conversion of a small integer: add it into the mantissa of 2^52.
  const Integer in_mantissa = biased_k + 0x4330000000000000;
  V exponent;
  std::memcpy(&exponent, &in_mantissa, sizeof(V));
  exponent -= 4503599627370496.0 + 1023.0;

  const V s = (m - 1.0) / (m + 1.0);
  const V s2 = s * s;
  // Σ s2^k/(2k+3), k = 0…9, by pairs: short chains instead of one long one.
  const V s4 = s2 * s2;
  const V s8 = s4 * s4;
  const V a = s2 * (1.0 / 5.0) + 1.0 / 3.0;
  const V b = s2 * (1.0 / 9.0) + 1.0 / 7.0;
  const V c = s2 * (1.0 / 13.0) + 1.0 / 11.0;
  const V d = s2 * (1.0 / 17.0) + 1.0 / 15.0;
  const V e = s2 * (1.0 / 21.0) + 1.0 / 19.0;
  const V sum = (e * s8 + (d * s4 + c)) * s8 + (b * s4 + a);
  const V tail = s * s2 * sum;
  return exponent * 0.69314718055994530942 + 2.0 * (s + tail);
}

/// Square root of positive numbers whose reciprocal is normal; of zero, zero.
///
///   y ← y (3/2 − x y²/2) from a linear guess of the exponent;   √x = x y, corrected once
///
/// Error: below 3 units in the last place -> test SimdMath.SqrtAgainstLibrary
template <class V>
inline OnlyVector<V> sqrt(V x) {
  using Integer = typename VectorOf<sizeof(V) / 8>::Integer;
  Integer bits;
  std::memcpy(&bits, &x, sizeof(V));
  bits = 0x5fe6eb50c7b537a9 - (bits >> 1);
  V y;
  std::memcpy(&y, &bits, sizeof(V));
  const V half = 0.5 * x;
  for (int i = 0; i < 4; ++i) y = y * (1.5 - half * y * y);
  const V root = x * y;
  return root + 0.5 * y * (x - root * root);
}

/// One over the cube root of positive normal numbers.
///
///   y ← y (1 + r/3 + 2 r²/9 + 14 r³/81),  r = 1 − x y³, twice, from a guess of a third of
///   the exponent that is within 4 %: what is left of r⁴ is below rounding
///
/// Error: below 3 units in the last place -> test SimdMath.InverseCubeRootAgainstLibrary
template <class V>
inline OnlyVector<V> inverse_cube_root(V x) {
  using Integer = typename VectorOf<sizeof(V) / 8>::Integer;
  Integer bits;
  std::memcpy(&bits, &x, sizeof(V));
  // A third of the upper half by way of doubles: integers of vectors have no division.
  const Integer in_mantissa = (bits >> 32) + 0x4330000000000000;
  V upper;
  std::memcpy(&upper, &in_mantissa, sizeof(V));
  const V third = (4503599627370496.0 + 1430188287.0) - (upper - 4503599627370496.0) * (1.0 / 3.0);
  std::memcpy(&bits, &third, sizeof(V));
  bits <<= 32;
  V y;
  std::memcpy(&y, &bits, sizeof(V));
  for (int i = 0; i < 2; ++i) {
    const V r = 1.0 - x * y * y * y;
    y += y * r * (1.0 / 3.0 + r * (2.0 / 9.0 + r * (14.0 / 81.0)));
  }
  return y;
}

/// The same of 1 + t, |t| ≤ 0.2, in half the time: one step of y ← y (1 − r)^(-1/3) to r⁴, from the
/// series in t to t³.
///
/// Error: below 3 units in the last place -> test SimdMath.InverseCubeRootAgainstLibrary
template <class V>
[[gnu::always_inline]] inline OnlyVector<V> inverse_cube_root_near_one(V t) {
  const V t2 = t * t;
  const V y = (1.0 - t * (1.0 / 3.0)) + t2 * (2.0 / 9.0 - t * (14.0 / 81.0));
  const V r = 1.0 - (y * y) * (y + t * y);
  const V r2 = r * r;
  return y + y * (r * (1.0 / 3.0 + r * (2.0 / 9.0)) + r2 * r * (14.0 / 81.0 + r * (35.0 / 243.0)));
}

/// Exponential for |x| < 700.
///
///   x = k ln 2 + r, |r| ≤ ½ ln 2;   eˣ = 2^k Σ rⁿ/n!
///
/// Error: below 3 units in the last place -> test SimdMath.ExpAgainstLibrary
template <class V>
[[gnu::always_inline]] inline OnlyVector<V> exp(V x) {
  using Integer = typename VectorOf<sizeof(V) / 8>::Integer;
  constexpr double rounding = 6755399441055744.0;  // 1.5·2^52: rounds to integer
  const V shifted = x * 1.44269504088896340736 + rounding;
  const V k = shifted - rounding;
  V r = x - k * 6.93147180369123816490e-01;
  r -= k * 1.90821492927058770002e-10;
  // Σ rⁿ/(n+2)!, n = 0…11, by pairs: short chains instead of one long one.
  const V r2 = r * r;
  const V r4 = r2 * r2;
  const V a = r * (1.0 / 6.0) + 0.5;
  const V b = r * (1.0 / 120.0) + 1.0 / 24.0;
  const V c = r * (1.0 / 5040.0) + 1.0 / 720.0;
  const V d = r * (1.0 / 362880.0) + 1.0 / 40320.0;
  const V e = r * (1.0 / 39916800.0) + 1.0 / 3628800.0;
  const V f = r * (1.0 / 6227020800.0) + 1.0 / 479001600.0;
  const V high = (f * r2 + e) * r4 + (d * r2 + c);
  const V sum = (high * r4 + (b * r2 + a)) * r2 + r + 1.0;
  Integer k_bits;
  std::memcpy(&k_bits, &shifted, sizeof(V));
  const Integer scale_bits = (k_bits << 52) + 0x3ff0000000000000;
  V scale;
  std::memcpy(&scale, &scale_bits, sizeof(V));
  return sum * scale;
}

}  // namespace rebound::fem
