// SPDX-License-Identifier: MIT
//
// Our elementary functions against the C library's in 64-bit mantissas. Catches a wrong
// coefficient, a lost correction term in the reduction, a wrong quadrant.
#include "core/base/math.hpp"

#include "core/base/random.hpp"
#include "plugins/include/mirocup/elementary.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace mirocup {
namespace {

// Distance in units in the last place of the expected value, at least those of `floor`.
double ulps(double got, long double expected, double floor = 0.0) {
  const double near = std::max(std::abs(static_cast<double>(expected)), floor);
  const double ulp = std::nextafter(near, HUGE_VAL) - near;
  return static_cast<double>(std::abs(static_cast<long double>(got) - expected)) / ulp;
}

TEST(Math, SineAndCosineAreExactToOneUlp) {
  Random random(1);
  for (const double range : {0.5, 4.0, 1000.0}) {
    for (int i = 0; i < 200000; ++i) {
      const double x = random.uniform(-range, range);
      const SinCos got = sincos(x);
      EXPECT_LE(ulps(got.sin, std::sin(static_cast<long double>(x)), 0.01), 1.0) << x;
      EXPECT_LE(ulps(got.cos, std::cos(static_cast<long double>(x)), 0.01), 1.0) << x;
    }
  }
}

TEST(Math, SineIsOddAndCosineEvenBitForBit) {
  Random random(2);
  for (int i = 0; i < 10000; ++i) {
    const double x = random.uniform(-50.0, 50.0);
    EXPECT_EQ(sincos(x).sin, -sincos(-x).sin);
    EXPECT_EQ(sincos(x).cos, sincos(-x).cos);
  }
}

TEST(Math, SmallAnglesAtOnceHaveTheSameBits) {
  Random random(6);
  for (int i = 0; i < 10000; ++i) {
    std::array<double, angles_at_once> x{0.0, -0.0, small_angle, -small_angle};
    for (std::size_t k = 4; k < x.size(); ++k) x[k] = random.uniform(-small_angle, small_angle);
    const SinCosOfSome got = sincos_of_small(x);
    for (std::size_t k = 0; k < x.size(); ++k) {
      EXPECT_EQ(got.sin[k], sincos(x[k]).sin) << x[k];
      EXPECT_EQ(got.cos[k], sincos(x[k]).cos) << x[k];
      EXPECT_EQ(std::signbit(got.sin[k]), std::signbit(sincos(x[k]).sin)) << x[k];
    }
  }
}

TEST(Math, ExponentialIsExactToOneUlp) {
  Random random(3);
  for (int i = 0; i < 200000; ++i) {
    const double x = random.uniform(-40.0, 40.0);
    EXPECT_LE(ulps(mirocup::exp(x), std::exp(static_cast<long double>(x))), 1.0) << x;
  }
  EXPECT_EQ(mirocup::exp(0.0), 1.0);
  EXPECT_EQ(mirocup::exp(-800.0), 0.0);
  EXPECT_EQ(mirocup::exp(800.0), HUGE_VAL);
}

TEST(Math, SmallExponentialsAndLogarithmsKeepTheirDigits) {
  Random random(4);
  for (int i = 0; i < 100000; ++i) {
    const double x = random.uniform(-1.0, 1.0) * std::pow(10.0, -random.uniform(0.0, 12.0));
    EXPECT_LE(ulps(mirocup::expm1(x), std::expm1(static_cast<long double>(x))), 4.0) << x;
    EXPECT_LE(ulps(mirocup::log1p(x), std::log1p(static_cast<long double>(x))), 4.0) << x;
  }
  for (const double x : {0.5, 1.0, 7.0, 1e6}) {
    EXPECT_LE(ulps(mirocup::log1p(x), std::log1p(static_cast<long double>(x))), 4.0) << x;
  }
}

TEST(Math, AngleOfAVectorKeepsItsDigits) {
  Random random(5);
  for (int i = 0; i < 200000; ++i) {
    const double x = random.uniform(-1.0, 1.0);
    const double y = random.uniform(-1.0, 1.0);
    const long double expected =
        std::atan2(static_cast<long double>(y), static_cast<long double>(x));
    EXPECT_LE(ulps(mirocup::atan2(y, x), expected), 5.0) << y << " " << x;
  }
  EXPECT_EQ(mirocup::atan2(0.0, 0.0), 0.0);
  EXPECT_EQ(mirocup::atan2(0.0, -1.0), pi);
  EXPECT_EQ(mirocup::atan2(1.0, 0.0), 0.5 * pi);
  EXPECT_EQ(mirocup::atan2(-1.0, 0.0), -0.5 * pi);
}

// What only teams use.
TEST(Elementary, FunctionsOfTeamsKeepTheirDigits) {
  Random random(8);
  for (int i = 0; i < 100000; ++i) {
    const double part = random.uniform(-1.0, 1.0), x = random.uniform(-1.5, 1.5);
    const long double exact = part;
    EXPECT_LE(ulps(mirocup_asin(part), std::asin(exact), 0.01), 8.0) << part;
    EXPECT_LE(ulps(mirocup_acos(part), std::acos(exact), 0.01), 8.0) << part;
    EXPECT_LE(ulps(mirocup_tan(x), std::tan(static_cast<long double>(x)), 0.01), 5.0) << x;
    EXPECT_LE(ulps(mirocup_hypot(part, x), std::hypot(exact, static_cast<long double>(x))), 1.5);
    const double far = std::pow(10.0, random.uniform(-300.0, 300.0));
    EXPECT_LE(ulps(mirocup_log(far), std::log(static_cast<long double>(far))), 5.0) << far;
    const double near = 1.0 + 0.3 * part;
    EXPECT_LE(ulps(mirocup_log(near), std::log(static_cast<long double>(near))), 5.0) << near;
  }
  EXPECT_EQ(mirocup_log(0.0), -HUGE_VAL);
  EXPECT_TRUE(std::isnan(mirocup_log(-1.0)));
}

TEST(Elementary, LargeAnglesAreThoseOfTheArgumentToItsOwnLastPlace) {
  Random random(9);
  for (int i = 0; i < 100000; ++i) {
    const double x = random.uniform(-1e9, 1e9);
    const double ulp = std::nextafter(std::abs(x), HUGE_VAL) - std::abs(x);
    EXPECT_NEAR(mirocup_sin(x), static_cast<double>(std::sin(static_cast<long double>(x))), ulp);
    EXPECT_NEAR(mirocup_cos(x), static_cast<double>(std::cos(static_cast<long double>(x))), ulp);
  }
  EXPECT_TRUE(std::isnan(mirocup_sin(HUGE_VAL)));
  EXPECT_TRUE(std::isnan(mirocup_cos(std::nan(""))));
}

}  // namespace
}  // namespace mirocup
