// SPDX-License-Identifier: MIT
//
// The exact share of a robot's square that stands in an area.
//
// The rules ask for "more than 50 %" of a robot. The position of its centre does not answer that at
// a corner or an arc of an area: of a robot whose centre is just inside a corner, only a third may
// be inside. So the square is clipped against the parts of the area (rectangle, arc, inside of the
// goal), and the sizes of the clipped polygons are added up.
#pragma once

#include "core/field/field.hpp"

namespace mirocup::field {

// Returns the part, from 0 to 1, of a square robot that lies in the area at `end`. The inside of
// the goal belongs to the area. `side` is the robot's, in metres. A robot and an end turned by 180
// degrees give the same bits.
double covered_part(const Field& field, const Area& area, End end, const Pose& robot, double side);

}  // namespace mirocup::field
