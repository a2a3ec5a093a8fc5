/* SPDX-License-Identifier: MIT
 *
 * Sine, cosine, arctangent, exponential and their family, with the same bits on every system.
 *
 * The sin() of two C libraries can differ in the last bit of a result. Then a team that compares
 * two nearly equal numbers may decide differently on the host's computer and on yours, and the host
 * cannot play your leg again. These functions use only + - * / and sqrt(), which IEEE 754 fixes to
 * the last bit. The simulator also uses these functions. fabs(), fmod(), remainder(), floor(),
 * round() and sqrt() of the C library are exact and need no replacement; remainder(angle, 2 *
 * MIROCUP_PI) is the same angle in [-pi, pi].
 *
 * In C the names begin with mirocup_; in C++ use math::sin(x) and its neighbours of elementary.hpp;
 * in Python `from mirocup.team import sin`. Compile with -ffp-contract=off, as `mirocup compile`
 * and the CMake target mirocup::strategy do, and without -ffast-math.
 *
 * Angles are in radians. A result is NaN if an argument is NaN or outside of the function's domain.
 * A test measures these largest errors against arithmetic with 64-bit mantissas, in units in the
 * last place (ulp) of the result:
 *
 *   exp                                       1
 *   sin, cos of |x| <= 1000                   1; for results below 0.01, 1 ulp of the number 0.01
 *   sin, cos of |x| > 1000                    as if x were wrong by 1 ulp
 *   hypot                                     1.5
 *   expm1, log, log1p, atan2, tan             5
 *   asin, acos                                8; near 0 and near pi, 8 ulp of the number 0.01
 *
 * All functions are pure and inline, and need only -lm. The header is C11 and C++.
 */
#ifndef MIROCUP_ELEMENTARY_H
#define MIROCUP_ELEMENTARY_H

#include <math.h>
#include <stdint.h>
#include <string.h>

#define MIROCUP_PI 3.14159265358979323846

/* The longer functions are not inlined, because inlining would make a team with many calls slow to
 * compile. */
#if defined(__GNUC__)
#define MIROCUP_CALLED static __attribute__((noinline, unused))
#else
#define MIROCUP_CALLED static inline
#endif

typedef struct mirocup_sine_cosine {
  double sine, cosine;
} mirocup_sine_cosine;

/* ln 2 as a sum of two pieces (Cody and Waite). The first piece ends in zero bits, so its small
 * multiples are exact and a reduced argument loses nothing to cancellation. */
#define MIROCUP_LN2_HIGH 0x1.62e42feep-1
#define MIROCUP_LN2_LOW 0x1.a39ef35793c76p-33

/* Returns (sin(x)/x - 1)/z for z = x^2 and |x| <= pi/4: Taylor's series to x^19/19!. */
static inline double mirocup_sine_tail(double z) {
  double s = -1.0 / 121645100408832000.0;
  s = s * z + 1.0 / 355687428096000.0;
  s = s * z - 1.0 / 1307674368000.0;
  s = s * z + 1.0 / 6227020800.0;
  s = s * z - 1.0 / 39916800.0;
  s = s * z + 1.0 / 362880.0;
  s = s * z - 1.0 / 5040.0;
  s = s * z + 1.0 / 120.0;
  return s * z - 1.0 / 6.0;
}

/* Returns (cos(x) - 1 + z/2)/z^2 for z = x^2 and |x| <= pi/4: Taylor's series to x^18/18!. */
static inline double mirocup_cosine_tail(double z) {
  double c = -1.0 / 6402373705728000.0;
  c = c * z + 1.0 / 20922789888000.0;
  c = c * z - 1.0 / 87178291200.0;
  c = c * z + 1.0 / 479001600.0;
  c = c * z - 1.0 / 3628800.0;
  c = c * z + 1.0 / 40320.0;
  c = c * z - 1.0 / 720.0;
  return c * z + 1.0 / 24.0;
}

/* Returns sine and cosine of x + low for |x| <= pi/4; `low` is the part of the angle that the
 * double x cannot hold. */
