// SPDX-License-Identifier: MIT
#include "tests/support/tiny_world.hpp"

#include "tests/support/box_sweeps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mirocup::test_support {

namespace {

constexpr double g = 9.81;
constexpr double infinity = std::numeric_limits<double>::infinity();

// m/s: bodies touch if their gap is at most this speed times the step.
constexpr double touch_speed = 1e-4;

// The share of an overlap that one step removes.
constexpr double push_out = 0.2;

// m: a contact point that moves farther than this in one step is a new contact.
constexpr double follow = 1e-3;

Vec2 forward_of(double angle) {
  return {std::cos(angle), std::sin(angle)};
}

// The core's vectors have no matrices beside them; these are the same numbers as Eigen's.
Eigen::Vector2d in_eigen(const Vec2& v) {
  return {v.x(), v.y()};
}

// Returns the velocity of the centre, without the turn.
Vec2 in_plane(const Eigen::Vector3d& velocity) {
  return {velocity[0], velocity[1]};
}

Eigen::RowVector3d generalised(const Vec2& direction, const Vec2& lever) {
  return {direction.x(), direction.y(), cross(lever, direction)};
}

}  // namespace

TinyWorld::TinyWorld(const field::Field* field, const simulator::Parameters& parameters, int robots,
                     bool has_ball, double step)
    : p_(parameters),
      robots_(robots),
      has_ball_(has_ball),
      step_(step),
      inner_(infinity, infinity),
      bodies_(robots + (has_ball ? 1 : 0)),
      drives_(robots) {
  if (field == nullptr) return;
  solids_ = solids_around(*field);
  const double reach = field->corner_leg + p_.robot_side;
  inner_ = {field->half_length - reach, field->half_width - reach};
}

void TinyWorld::set_robot(int i, const simulator::BodyState& s) {
  const Vec2 velocity = s.heading.to_world({s.twist.forward, s.twist.left});
  bodies_[i] = {s.position,
                std::atan2(s.heading.sin, s.heading.cos),
                {velocity.x(), velocity.y(), s.twist.omega}};
}

void TinyWorld::set_ball(const simulator::BallState& s) {
  bodies_[robots_] = {s.position, 0.0, {s.velocity.x(), s.velocity.y(), 0.0}};
}

simulator::BodyState TinyWorld::robot(int i) const {
  const Body& b = bodies_[i];
  const Heading heading{std::cos(b.angle), std::sin(b.angle)};
  const Vec2 velocity = heading.to_body({b.velocity[0], b.velocity[1]});
  return {b.position, heading, {velocity.x(), velocity.y(), b.velocity[2]}};
}

simulator::BallState TinyWorld::ball() const {
  const Body& b = bodies_[robots_];
  return {b.position, {b.velocity[0], b.velocity[1]}};
}

// ---- the bodies

Outline TinyWorld::outline(const Body& body, int index) const {
  return is_ball(index) ? circle_at(body.position, p_.ball_radius)
                        : square_at(body.position, body.angle, p_.robot_side);
}

Eigen::Vector3d TinyWorld::mass(int body) const {
  if (is_ball(body)) {
    // Rolling adds the ball's moment of inertia. The ball does not turn about the vertical.
    const double m = p_.ball_mass + 0.4 * p_.ball_mass;
    return {m, m, infinity};
  }
  return {p_.robot_mass, p_.robot_mass, p_.robot_mass * p_.robot_side * p_.robot_side / 6.0};
}

Eigen::Matrix3d TinyWorld::inverse_mass_in_impact(int body) const {
  Eigen::Matrix3d w = mass(body).cwiseInverse().asDiagonal();
  if (has_wheels(body) && p_.grip == simulator::infinite_grip) {
    const Eigen::Vector2d forward = in_eigen(forward_of(bodies_[body].angle));
    w.topLeftCorner<2, 2>() = forward * forward.transpose() / p_.robot_mass;
  }
  return w;
}

