// SPDX-License-Identifier: MIT
//
// Wheels of bodies in contact that slide so slowly that they would grip again at once, or slide, stop
// and slide on: the ground's impulse that stops them.
#pragma once

#include "core/simulator/impact.hpp"

#include <span>

namespace mirocup::simulator {

// The wheels of these robots, which slide or stand: stops them together, by at most `most` N s of the
// ground for each, so that no contact approaches; adds to the contacts' impulses. What stops one may
// push others that stood: where the fastest would be no slower than before, nothing changes.
void stop_slides(std::span<Contact> contacts, std::span<const int> robots, double most,
                 std::span<const InverseMass> mass, std::span<Body> bodies, BoxProblem& problem);

}  // namespace mirocup::simulator