static inline mirocup_sine_cosine mirocup_sincos_octant(double x, double low) {
  const double z = x * x;
  const double half = 0.5 * z;
  const double one_minus_half = 1.0 - half;
  mirocup_sine_cosine r;
  r.sine = x + (x * z * mirocup_sine_tail(z) + low * (1.0 - half));
  /* Adds the bits that 1 - z/2 dropped, and `low` times the derivative. */
  r.cosine = one_minus_half +
             (((1.0 - one_minus_half) - half) + (z * z * mirocup_cosine_tail(z) - x * low));
  return r;
}

MIROCUP_CALLED mirocup_sine_cosine mirocup_sincos(double x) {
  /* pi/2 as a sum of pieces (Cody and Waite). */
  const double half_pi_1 = 0x1.921fb544p+0;
  const double half_pi_2 = 0x1.0b4611a6p-34;
  const double half_pi_3 = 0x1.3198a2e037073p-69;
  double turns, a, b, high, low, reduced;
  mirocup_sine_cosine r, turned;
  if (fabs(x) <= 0.25 * MIROCUP_PI) return mirocup_sincos_octant(x, 0.0);
  if (!(fabs(x) <= 1000.0)) {
    x = remainder(x, 2.0 * MIROCUP_PI);
    if (x != x) {
      turned.sine = turned.cosine = x;
      return turned;
    }
  }
  turns = nearbyint(x * (2.0 / MIROCUP_PI));
  a = x - turns * half_pi_1;
  b = turns * half_pi_2;
  high = a - b;
  low = ((a - high) - b) - turns * half_pi_3;
  reduced = high + low;
  r = mirocup_sincos_octant(reduced, (high - reduced) + low);
  turned = r;
  switch ((int)turns & 3) {
    case 0:
      break;
    case 1:
      turned.sine = r.cosine;
      turned.cosine = -r.sine;
      break;
    case 2:
      turned.sine = -r.sine;
      turned.cosine = -r.cosine;
      break;
    default:
      turned.sine = -r.cosine;
      turned.cosine = r.sine;
  }
  return turned;
}

static inline double mirocup_sin(double x) {
  return mirocup_sincos(x).sine;
}
static inline double mirocup_cos(double x) {
  return mirocup_sincos(x).cosine;
}
static inline double mirocup_tan(double x) {
  const mirocup_sine_cosine r = mirocup_sincos(x);
  return r.sine / r.cosine;
}

/* Returns the angle of (x, y) in (-pi, pi], counter-clockwise from +x; 0 for the null vector. A y
 * of -0.0 counts as 0.0. Precondition: x and y are finite. */