Eigen::Vector3d TinyWorld::force(const Body& middle, int index) const {
  const Eigen::Vector3d m = mass(index);
  if (is_ball(index)) {
    return {-p_.viscous_friction * middle.velocity[0], -p_.viscous_friction * middle.velocity[1],
            0.0};
  }
  const DriveReference& drive = drives_[index];
  if (!drive.wheels_on_ground) return Eigen::Vector3d::Zero();
  const Eigen::Vector2d forward = in_eigen(forward_of(middle.angle));
  const double speed = forward.dot(middle.velocity.head<2>());
  const Eigen::Vector2d push = m[0] * (drive.forward - speed) / drive.forward_lag * forward;
  return {push.x(), push.y(), m[2] * (drive.turn - middle.velocity[2]) / drive.turn_lag};
}

double TinyWorld::kinetic_energy() const {
  double sum = 0.0;
  for (int i = 0; i < static_cast<int>(bodies_.size()); ++i) {
    for (int d = 0; d < (is_ball(i) ? 2 : 3); ++d) {
      sum += 0.5 * mass(i)[d] * bodies_[i].velocity[d] * bodies_[i].velocity[d];
    }
  }
  return sum;
}

// ---- contact detection

template <class Visit>
void TinyWorld::for_close_pairs(const Bodies& bodies, Visit visit) const {
  const double robot_reach = p_.robot_side * std::sqrt(0.5);
  const int count = static_cast<int>(bodies.size());
  for (int i = 0; i < count; ++i) {
    const double reach = is_ball(i) ? p_.ball_radius : robot_reach;
    for (int j = 0; j < i; ++j) {
      const double apart = (bodies[i].position - bodies[j].position).norm();
      if (apart < reach + robot_reach + follow) {
        visit(i, j, -1, outline(bodies[i], i), outline(bodies[j], j));
      }
    }
    const Vec2 at = bodies[i].position;
    if (std::abs(at.x()) < inner_.x() && std::abs(at.y()) < inner_.y()) continue;
    for (int k = 0; k < static_cast<int>(solids_.size()); ++k) {
      visit(i, -1, k, outline(bodies[i], i), solids_[k]);
    }
  }
}

double TinyWorld::nearest(const Bodies& bodies) const {
  double least = infinity;
  for_close_pairs(bodies, [&](int, int, int, const Outline& a, const Outline& b) {
    least = std::min(least, distance(a, b));
  });
  return least;
}

double TinyWorld::deepest_overlap() const {
  return std::max(0.0, -nearest(bodies_));
}

TinyWorld::Contacts TinyWorld::contacts_within(const Bodies& bodies, double margin) const {
  Contacts contacts;
  for_close_pairs(bodies, [&](int i, int j, int solid, const Outline& a, const Outline& b) {
    const simulator::PerPair& e = p_.restitution;
    const double restitution = solid >= 0 ? (is_ball(i) ? e.ball_wall : e.robot_wall)
                                          : (is_ball(i) ? e.ball_robot : e.robot_robot);
    for (const TouchPoint& at : touch_points(a, b, margin)) {
      contacts.push_back({i, j, solid, at, restitution});
    }
  });
  return contacts;
}

// Returns the same contact after its bodies have moved a little.
TinyContact TinyWorld::followed(const TinyContact& c, const Bodies& bodies) const {
  const Outline a = outline(bodies[c.a], c.a);
  const Outline b = c.solid >= 0 ? solids_[c.solid] : outline(bodies[c.b], c.b);
  TinyContact found = c;
  double nearest_point = follow;
  for (const TouchPoint& at : touch_points(a, b, follow)) {
    const double moved = (at.point - c.at.point).norm();
    if (moved >= nearest_point) continue;
    nearest_point = moved;
    found.at = at;
  }
  return found;
}

TinyWorld::Rows TinyWorld::rows_of(const Contacts& contacts, const Bodies& bodies) const {
  Rows rows;
  for (const TinyContact& c : contacts) {
    const TinyContact now = followed(c, bodies);
    Row row{.a = c.a, .b = c.b};
    row.along_a = generalised(now.at.normal, now.at.point - bodies[c.a].position);
    if (c.b >= 0) row.along_b = -generalised(now.at.normal, now.at.point - bodies[c.b].position);
    rows.push_back(row);
  }
  return rows;
}

