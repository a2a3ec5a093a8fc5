// SPDX-License-Identifier: MIT
//
// One moment of a leg as SVG: the playground, the robots with their numbers, the ball and where it
// came from. It stands alone as a file, and it is the picture that the pages move.
#pragma once

#include "core/match/leg.hpp"

#include <string>
#include <vector>

namespace mirocup::web {

struct Moment {
  match::Snapshot scene;
  std::vector<Vec2> trail;  // where the ball was before, the oldest first
};

// `parameters` give the sizes of the bodies. The number of a robot is its index.
std::string picture(const field::Field& field, const simulator::Parameters& parameters,
                    const Moment& moment);

}  // namespace mirocup::web
