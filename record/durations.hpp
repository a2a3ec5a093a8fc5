// SPDX-License-Identifier: MIT
//
// The distribution of durations in constant memory: a histogram with 32 ranges in each octave, so
// that a quantile exceeds the true quantile by at most 1/32 of it.
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <vector>

namespace mirocup::record {

class Durations {
 public:
  // Adds one duration, s. A duration outside of all ranges counts in the first or the last range.
  void add(double seconds) {
    ++counts_[range_of(seconds)];
    ++count_;
    max_ = std::max(max_, seconds);
  }

  std::uint64_t count() const { return count_; }
  double max() const { return max_; }

  // Returns a duration, s, that at least this share (0 to 1) of the durations did not exceed; 0 if
  // there are no durations.
  double quantile(double share) const {
    assert(share >= 0.0 && share <= 1.0);
    std::uint64_t until = 0;
    for (int i = 0; i < ranges; ++i) {
      until += counts_[i];
      if (until > 0 && static_cast<double>(until) >= share * static_cast<double>(count_)) {
        return std::min(end_of(i), max_);
      }
    }
    return max_;
  }

  struct Range {
    double below = 0.0;  // upper end of the range, s; the lower end is half of it
    std::uint64_t count = 0;
  };

  // Returns the octaves that are not empty, in ascending order.
  std::vector<Range> histogram() const {
    std::vector<Range> filled;
    for (int i = 0; i < ranges; i += ranges_per_octave) {
      std::uint64_t count = 0;
      for (int j = i; j < i + ranges_per_octave; ++j) count += counts_[j];
      if (count > 0) filled.push_back({end_of(i + ranges_per_octave - 1), count});
    }
    return filled;
  }

 private:
  static constexpr int min_exponent = -20;  // 2^-20 s, about a microsecond
  static constexpr int octaves = 28;        // up to 256 s
  static constexpr int ranges_per_octave = 32;
  static constexpr int ranges = octaves * ranges_per_octave;

  static int range_of(double seconds) {
    int octave = 0;
    const double part = std::frexp(seconds, &octave);  // 0.5 to 1
    if (seconds <= 0.0 || octave <= min_exponent) return 0;
    if (octave > min_exponent + octaves) return ranges - 1;
    return (octave - min_exponent - 1) * ranges_per_octave +
           static_cast<int>((part - 0.5) * 2 * ranges_per_octave);
  }
  static double end_of(int range) {
    return std::ldexp(0.5 + (range % ranges_per_octave + 1) / (2.0 * ranges_per_octave),
                      range / ranges_per_octave + min_exponent + 1);
  }

  std::array<std::uint64_t, ranges> counts_{};
  std::uint64_t count_ = 0;
  double max_ = 0.0;
};

}  // namespace mirocup::record
