// SPDX-License-Identifier: MIT
//
// Wheel stiction: removes lateral slip of wheels that is too slow to simulate, by an impulse of the
// ground. Such wheels would grip again within v / (grip g), often less than a microsecond, or slide
// and grip in endless alternation. Uses collision, solver and trajectory.
#pragma once

#include "core/simulator/collision/collision_queries.hpp"
#include "core/simulator/solver/box_qp.hpp"
#include "core/simulator/trajectory/differential_drive.hpp"

#include <span>

namespace mirocup::simulator::impact {

// Stops the lateral slip of these robots together: the ground pushes each with at most
// `max_impulse`, N s, and the contacts push so that none of them approaches. The pushes of the
// contacts are added to their impulses. Stopping one robot may push others that stood, so
// nothing is changed unless the fastest slip gets slower. `contacts` are those of the robots'
// islands, `mass` and `bodies` hold all bodies, and `problem` is scratch space.
void arrest_slip(std::span<collision::Contact> contacts, std::span<const int> robots,
                 double max_impulse, std::span<const solver::InverseMass> mass,
                 std::span<BodyState> bodies, solver::BoxQp& problem);

// Removes lateral slip too slow to simulate: slip caused by an impact, or alternating slip in a
// wedge. Applies to every robot that has a contact and its wheels on the ground. To be called after
// the impact of these contacts was resolved. The limits of the slip come from Tolerances. For a
// robot that the impact did not hit, the limit is slow_motion; for one that it hit,
// first_restitution_threshold; for one that it hit in a series of impacts, the slip that the ground
// would stop within series_height, but at most the approach that the impact ended. So a contact
// that only grazes stops no slip: it may open at once, and the impulse that stops the slip would
// press on it.
void arrest_slow_slip(const collision::StaticWorld& world,
                      std::span<const trajectory::DriveReference> drives,
                      std::span<collision::Contact> contacts,
                      std::span<const solver::InverseMass> mass, std::span<BodyState> bodies,
                      solver::BoxQp& problem);

}  // namespace mirocup::simulator::impact
