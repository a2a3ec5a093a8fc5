// SPDX-License-Identifier: MIT
#include "core/simulator/impact/friction.hpp"

#include <algorithm>

namespace mirocup::simulator::impact {

solver::ConstraintRow tangent_row(const collision::Contact& c, std::span<const BodyState> bodies) {
  collision::Contact tangent = c;
  tangent.point.normal = cross(1.0, c.point.normal);
  set_row(bodies, tangent);
  return tangent.row;
}

bool has_friction(const Parameters& p) {
  const PerPair& f = p.contact_friction;
  return f.ball_wall > 0.0 || f.ball_robot > 0.0 || f.robot_wall > 0.0 || f.robot_robot > 0.0;
}

void resolve_friction(std::span<collision::Contact> contacts,
                      std::span<const solver::InverseMass> mass, std::span<BodyState> bodies,
                      solver::BoxQp& problem) {
  bool some_changed = false;
  for (const collision::Contact& c : contacts) {
    const double friction = c.material.friction;
    if (friction == 0.0 || c.impact.impulse <= 0.0) continue;
    const solver::ConstraintRow tangent = tangent_row(c, bodies);
    const double inverse_mass = collision::inverse_effective_mass(tangent, mass);
    if (inverse_mass <= 0.0) continue;
    const double max_impulse = friction * c.impact.impulse;
    const double impulse =
        std::clamp(-collision::row_rate(tangent, bodies) / inverse_mass, -max_impulse, max_impulse);
    collision::apply_impulse(tangent, impulse, mass, bodies);
    some_changed = some_changed || impulse != 0.0;
  }
  if (some_changed) stop_approaches(contacts, mass, bodies, problem);
}

}  // namespace mirocup::simulator::impact
