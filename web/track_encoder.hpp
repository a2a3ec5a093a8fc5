// SPDX-License-Identifier: MIT
//
// Encodes the positions of all bodies, tick by tick, small enough for a page. Positions are whole
// numbers. Each number is written as its difference from the straight line through its values in
// the two frames before, in as few bytes as possible.
//
// A frame is the state at the start of a tick as whole numbers, in the units below: clock, ball x
// and y, then x, y and heading of each robot, blue robots first. page/track.js reads frames and
// tracks.
#pragma once

#include "core/match/snapshot.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace mirocup::web {

// The units of a frame's numbers.
inline constexpr double length_unit = 0.0005;  // m
inline constexpr double clock_unit = 0.001;    // s
inline constexpr int heading_units_a_turn = 2048;

using Frame = std::vector<std::int32_t>;

// `robots`: number of robots of a team. `before` is the previous frame, or empty. Headings of the
// new frame differ from those of `before` by at most half a turn, so that no heading jumps.
Frame frame_of(const match::Snapshot& scene, int robots, const Frame& before);

// Packs rows of whole numbers. All rows have the same length.
class ColumnEncoder {
 public:
  void add(const Frame& row);

  std::size_t rows() const { return rows_; }
  const Frame& last() const { return last_; }  // empty before the first row

  // Returns the columns one after the other, with numbers as zigzag varints (seven bits in a byte,
  // the lowest bits first).
  std::string bytes() const;

 private:
  std::size_t rows_ = 0;
  Frame last_;
  Frame last_change_;
  std::vector<std::string> columns_;
};

}  // namespace mirocup::web
