// SPDX-License-Identifier: MIT
//
// How much of a robot stands in an area, exactly.
//
// The rules ask for "more than 50 %" of a robot. The place of its centre does not answer that at an
// area's corner or at its arc: a centre just inside a corner can mean a third of the body. So the
// square is clipped against the area's parts (rectangle, arc, inside of the goal) and what is left
// is added up.
#pragma once

#include "core/field/field.hpp"

namespace mirocup::field {

// The part, from 0 to 1, of a square robot that lies in the area of that end, the goal's interior
// included. `side` in metres. The same bits for a robot and an end turned by 180 degrees.
double covered_part(const Field& field, const Area& area, End end, const Pose& robot, double side);

}  // namespace mirocup::field
