// SPDX-License-Identifier: MIT
#include "core/base/math.hpp"

#include "core/base/assert.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace mirocup {

namespace {

// pi/2 and ln 2 as sums of pieces (Cody and Waite). The first pieces end in zero bits, so small
// multiples of them are exact and the reduced argument loses nothing to cancellation.
constexpr double half_pi_1 = 0x1.921fb544p+0;
constexpr double half_pi_2 = 0x1.0b4611a6p-34;
constexpr double half_pi_3 = 0x1.3198a2e037073p-69;
constexpr double ln2_1 = 0x1.62e42feep-1;
constexpr double ln2_2 = 0x1.a39ef35793c76p-33;

constexpr int sine_terms = 9;         // x^19/19! < 1e-19 for |x| <= pi/4
constexpr int cosine_terms = 9;       // x^18/18!
constexpr int exp_terms = 14;         // x^15/15! < 1e-19 for |x| <= ln(2)/2
constexpr int arctangent_terms = 11;  // x^12/13 < 1e-19 for |x| <= 1/32

// atan(k/16) for k = 0 .. 16.
constexpr std::array<double, 17> arctangent_of_sixteenths{0x0.0p+0,
                                                          0x1.ff55bb72cfdeap-5,
                                                          0x1.fd5ba9aac2f6ep-4,
                                                          0x1.7b97b4bce5b02p-3,
                                                          0x1.f5b75f92c80ddp-3,
                                                          0x1.362773707ebccp-2,
                                                          0x1.6f61941e4def1p-2,
                                                          0x1.a64eec3cc23fdp-2,
                                                          0x1.dac670561bb4fp-2,
                                                          0x1.0657e94db30d0p-1,
                                                          0x1.1e00babdefeb4p-1,
                                                          0x1.345f01cce37bbp-1,
                                                          0x1.4978fa3269ee1p-1,
                                                          0x1.5d58987169b18p-1,
                                                          0x1.700a7c5784634p-1,
                                                          0x1.819d0b7158a4dp-1,
                                                          0x1.921fb54442d18p-1};

// 1/k! for k = 0 .. 19.
constexpr auto inverse_factorial = [] {
  std::array<double, 20> table{};
  double factorial = 1.0;  // exact up to 18!, and 19! < 2^57 is a multiple of 2^16
  table[0] = 1.0;
  for (int k = 1; k < 20; ++k) {
    factorial *= k;
    table[k] = 1.0 / factorial;
  }
  return table;
}();

// Returns (sin(x)/x - 1)/z and (cos(x) - 1 + z/2)/z^2 for the squares z of n angles |x| <= pi/4.
// The loops over i are written so that a compiler can vectorise them.
template <std::size_t n>
struct Tails {
  std::array<double, n> sin{};
  std::array<double, n> cos{};
};
template <std::size_t n>
Tails<n> tails(const std::array<double, n>& z) {
  Tails<n> t;
  for (int k = sine_terms; k >= 1; --k) {
    const double term = k % 2 ? -inverse_factorial[2 * k + 1] : inverse_factorial[2 * k + 1];
    for (std::size_t i = 0; i < n; ++i) t.sin[i] = t.sin[i] * z[i] + term;
  }
  for (int k = cosine_terms; k >= 2; --k) {
    const double term = k % 2 ? -inverse_factorial[2 * k] : inverse_factorial[2 * k];
    for (std::size_t i = 0; i < n; ++i) t.cos[i] = t.cos[i] * z[i] + term;
  }
  return t;
}

// Returns sine and cosine of x + low for |x| <= pi/4, where `low` is the part of the angle that the
// double x cannot hold.
SinCos kernel(double x, double low) {
  const double z = x * x;
  const Tails<1> tail = tails<1>({z});
  const double s = tail.sin[0];
  const double c = tail.cos[0];
  const double half = 0.5 * z;
  const double one_minus_half = 1.0 - half;
  // Adds the bits that 1 - z/2 dropped, and `low` times the derivative.
  const double cosine = one_minus_half + (((1.0 - one_minus_half) - half) + (z * z * c - x * low));
  return {x + (x * z * s + low * (1.0 - half)), cosine};
}

// Returns e^r - 1 for |r| <= ln(2)/2.
double expm1_kernel(double r) {
  double p = 0.0;
  for (int k = exp_terms; k >= 2; --k) p = p * r + inverse_factorial[k];
  return r + r * r * p;
}

// Returns 2^k for -1022 <= k <= 1023.
double power_of_two(int k) {
  return std::bit_cast<double>(static_cast<std::uint64_t>(k + 1023) << 52);
}

}  // namespace

