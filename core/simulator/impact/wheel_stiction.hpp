// SPDX-License-Identifier: MIT
//
// WheelState of bodies in contact that slide so slowly that they would grip again at once, or slide, stop
// and slide on: the ground's impulse that stops them.
#pragma once

#include "core/simulator/collision/collision_queries.hpp"
#include "core/simulator/impact/rest_thresholds.hpp"
#include "core/simulator/solver/box_qp.hpp"
#include "core/simulator/trajectory/differential_drive.hpp"

#include <span>

namespace mirocup::simulator::impact {

// The wheels of these robots, which slide or stand: stops them together, by at most `most` N s of the
// ground for each, so that no contact approaches; adds to the contacts' impulses. What stops one may
// push others that stood: where the fastest would be no slower than before, nothing changes.
void arrest_slip(std::span<collision::Contact> contacts, std::span<const int> robots, double most,
                 std::span<const solver::InverseMass> mass, std::span<BodyState> bodies,
                 solver::BoxQp& problem);

// What little an impact makes wheels slide would end too soon to be worth an event; so would the slides
// that come and go where bodies are wedged: stops those, of all robots with a contact. How little that
// is says patience. The contacts are those of an impact that was resolved.
void arrest_slow_slip(const collision::StaticWorld& world, const RestThresholds& thresholds,
                      std::span<const trajectory::DriveReference> drives,
                      std::span<collision::Contact> contacts,
                      std::span<const solver::InverseMass> mass, std::span<BodyState> bodies,
                      solver::BoxQp& problem);

}  // namespace mirocup::simulator::impact
