// SPDX-License-Identifier: MIT
//
// The whole physics by tiny time steps: the reference for core/simulator wherever there is no
// closed form. Slow, simple and independent: it has its own forces, geometry (outline.hpp) and
// solver (box_sweeps.hpp); of core/simulator it uses only the structs of its numbers.
//
// State: positions, angles and velocities in the field's frame, so that no turning frames appear.
// A step is second order: forces at its middle, and such impulses of contacts and wheels that at
// its end nothing that touches comes closer and no wheel slides that can hold. Where something
// would get inside something the step ends there, and the impact is resolved as a simultaneous
// one. It ends also where the wheels of a robot lose or find their grip, but only to the step.
#pragma once

#include "core/simulator/model/parameters.hpp"
#include "core/simulator/model/state.hpp"
#include "tests/support/outline.hpp"

#include <Eigen/Core>

#include <span>
#include <vector>

namespace mirocup::test_support {

// A contact of a body with another one or with a solid.
struct TinyContact {
  int a = 0;
  int b = -1;  // -1: a fixed solid
  int solid = -1;
  TouchPoint at{};
  double restitution = 0.0;
};

class TinyWorld {
 public:
  // `field` may be null: an infinite plane. The ball, if there is one, comes after the robots.
  TinyWorld(const field::Field* field, const simulator::Parameters& parameters, int robots,
            bool has_ball, double step);

  void set_robot(int i, const simulator::BodyState& state);
  void set_ball(const simulator::BallState& state);
  simulator::BodyState robot(int i) const;
  simulator::BallState ball() const;

  void advance(std::span<const simulator::WheelCommand> commands, double duration);

  int impacts() const { return impacts_; }
  double deepest_overlap() const;  // m, now
  double kinetic_energy() const;   // J, of a ball with its rotation

 private:
  struct Body {
    Vec2 position{0.0, 0.0};
    double angle = 0.0;
    Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  // and turn rate
  };
  struct DriveReference {
    bool wheels_on_ground = true;
    double forward = 0.0, turn = 0.0;
    double forward_lag = 1.0, turn_lag = 1.0;  // s
  };
  // A velocity that a contact or wheels keep at zero or above: along_a . velocity of a +
  // along_b . velocity of b.
  struct Row {
    int a = -1, b = -1;
    Eigen::RowVector3d along_a = Eigen::RowVector3d::Zero();
    Eigen::RowVector3d along_b = Eigen::RowVector3d::Zero();
  };
  using Bodies = std::vector<Body>;
  using Contacts = std::vector<TinyContact>;
  using Rows = std::vector<Row>;

  bool is_ball(int body) const { return body == robots_; }
  bool has_wheels(int body) const { return !is_ball(body) && drives_[body].wheels_on_ground; }
  Outline outline(const Body& body, int index) const;
  Eigen::Vector3d mass(int body) const;
  Eigen::Matrix3d inverse_mass_in_impact(int body) const;
  Eigen::Vector3d force(const Body& middle, int index) const;  // of motor or air

  template <class Visit>
  void for_close_pairs(const Bodies& bodies, Visit visit) const;
  double nearest(const Bodies& bodies) const;
  Contacts contacts_within(const Bodies& bodies, double margin) const;
  TinyContact followed(const TinyContact& contact, const Bodies& bodies) const;
  Rows rows_of(const Contacts& contacts, const Bodies& bodies) const;
  Rows wheel_rows(const Bodies& bodies) const;
  static double rate(const Row& row, const Bodies& bodies);

  Bodies stepped(const Contacts& contacts, double h);
  void solve_step(const Contacts& contacts, double h, Bodies& end);
  double length_until_inside(const Contacts& contacts, double limit, double h);
  bool any_impact(const Contacts& contacts, double h) const;
  void resolve_impacts(const Contacts& contacts);
  void resolve_cluster(const Rows& rows, const std::vector<double>& restitution);
  double kinetic_energy_in_impact() const;

  simulator::Parameters p_;
  int robots_;
  bool has_ball_;
  double step_;
  Vec2 inner_{0.0, 0.0};  // no solid reaches a body whose centre is inside this half-rectangle
  std::vector<Outline> solids_;
  Bodies bodies_;
  std::vector<DriveReference> drives_;
  Eigen::VectorXd impulses_;  // of the last step: the warm start of the next one
  int impacts_ = 0;
};

}  // namespace mirocup::test_support
