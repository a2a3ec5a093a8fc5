// SPDX-License-Identifier: MIT
#include "labs/pitch/intervals.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace mirocup::pitch {

namespace {

// Where a cost is least: of the parabola through the three values there.
struct Lowest {
  int at;  // index of the lowest value
  double value, cost;
};

Lowest lowest_of(const std::vector<double>& values, const std::vector<double>& c) {
  const int last = static_cast<int>(c.size()) - 1;
  const int at = static_cast<int>(std::min_element(c.begin(), c.end()) - c.begin());
  Lowest lowest{at, values[at], c[at]};
  if (at > 0 && at < last) {
    const double bend = c[at - 1] - 2.0 * c[at] + c[at + 1];
    const double way = bend > 0.0 ? 0.5 * (c[at - 1] - c[at + 1]) / bend : 0.0;
    lowest.value += way * (values[at + 1] - values[at]);
    lowest.cost -= 0.25 * (c[at - 1] - c[at + 1]) * way;
  }
  return lowest;
}

// Where the cost is least, and where it has risen by what 95 % allow.
Estimate rise_of(const Fit::Profile& p) {
  const auto& c = p.costs;
  const auto& v = p.values;
  const int last = static_cast<int>(c.size()) - 1;
  const Lowest lowest = lowest_of(v, c);
  const int at = lowest.at;
  const double value = lowest.value, least = lowest.cost;
  // The root of the rise is linear where the cost is a parabola.
  const auto rise = [&](int i, double sign) {
    return std::copysign(std::sqrt(std::max(0.0, c[i] - least)), sign * (v[i] - value));
  };
  const auto end = [&](int from, int step) {
    const double sign = -step;
    int i = from;
    while (i != at && c[i] > least + rise95) i += step;
    if (i == from) return v[i];
    const double inner = rise(i, sign), outer = rise(i - step, sign);
    return v[i] + (z95 - inner) / (outer - inner) * (v[i - step] - v[i]);
  };
  return {value, end(0, 1), end(last, -1)};
}

// Returns by how much an interval must be wider than the rise of the cost says, since windows
// differ by more than noise: 1 or more. Of a cost c - 2 s (v - value) + h (v - value)^2 in each
// window the square of s should be h in the mean; the difference between the ends of the interval
// shows s.
double widening_of(const Fit::Profile& p, const Estimate& interval) {
  const auto at = [&](const std::vector<double>& costs, double value) {
    const auto above = std::lower_bound(p.values.begin() + 1, p.values.end() - 1, value);
    const auto i = static_cast<std::size_t>(above - p.values.begin());
    const double way = (value - p.values[i - 1]) / (p.values[i] - p.values[i - 1]);
    return costs[i - 1] + way * (costs[i] - costs[i - 1]);
  };
  double sum = 0.0;
  for (const std::vector<double>& costs : p.parts) {
    const double difference = at(costs, interval.high) - at(costs, interval.low);
    sum += difference * difference;
  }
  const double few = p.windows() / std::max(1.0, p.windows() - 1.0);
  return std::sqrt(std::max(1.0, few * sum / (16.0 * rise95)));
}

// Returns the standard deviation of what a profile tells, by leaving out each of its windows in
// turn (the jackknife). Unlike the rise of the cost it sees a window that pulls alone.
double scatter_of(const Fit::Profile& p) {
  std::vector<double> found;
  for (const std::vector<double>& part : p.parts) {
    std::vector<double> costs = p.costs;
    for (std::size_t i = 0; i < costs.size(); ++i) costs[i] -= part[i];
    found.push_back(lowest_of(p.values, costs).value);
  }
  const double n = static_cast<double>(found.size());
  const double mean = std::accumulate(found.begin(), found.end(), 0.0) / n;
  double square = 0.0;
  for (const double value : found) square += (value - mean) * (value - mean);
  return std::sqrt(square * (n - 1.0) / n);
}

// Returns by how much an interval that `windows` tell must be wider than one that many tell:
// Student's t with one degree of freedom less, by the expansion of Cornish and Fisher, which is 3 %
// too small for three windows. One hit that is simulated with the wrong edge first counts for much
// among few.
double widening_of_few(int windows) {
  const double z = z95, n = windows - 1.0;
  const double z3 = z * z * z, z5 = z3 * z * z, z7 = z5 * z * z;
  const double t = z + (z3 + z) / (4.0 * n) + (5.0 * z5 + 16.0 * z3 + 3.0 * z) / (96.0 * n * n) +
                   (3.0 * z7 + 19.0 * z5 + 17.0 * z3 - 15.0 * z) / (384.0 * n * n * n);
  return t / z;
}

}  // namespace

Estimate interval_of(const Fit::Profile& profile, double others) {
  const Estimate rise = rise_of(profile);
  const double widening = widening_of(profile, rise);
  const double few = widening_of_few(profile.windows());
  const double least_half = z95 * scatter_of(profile);
  const auto half = [&](double risen) {
    return std::hypot(few * std::max(widening * risen, least_half), z95 * others);
  };
  return {rise.value, rise.value - half(rise.value - rise.low),
          rise.value + half(rise.high - rise.value)};
}

}  // namespace mirocup::pitch
