// SPDX-License-Identifier: MIT
//
// Lasting contact by small steps: bodies that push, are pushed, or lie against something.
//
// One step finds the impulses of all contacts of a cluster and of its wheels together, as one
// convex problem: contacts only push, wheels hold sideways up to their grip, and at the end of the
// step no gap closes further. Where contacts have friction its bound is not known before the normal
// impulses are: the problem is solved again with the bounds that it gave, until they hardly change.
// First order in the step; positions are then corrected so that no overlap builds up.
#pragma once

#include "core/simulator/arena.hpp"
#include "core/simulator/friction.hpp"
#include "core/simulator/robot_motion.hpp"

#include <span>

namespace mirocup::simulator {

// What moves the bodies of a cluster besides their contacts.
struct Forces {
  const Parameters& parameters;
  std::span<const Drive> drives;  // of the robots; the ball has none
  int ball;                       // its index, or no_body
};

// No point of the body is faster, m/s.
double speed_at_most(const Arena& arena, int body, const Body& state);

// How far (m) bodies in contact can come to overlap in a step of that length (s), which knows their
// contact as it is at its begin: while they turn by omega step, their points go (v + omega r) step.
double overlap_by_turning(const Arena& arena, std::span<const Contact> contacts,
                          std::span<const Body> bodies, double step);

// Sets the twists of the members to those that hold over the next `step` seconds, and the impulses
// of the contacts. Members are in increasing order and the contacts are all between members or with
// walls.
void step_in_contact(const Forces& forces, std::span<const int> members,
                     std::span<Contact> contacts, double step, std::span<const InverseMass> mass,
                     std::span<Body> bodies, BoxProblem& problem);

}  // namespace mirocup::simulator
