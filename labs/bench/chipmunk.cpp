// SPDX-License-Identifier: MIT
//
// Chipmunk 7. Its restitution is the product of both shapes'; as no three numbers give all four
// products of the model, each wall is there twice: once for the ball, once for robots.
#include "labs/bench/kicks.hpp"

#include <chipmunk/chipmunk.h>

namespace mirocup::bench {

namespace {

constexpr int iterations = 10;
constexpr double slop = 1e-4;            // m
constexpr double overlap_kept = 0.5;     // in 1/60 s
constexpr double bias_intervals = 60.0;  // per second

constexpr cpBitmask wall_for_ball = 1, wall_for_robots = 2, is_robot = 4, is_ball = 8;

cpVect to_cp(const Vec2& v) {
  return cpv(v.x(), v.y());
}

Vec2 from_cp(const cpVect& v) {
  return {v.x, v.y};
}

class Chipmunk {
 public:
  Chipmunk(const Start& start, double step) : space_(cpSpaceNew()), step_(step) {
    const simulator::Parameters& p = start.parameters;
    cpSpaceSetIterations(space_, iterations);
    cpSpaceSetCollisionSlop(space_, slop);
    cpSpaceSetCollisionBias(space_, std::pow(overlap_kept, bias_intervals));
    robot_elasticity_ = std::sqrt(p.restitution.robot_robot);
    ball_elasticity_ = p.restitution.ball_robot / robot_elasticity_;
    if (start.league) add_walls(*start.league, p.restitution);
    const Vec2 half = half_size(p);
    for (const simulator::BodyState& r : start.robots) {
      cpBody* body = add_body(p.robot_mass, p.robot_inertia(), r.position);
      cpBodySetAngle(body, r.heading.angle());
      add_shape(cpBoxShapeNew(body, 2.0 * half.x(), 2.0 * half.y(), 0.0), robot_elasticity_,
                is_robot, ~wall_for_ball);
      robots_.push_back(body);
      set_robot_motion(static_cast<int>(robots_.size()) - 1,
                       {r.heading.to_world({r.twist.forward, r.twist.left}), r.twist.omega, {}});
    }
    ball_ = add_body(p.effective_ball_mass(), INFINITY, start.ball.position);
    add_shape(cpCircleShapeNew(ball_, p.ball_radius, cpvzero), ball_elasticity_, is_ball,
              ~wall_for_robots);
    set_ball_velocity(start.ball.velocity);
  }

  Chipmunk(const Chipmunk&) = delete;
  Chipmunk& operator=(const Chipmunk&) = delete;

  ~Chipmunk() {
    for (cpShape* shape : shapes_) {
      cpSpaceRemoveShape(space_, shape);
      cpShapeFree(shape);
    }
    for (cpBody* body : bodies_) {
      cpSpaceRemoveBody(space_, body);
      cpBodyFree(body);
    }
    cpSpaceFree(space_);
  }

  RobotMotion robot_motion(int i) const {
    const cpVect q = cpBodyGetRotation(robots_[i]);
    return {
        from_cp(cpBodyGetVelocity(robots_[i])), cpBodyGetAngularVelocity(robots_[i]), {q.x, q.y}};
  }
  void set_robot_motion(int i, const RobotMotion& m) {
    cpBodySetVelocity(robots_[i], to_cp(m.velocity));
    cpBodySetAngularVelocity(robots_[i], m.turn);
  }
  Vec2 ball_velocity() const { return from_cp(cpBodyGetVelocity(ball_)); }
  void set_ball_velocity(const Vec2& v) { cpBodySetVelocity(ball_, to_cp(v)); }
  void step() { cpSpaceStep(space_, step_); }

  simulator::BodyState robot(int i) const {
    return state_of(from_cp(cpBodyGetPosition(robots_[i])), robot_motion(i));
  }
  simulator::BallState ball() const { return {from_cp(cpBodyGetPosition(ball_)), ball_velocity()}; }

 private:
  cpBody* add_body(double mass, double inertia, const Vec2& at) {
    cpBody* body = cpSpaceAddBody(space_, cpBodyNew(mass, inertia));
    cpBodySetPosition(body, to_cp(at));
    bodies_.push_back(body);
    return body;
  }

  void add_shape(cpShape* shape, double elasticity, cpBitmask category, cpBitmask meets) {
    cpShapeSetElasticity(shape, elasticity);
    cpShapeSetFriction(shape, 0.0);
    cpShapeSetFilter(shape, cpShapeFilterNew(CP_NO_GROUP, category, meets));
    shapes_.push_back(cpSpaceAddShape(space_, shape));
  }

  void add_walls(RobotLeague league, const simulator::PerPair& e) {
    for (const WallBox& wall : walls_of(league)) {
      const Heading along = Heading::from_angle(wall.angle);
      cpVect corners[4];
      for (int i = 0; i < 4; ++i) {
        const double x = i == 0 || i == 3 ? -wall.half.x() : wall.half.x();
        const double y = i < 2 ? -wall.half.y() : wall.half.y();
        corners[i] = to_cp(wall.centre + along.to_world({x, y}));
      }
      cpBody* still = cpSpaceGetStaticBody(space_);
      add_shape(cpPolyShapeNewRaw(still, 4, corners, 0.0), e.ball_wall / ball_elasticity_,
                wall_for_ball, CP_ALL_CATEGORIES);
      add_shape(cpPolyShapeNewRaw(still, 4, corners, 0.0), e.robot_wall / robot_elasticity_,
                wall_for_robots, CP_ALL_CATEGORIES);
    }
  }

  cpSpace* space_;
  double step_;
  double robot_elasticity_ = 0.0, ball_elasticity_ = 0.0;
  std::vector<cpBody*> robots_, bodies_;
  std::vector<cpShape*> shapes_;
  cpBody* ball_ = nullptr;
};

}  // namespace

std::vector<Contender> chipmunk_contenders() {
  return stepped_contenders<Chipmunk>(
      "Chipmunk", std::string(cpVersionString) +
                      ", double; 10 iterations, slop 0.1 mm, half of an overlap taken back in "
                      "1/60 s, restitution per pair, no sleeping; Debian's build has its "
                      "assertions on: a release build is about 1.6 times as fast");
}

}  // namespace mirocup::bench