TinyWorld::Rows TinyWorld::wheel_rows(const Bodies& bodies) const {
  Rows rows;
  for (int i = 0; i < robots_; ++i) {
    if (!has_wheels(i)) continue;
    const Vec2 forward = forward_of(bodies[i].angle);
    rows.push_back({.a = i, .along_a = {-forward.y(), forward.x(), 0.0}});
  }
  return rows;
}

double TinyWorld::rate(const Row& row, const Bodies& bodies) {
  double sum = row.along_a.dot(bodies[row.a].velocity);
  if (row.b >= 0) sum += row.along_b.dot(bodies[row.b].velocity);
  return sum;
}

// ---- a step without impacts

TinyWorld::Bodies TinyWorld::stepped(const Contacts& contacts, double h) {
  Bodies end = bodies_;
  for (Body& body : end) {
    body.position += h * in_plane(body.velocity);
    body.angle += h * body.velocity[2];
  }
  // Each pass uses the end state that the previous pass found.
  constexpr int passes = 3;
  for (int pass = 0; pass < passes; ++pass) solve_step(contacts, h, end);
  return end;
}

void TinyWorld::solve_step(const Contacts& contacts, double h, Bodies& end) {
  const int count = static_cast<int>(bodies_.size());
  Bodies middle = bodies_;
  Bodies free = end;  // the end state, but with the velocities without contact and wheel impulses
  for (int i = 0; i < count; ++i) {
    middle[i].position = 0.5 * (bodies_[i].position + end[i].position);
    middle[i].angle = 0.5 * (bodies_[i].angle + end[i].angle);
    middle[i].velocity = 0.5 * (bodies_[i].velocity + end[i].velocity);
    free[i].velocity = bodies_[i].velocity + h * force(middle[i], i).cwiseQuotient(mass(i));
  }

  // Forces act at the middle of the step; the conditions of contacts hold at its end.
  Rows acting = rows_of(contacts, middle);
  Rows judged = rows_of(contacts, end);
  for (const Row& row : wheel_rows(middle)) acting.push_back(row);
  for (const Row& row : wheel_rows(end)) judged.push_back(row);

  const Eigen::Index n = static_cast<Eigen::Index>(acting.size());
  const Eigen::Index touching = static_cast<Eigen::Index>(contacts.size());
  const double grip = p_.grip * p_.robot_mass * g * h;
  BoxConditions problem{Eigen::MatrixXd::Zero(n, n), Eigen::VectorXd::Zero(n),
                        Eigen::VectorXd::Constant(n, -grip), Eigen::VectorXd::Constant(n, grip)};
  for (Eigen::Index i = 0; i < n; ++i) {
    const Row& row = judged[i];
    for (Eigen::Index j = 0; j < n; ++j) {
      const Row& by = acting[j];
      const auto through = [&](int body, const auto& p, const auto& q) {
        return body >= 0 ? p.dot(q.cwiseQuotient(mass(body).transpose())) : 0.0;
      };
      if (row.a == by.a) problem.a(i, j) += through(row.a, row.along_a, by.along_a);
      if (row.a == by.b) problem.a(i, j) += through(row.a, row.along_a, by.along_b);
      if (row.b == by.a) problem.a(i, j) += through(row.b, row.along_b, by.along_a);
      if (row.b == by.b) problem.a(i, j) += through(row.b, row.along_b, by.along_b);
    }
    if (i >= touching) continue;
    problem.low[i] = 0.0;
    problem.high[i] = infinity;
  }

  // The ball's rolling resistance keeps it at rest if K_c m g suffices, and else opposes its motion
  // with that force. It is found in turn with the contact impulses until both agree.
  const double resistance = p_.rolling_resistance * p_.ball_mass * g * h;
  Eigen::Vector2d brake{0.0, 0.0};
  if (impulses_.size() != n) impulses_ = Eigen::VectorXd::Zero(n);
  constexpr int most_turns = 100;
  for (int turn = 0; turn < most_turns; ++turn) {
    Bodies braked = free;
    if (has_ball_) braked[robots_].velocity.head<2>() += brake / mass(robots_)[0];
    for (Eigen::Index i = 0; i < n; ++i) {
      problem.b[i] = rate(judged[i], braked);
      if (i >= touching) continue;
      const double gap = contacts[i].at.gap;
      problem.b[i] += gap > 0.0 ? gap / h : push_out * gap / step_;
    }
    if (n > 0) solve_by_sweeps(problem, impulses_);
    for (int i = 0; i < count; ++i) end[i].velocity = braked[i].velocity;
    for (Eigen::Index i = 0; i < n; ++i) {
      const Row& row = acting[i];
      const auto push = [&](int body, const Eigen::RowVector3d& along) {
        if (body < 0) return;
        end[body].velocity += impulses_[i] * along.transpose().cwiseQuotient(mass(body));
      };
      push(row.a, row.along_a);
      push(row.b, row.along_b);
    }
    if (!has_ball_) break;
    const Eigen::Vector2d unbraked = mass(robots_)[0] * end[robots_].velocity.head<2>() - brake;
    const double size = unbraked.norm();
    const Eigen::Vector2d next = size > resistance ? Eigen::Vector2d{-resistance / size * unbraked}
                                                   : Eigen::Vector2d{-unbraked};
    const double change = (next - brake).norm();
    brake = next;
    if (turn > 0 && change <= 1e-9 * resistance) break;
  }
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d mean = 0.5 * (bodies_[i].velocity + end[i].velocity);
    end[i].position = bodies_[i].position + h * in_plane(mean);
    end[i].angle = bodies_[i].angle + h * mean[2];
  }
}

