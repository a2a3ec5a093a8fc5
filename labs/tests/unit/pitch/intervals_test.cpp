// SPDX-License-Identifier: MIT
#include "labs/pitch/intervals.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace mirocup::pitch {
namespace {

// Windows whose costs are parabolas with their least values at `centres`, each of which knows its
// own by `sigma`.
Fit::Profile parabolas(const std::vector<double>& centres, double sigma) {
  Fit::Profile profile;
  for (int i = 0; i <= 40; ++i) profile.values.push_back(0.01 * i);
  profile.costs.assign(profile.values.size(), 0.0);
  for (const double centre : centres) {
    std::vector<double> part;
    for (std::size_t i = 0; i < profile.values.size(); ++i) {
      part.push_back(std::pow((profile.values[i] - centre) / sigma, 2.0));
      profile.costs[i] += part.back();
    }
    profile.parts.push_back(part);
  }
  return profile;
}

double half_of(const Estimate& e) {
  return (e.high - e.low) / 2.0;
}

// Catches an interval that is not that of the mean of many windows which agree.
TEST(Intervals, ManyWindowsThatAgreeTellTheirMean) {
  std::vector<double> centres;
  for (int i = 0; i < 50; ++i) centres.push_back(0.2 + (i % 2 == 0 ? 0.02 : -0.02));
  const Estimate e = interval_of(parabolas(centres, 0.04), 0.0);
  EXPECT_NEAR(e.value, 0.2, 1e-6);
  EXPECT_NEAR(half_of(e), 1.96 * 0.04 / std::sqrt(50.0), 0.001);
  const Estimate wider = interval_of(parabolas(centres, 0.04), 0.01);
  EXPECT_NEAR(half_of(wider), std::hypot(half_of(e), 1.96 * 0.01), 1e-6);
}

// Catches an interval of few windows that is as narrow as that of many, and one that does not see
// that they contradict each other.
TEST(Intervals, FewWindowsAndThoseThatDifferWiden) {
  const double agree = half_of(interval_of(parabolas({0.19, 0.2, 0.21}, 0.02), 0.0));
  EXPECT_GT(agree, 2.0 * 1.96 * 0.02 / std::sqrt(3.0));
  const std::vector<double> differ{0.2, 0.2, 0.2, 0.2, 0.2, 0.2, 0.2, 0.3};
  const double one_pulls = half_of(interval_of(parabolas(differ, 0.01), 0.0));
  EXPECT_GT(one_pulls, 3.0 * 1.96 * 0.01 / std::sqrt(8.0));
}

}  // namespace
}  // namespace mirocup::pitch