MIROCUP_CALLED double mirocup_atan2(double y, double x) {
  /* atan(k/16) for k = 0 .. 16. */
  static const double of_sixteenths[17] = {0x0.0p+0,
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
  /* The angle is reduced to an octant. Then c is the multiple of 1/16 nearest to t, and
     atan(t) = atan(c) + atan(r). */
  const double ax = fabs(x), ay = fabs(y);
  const double longer = ay > ax ? ay : ax;
  const double shorter = ay > ax ? ax : ay;
  const double t = shorter / longer;
  double c, r, z, sum, angle;
  int nearest;
  if (x == 0.0 && y == 0.0) return 0.0;
  if (!(t <= 1.0)) return t; /* not a number */
  nearest = (int)(16.0 * t + 0.5);
  c = nearest / 16.0;
  r = (shorter - c * longer) / (longer + c * shorter);
  z = r * r; /* r^12/13 < 1e-19 for |r| <= 1/32 */
  sum = -1.0 / 11.0;
  sum = 1.0 / 9.0 + sum * z;
  sum = -1.0 / 7.0 + sum * z;
  sum = 1.0 / 5.0 + sum * z;
  sum = -1.0 / 3.0 + sum * z;
  angle = of_sixteenths[nearest] + (r + r * z * sum);
  if (ay > ax) angle = 0.5 * MIROCUP_PI - angle;
  if (x < 0.0) angle = MIROCUP_PI - angle;
  return y < 0.0 ? -angle : angle;
}

static inline double mirocup_atan(double x) {
  return mirocup_atan2(x, 1.0);
}
static inline double mirocup_asin(double x) {
  return mirocup_atan2(x, sqrt((1.0 - x) * (1.0 + x)));
}
static inline double mirocup_acos(double x) {
  return mirocup_atan2(sqrt((1.0 - x) * (1.0 + x)), x);
}

/* Returns the length of (x, y); infinity if the square of x or y is infinite (above 1e154). */
static inline double mirocup_hypot(double x, double y) {
  return sqrt(x * x + y * y);
}

/* Returns e^r - 1 for |r| <= ln(2)/2: Taylor's series, r^15/15! < 1e-19. */
static inline double mirocup_expm1_series(double r) {
  double p = 1.0 / 87178291200.0;
  p = p * r + 1.0 / 6227020800.0;
  p = p * r + 1.0 / 479001600.0;
  p = p * r + 1.0 / 39916800.0;
  p = p * r + 1.0 / 3628800.0;
  p = p * r + 1.0 / 362880.0;
  p = p * r + 1.0 / 40320.0;
  p = p * r + 1.0 / 5040.0;
  p = p * r + 1.0 / 720.0;
  p = p * r + 1.0 / 120.0;
  p = p * r + 1.0 / 24.0;
  p = p * r + 1.0 / 6.0;
  p = p * r + 1.0 / 2.0;
  return r + r * r * p;
}

/* Returns 2^k for -1022 <= k <= 1023. */
static inline double mirocup_power_of_two(int k) {
  const uint64_t bits = (uint64_t)(k + 1023) << 52;
  double power;
  memcpy(&power, &bits, sizeof power);
  return power;
}

/* Returns e^x: infinity above 709.8, 0 below -745.2. */
MIROCUP_CALLED double mirocup_exp(double x) {
  double k, value;
  int exponent;
  if (!(x < 709.8)) return x == x ? HUGE_VAL : x;
  if (x < -745.2) return 0.0;
  k = nearbyint(x * (1.0 / (MIROCUP_LN2_HIGH + MIROCUP_LN2_LOW)));
  value = 1.0 + mirocup_expm1_series((x - k * MIROCUP_LN2_HIGH) - k * MIROCUP_LN2_LOW);
  exponent = (int)k;
  if (exponent > 1023) {
    return value * mirocup_power_of_two(1023) * mirocup_power_of_two(exponent - 1023);
  }
  if (exponent < -1022) {
    return value * mirocup_power_of_two(-1022) * mirocup_power_of_two(exponent + 1022);
  }
  return value * mirocup_power_of_two(exponent);
}

/* Returns e^x - 1, accurate near 0. */
MIROCUP_CALLED double mirocup_expm1(double x) {
  return fabs(x) <= 0.34657359027997264 ? mirocup_expm1_series(x) : mirocup_exp(x) - 1.0;
}

/* Returns ln(1 + x) for -0.3 <= x <= 0.7 as 2 artanh(x / (2 + x)). */
static inline double mirocup_log1p_series(double x) {
  const double z = x / (2.0 + x);
  const double w = z * z;
  double sum = 0.0;
  int k;
  for (k = 25; k >= 3; k -= 2) sum = sum * w + 1.0 / k;
  return 2.0 * (z + z * w * sum);
}

/* Returns the natural logarithm: -infinity for 0. */
MIROCUP_CALLED double mirocup_log(double x) {
  int exponent = 0;
  double mantissa;
  if (!(x > 0.0)) return x == 0.0 ? -HUGE_VAL : (double)NAN;
  if (x > 1.7976931348623157e308) return x;
  mantissa = frexp(x, &exponent); /* exact, in [0.5, 1) */
  if (mantissa < 0.7) {
    mantissa *= 2.0;
    --exponent;
  }
  return exponent * (MIROCUP_LN2_HIGH + MIROCUP_LN2_LOW) + mirocup_log1p_series(mantissa - 1.0);
}

/* Returns ln(1 + x), accurate near 0. */
MIROCUP_CALLED double mirocup_log1p(double x) {
  return fabs(x) <= 0.25 ? mirocup_log1p_series(x) : mirocup_log(1.0 + x);
}

#endif