// ---- time

void TinyWorld::advance(std::span<const simulator::WheelCommand> commands, double duration) {
  for (int i = 0; i < robots_; ++i) {
    drives_[i].wheels_on_ground = commands[i].has_value();
    if (!commands[i]) continue;
    const double left = std::clamp(commands[i]->left, -p_.wheel_speed_limit, p_.wheel_speed_limit);
    const double right =
        std::clamp(commands[i]->right, -p_.wheel_speed_limit, p_.wheel_speed_limit);
    drives_[i].forward = p_.wheel_radius * (right + left) / 2.0;
    drives_[i].turn = p_.wheel_radius * (right - left) / p_.wheel_distance;
    const double lag = p_.motor_time_constant;
    const bool brakes = p_.brake_time_constant > 0.0 && left == 0.0 && right == 0.0;
    drives_[i].forward_lag = brakes ? p_.brake_time_constant : lag;
    drives_[i].turn_lag = p_.turn_time_constant > 0.0 ? p_.turn_time_constant : lag;
  }
  const int steps = static_cast<int>(std::ceil(duration / step_ - 1e-9));
  const double margin = touch_speed * step_;
  for (int i = 0; i < steps; ++i) {
    double left_over = duration / steps;
    while (left_over > 0.0) {
      Contacts contacts = contacts_within(bodies_, margin);
      if (any_impact(contacts, left_over)) resolve_impacts(contacts);
      const double limit = std::min(0.0, nearest(bodies_)) - margin;
      Bodies next = stepped(contacts, left_over);
      double length = left_over;
      if (nearest(next) < limit) {
        length = length_until_inside(contacts, limit + 0.5 * margin, left_over);
        next = stepped(contacts, length);
      }
      bodies_ = next;
      left_over = length < left_over ? left_over - length : 0.0;
    }
  }
}

// Returns the length of a step after which the smallest gap is `limit`, s, by bisection.
double TinyWorld::length_until_inside(const Contacts& contacts, double limit, double h) {
  double low = 0.0;
  double high = h;
  const double enough = 0.25 * touch_speed * step_;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    const double above = nearest(stepped(contacts, middle)) - limit;
    if (std::abs(above) <= enough) return middle;
    (above > 0.0 ? low : high) = middle;
  }
  return high;
}

}  // namespace mirocup::test_support