SinCos sincos(double x) {
  if (std::abs(x) <= small_angle) return kernel(x, 0.0);

  const double turns = std::nearbyint(x * (2.0 / pi));
  const double a = x - turns * half_pi_1;
  const double b = turns * half_pi_2;
  const double high = a - b;
  const double low = ((a - high) - b) - turns * half_pi_3;
  const double reduced = high + low;
  const SinCos r = kernel(reduced, (high - reduced) + low);

  switch (static_cast<std::int64_t>(turns) & 3) {
    case 0:
      return r;
    case 1:
      return {r.cos, -r.sin};
    case 2:
      return {-r.sin, -r.cos};
    default:
      return {-r.cos, r.sin};
  }
}

// The same operations as kernel() with low = 0, arranged so that a compiler can vectorise them.
SinCosOfSome sincos_of_small(const std::array<double, angles_at_once>& x) {
  std::array<double, angles_at_once> z;
  for (int i = 0; i < angles_at_once; ++i) {
    MIROCUP_ASSERT(std::abs(x[i]) <= small_angle);
    z[i] = x[i] * x[i];
  }
  const auto tail = tails(z);
  SinCosOfSome some;
  for (int i = 0; i < angles_at_once; ++i) {
    const double half = 0.5 * z[i];
    const double one_minus_half = 1.0 - half;
    some.sin[i] = x[i] + x[i] * z[i] * tail.sin[i];
    some.cos[i] = one_minus_half + (((1.0 - one_minus_half) - half) + z[i] * z[i] * tail.cos[i]);
  }
  return some;
}

double exp(double x) {
  if (!(x < 709.8)) return x == x ? HUGE_VAL : x;
  if (x < -745.2) return 0.0;
  const double k = std::nearbyint(x * (1.0 / (ln2_1 + ln2_2)));
  const double reduced = (x - k * ln2_1) - k * ln2_2;
  const double value = 1.0 + expm1_kernel(reduced);
  const int exponent = static_cast<int>(k);
  if (exponent > 1023) return value * power_of_two(1023) * power_of_two(exponent - 1023);
  if (exponent < -1022) return value * power_of_two(-1022) * power_of_two(exponent + 1022);
  return value * power_of_two(exponent);
}

double expm1(double x) {
  return std::abs(x) <= 0.34657359027997264 ? expm1_kernel(x) : exp(x) - 1.0;
}

double log1p(double x) {
  MIROCUP_ASSERT(x > -1.0);
  // ln(1 + x) = 2 artanh(x / (2 + x)). Larger arguments are reduced first by exact halvings of 1 +
  // x.
  double extra = 0.0;
  if (std::abs(x) > 0.25) {
    int exponent = 0;
    const double mantissa = std::frexp(1.0 + x, &exponent);  // exact
    extra = exponent * (ln2_1 + ln2_2);
    x = mantissa - 1.0;
    if (x < -0.3) {
      x = 2.0 * mantissa - 1.0;
      extra = (exponent - 1) * (ln2_1 + ln2_2);
    }
  }
  const double z = x / (2.0 + x);
  const double w = z * z;
  double sum = 0.0;
  for (int k = 25; k >= 3; k -= 2) sum = sum * w + 1.0 / k;
  return extra + 2.0 * (z + z * w * sum);
}

double atan2(double y, double x) {
  if (x == 0.0 && y == 0.0) return 0.0;
  // Reduces the angle to an octant, then by the nearest sixteenth: atan(t) = atan(c) + atan(r).
  const double ax = std::abs(x);
  const double ay = std::abs(y);
  const bool steep = ay > ax;
  const double longer = steep ? ay : ax;
  const double shorter = steep ? ax : ay;
  const double t = shorter / longer;
  if (!(t <= 1.0)) return t;  // not a number
  const int nearest = static_cast<int>(16.0 * t + 0.5);
  const double c = nearest / 16.0;
  const double r = (shorter - c * longer) / (longer + c * shorter);
  const double z = r * r;
  double sum = 0.0;
  for (int k = arctangent_terms; k >= 3; k -= 2) {
    sum = ((k / 2) % 2 ? -1.0 / k : 1.0 / k) + sum * z;
  }
  double angle = arctangent_of_sixteenths[nearest] + (r + r * z * sum);
  if (steep) angle = 0.5 * pi - angle;
  if (x < 0.0) angle = pi - angle;
  return y < 0.0 ? -angle : angle;
}

}  // namespace mirocup
