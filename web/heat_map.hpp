// SPDX-License-Identifier: MIT
//
// A heat map: where the ball was while play was on.
#pragma once

#include "core/match/leg.hpp"

#include <vector>

namespace mirocup::web {

class HeatMap {
 public:
  explicit HeatMap(const field::Field& field);

  // To be called after every tick.
  void add(const match::Snapshot& scene);

  // The ticks of play that the ball spent in each cell of the field, which is turned so that blue
  // attacks to the right. Rows from the top, each of columns() cells.
  const std::vector<int>& cells() const { return cells_; }
  int columns() const { return columns_; }

 private:
  field::Field field_;
  int columns_;
  int rows_;
  std::vector<int> cells_;
  bool was_play_ = false;  // after the tick before
};

}  // namespace mirocup::web
