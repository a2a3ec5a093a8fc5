// SPDX-License-Identifier: MIT
//
// One moment of a leg as SVG: the field, the robots with their numbers, the ball and its trail. The
// picture can be a separate file; pages also animate it.
#pragma once

#include "core/match/leg.hpp"

#include <string>
#include <vector>

namespace mirocup::web {

struct Moment {
  match::Snapshot scene;
  std::vector<Vec2> trail;  // earlier positions of the ball, the oldest first
};

// `parameters` have the sizes of the bodies. The number on a robot is its index.
std::string picture(const field::Field& field, const simulator::Parameters& parameters,
                    const Moment& moment);

// The style element in each picture.
std::string picture_style();

// The present moment of a leg.
std::string picture(const match::Leg& leg);

}  // namespace mirocup::web
