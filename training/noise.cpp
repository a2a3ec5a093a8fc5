// SPDX-License-Identifier: MIT
#include "training/noise.hpp"

#include <algorithm>
#include <cmath>

namespace mirocup::training {

namespace {

constexpr double theta = 0.17;  // 1/s
constexpr double sigma = 0.5;   // 1/sqrt(s)

// Sets these draws apart from the other uses of a leg's seed.
constexpr std::uint64_t domain = 0x747261696e6f6973ULL;

}  // namespace

Noise::Noise(std::uint64_t seed, Team team)
    : random_(mix_seed(mix_seed(seed ^ domain) + static_cast<unsigned>(index_of(team)))) {}

match::Command Noise::next(int robots, double period, double limit) {
  match::Command command;
  const double step = sigma * std::sqrt(period);
  for (int i = 0; i < robots; ++i) {
    const auto robot = static_cast<std::size_t>(i);
    for (double& x : share_[robot]) {
      x += -theta * x * period + step * match::cut_normal(random_);
    }
    command.wheels[robot] = {limit * std::clamp(share_[robot][0], -1.0, 1.0),
                             limit * std::clamp(share_[robot][1], -1.0, 1.0)};
  }
  return command;
}

}  // namespace mirocup::training
