// SPDX-License-Identifier: MIT
#include "tests/security/honest/honest.hpp"

#include <algorithm>
#include <any>
#include <functional>
#include <map>
#include <memory>
#include <numeric>
#include <regex>
#include <string>
#include <unordered_map>
#include <variant>
#include <vector>

namespace {

std::unordered_map<std::string, std::unique_ptr<std::vector<double>>> seen;

}  // namespace

void Honest::decide(const Observation& now, Command& command) {
  std::map<double, int> by_distance;
  for (int i = 0; i < now.robots; ++i) by_distance[length(position(now.own[i]) - ball(now))] = i;
  seen["tick " + std::to_string(now.tick)] = std::make_unique<std::vector<double>>(1000, 1.0);
  const auto& latest = *seen["tick " + std::to_string(now.tick)];
  const double sum = std::accumulate(latest.begin(), latest.end(), 0.0);
  if (!std::regex_match("robot 12", std::regex("robot [0-9]+"))) return;
  const std::function<double(double)> half = [](double x) { return x / 2.0; };
  command.wheels[by_distance.begin()->second] = {half(sum) / 50.0, sum / 100.0};
  if (now.tick == 0) log("with the standard library");
}
