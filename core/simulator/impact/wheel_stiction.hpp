// SPDX-License-Identifier: MIT
//
// Wheel stiction: removes lateral slip of wheels that is too slow to simulate, by an impulse of the
// ground. Such wheels would grip again after v_l / (grip g), often less than a microsecond, or
// slide and grip in endless alternation. Uses collision, solver and trajectory.
#pragma once

#include "core/simulator/collision/collision_queries.hpp"
#include "core/simulator/solver/box_qp.hpp"
#include "core/simulator/trajectory/differential_drive.hpp"

#include <span>

namespace mirocup::simulator::impact {

// Stops the lateral slip of these robots together: the ground pushes each robot with at most
// `max_impulse`, N s, and the contacts push so that no contact approaches. The pushes of the
// contacts are added to their impulses. Stopping one robot may push others that stood, so nothing
// is changed unless the fastest slip gets slower. `contacts` are those of the robots' islands,
// `mass` and `bodies` hold all bodies, and `problem` is scratch space.
void arrest_slip(std::span<collision::Contact> contacts, std::span<const int> robots,
                 double max_impulse, std::span<const solver::InverseMass> mass,
                 std::span<BodyState> bodies, solver::BoxQp& problem);

// Removes lateral slip too slow to simulate: slip caused by an impact, or alternating slip in a
// wedge. Applies to every robot that has a contact and its wheels on the ground. To be called after
// the impact of these contacts was resolved. The limit of a robot's slip comes from Tolerances:
// - slow_motion if the impact did not hit the robot;
// - first_touch_threshold if it did;
// - in a series of impacts, the slip that the ground would stop within series_height, but at most
//   the approach speed of the impact. So an impact that only grazes stops no fast slip: its
//   contact may open at once, and the impulse that stops the slip would press on the contact.
void arrest_slow_slip(const collision::StaticWorld& world,
                      std::span<const trajectory::DriveReference> drives,
                      std::span<collision::Contact> contacts,
                      std::span<const solver::InverseMass> mass, std::span<BodyState> bodies,
                      solver::BoxQp& problem);

}  // namespace mirocup::simulator::impact
