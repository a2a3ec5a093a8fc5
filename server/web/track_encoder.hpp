// SPDX-License-Identifier: MIT
//
// Where everything was, tick by tick, small enough for a page: whole numbers, each written as its
// difference to the straight line through the two before it, in as few bytes as it needs.
//
// A frame is the scene at the begin of a tick as whole numbers (units: frame_units): clock, ball x
// and y, then of each robot, blue ones first, x, y and heading. page/track.js reads both forms.
#pragma once

#include "core/match/snapshot.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace mirocup::web {

// What one unit of a frame's number means.
inline constexpr double length_unit = 0.0005;  // m
inline constexpr double clock_unit = 0.001;    // s
inline constexpr int heading_units_a_turn = 2048;

using Frame = std::vector<std::int32_t>;

// `robots` of a team. Headings go on from those of `before` (may be empty), so that none jumps by a
// turn.
Frame frame_of(const match::Snapshot& scene, int robots, const Frame& before);

class TrackEncoder {
 public:
  explicit TrackEncoder(int robots) : robots_(robots) {}

  void add(const match::Snapshot& scene);

  std::size_t frames() const { return frames_; }

  // Column after column; zigzag, then seven bits a byte, the lowest first; base64.
  std::string packed() const;

 private:
  int robots_;
  std::size_t frames_ = 0;
  Frame last_;
  Frame last_change_;
  std::vector<std::string> columns_;
};

}  // namespace mirocup::web
