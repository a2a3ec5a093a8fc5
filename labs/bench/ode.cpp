// SPDX-License-Identifier: MIT
//
// ODE held to the plane: spheres and boxes, each with a joint that keeps it there. The contacts
// above and below the plane mirror each other; one of them is kept, in the plane.
#include "labs/bench/kicks.hpp"

#include <ode/ode.h>
#ifdef __SSE2__
#include <xmmintrin.h>
#endif

namespace mirocup::bench {

namespace {

constexpr double error_reduction = 0.2;
constexpr double force_mixing = 1e-10;
constexpr double slowest_bounce = 0.05;  // m/s
constexpr double height = 0.05;          // m, of all boxes
constexpr int most_contacts = 8;         // of a pair

// Denormal numbers make ODE up to twice as slow: they count as zero while it works.
class WithoutDenormals {
#ifdef __SSE2__
 public:
  WithoutDenormals() : before_(_mm_getcsr()) {
    _mm_setcsr(before_ | 0x8040u);
  }
  ~WithoutDenormals() {
    _mm_setcsr(before_);
  }

 private:
  unsigned before_;
#endif
};

class Ode {
 public:
  Ode(const Start& start, double step)
      : step_(step), restitution_(start.parameters.restitution), robots_(start.robots.size()) {
    static const int once = dInitODE2(0);
    (void)once;
    const simulator::Parameters& p = start.parameters;
    world_ = dWorldCreate();
    space_ = dSimpleSpaceCreate(nullptr);
    joints_ = dJointGroupCreate(0);
    dWorldSetERP(world_, error_reduction);
    dWorldSetCFM(world_, force_mixing);
    dWorldSetAutoDisableFlag(world_, 0);
    const Vec2 half = half_size(p);
    for (std::size_t i = 0; i < robots_.size(); ++i) {
      const simulator::BodyState& r = start.robots[i];
      robots_[i] = add_body(p.robot_mass, p.robot_inertia(), r.position,
                            dCreateBox(space_, 2.0 * half.x(), 2.0 * half.y(), height));
      dMatrix3 turned;
      dRFromAxisAndAngle(turned, 0.0, 0.0, 1.0, r.heading.angle());
      dBodySetRotation(robots_[i], turned);
      set_robot_motion(static_cast<int>(i),
                       {r.heading.to_world({r.twist.forward, r.twist.left}), r.twist.omega, {}});
    }
    ball_ = add_body(p.effective_ball_mass(), 1.0, start.ball.position,
                     dCreateSphere(space_, p.ball_radius));
    set_ball_velocity(start.ball.velocity);
    if (start.league) add_walls(*start.league);
  }

  Ode(const Ode&) = delete;
  Ode& operator=(const Ode&) = delete;

  ~Ode() {
    dJointGroupDestroy(joints_);
    dSpaceDestroy(space_);
    dWorldDestroy(world_);
  }

  RobotMotion robot_motion(int i) const {
    const dReal* v = dBodyGetLinearVel(robots_[i]);
    const dReal* rotation = dBodyGetRotation(robots_[i]);
    return {{v[0], v[1]}, dBodyGetAngularVel(robots_[i])[2], {rotation[0], rotation[4]}};
  }
  void set_robot_motion(int i, const RobotMotion& m) {
    dBodySetLinearVel(robots_[i], m.velocity.x(), m.velocity.y(), 0.0);
    dBodySetAngularVel(robots_[i], 0.0, 0.0, m.turn);
  }
  Vec2 ball_velocity() const {
    const dReal* v = dBodyGetLinearVel(ball_);
    return {v[0], v[1]};
  }
  void set_ball_velocity(const Vec2& v) {
    dBodySetLinearVel(ball_, v.x(), v.y(), 0.0);
    dBodySetAngularVel(ball_, 0.0, 0.0, 0.0);
  }

  void step() {
    const WithoutDenormals for_now;
    dSpaceCollide(space_, this, &Ode::meet);
    dWorldStep(world_, step_);
    dJointGroupEmpty(joints_);
  }

  simulator::BodyState robot(int i) const {
    const dReal* at = dBodyGetPosition(robots_[i]);
    return state_of({at[0], at[1]}, robot_motion(i));
  }
  simulator::BallState ball() const {
    const dReal* at = dBodyGetPosition(ball_);
    return {{at[0], at[1]}, ball_velocity()};
  }

 private:
  static void meet(void* self, dGeomID a, dGeomID b) { static_cast<Ode*>(self)->collide(a, b); }

  void collide(dGeomID a, dGeomID b) {
    const dBodyID body_a = dGeomGetBody(a);
    const dBodyID body_b = dGeomGetBody(b);
    if (body_a == nullptr && body_b == nullptr) return;
    dContact contacts[most_contacts];
    const int count = dCollide(a, b, most_contacts, &contacts[0].geom, sizeof(dContact));
    const bool has_ball = body_a == ball_ || body_b == ball_;
    const bool has_wall = body_a == nullptr || body_b == nullptr;
    const double e = has_ball ? (has_wall ? restitution_.ball_wall : restitution_.ball_robot)
                              : (has_wall ? restitution_.robot_wall : restitution_.robot_robot);
    for (int i = 0; i < count; ++i) {
      dContact& c = contacts[i];
      if (c.geom.pos[2] < -1e-6) continue;  // the same is there above the plane
      c.geom.pos[2] = 0.0;
      c.surface = {};
      c.surface.mode = dContactBounce;
      c.surface.bounce = e;
      c.surface.bounce_vel = slowest_bounce;
      dJointAttach(dJointCreateContact(world_, joints_, &c), body_a, body_b);
    }
  }

  dBodyID add_body(double mass, double inertia, const Vec2& at, dGeomID shape) {
    const dBodyID body = dBodyCreate(world_);
    dMass m;
    dMassSetParameters(&m, mass, 0.0, 0.0, 0.0, inertia, inertia, inertia, 0.0, 0.0, 0.0);
    dBodySetMass(body, &m);
    dBodySetPosition(body, at.x(), at.y(), 0.0);
    dBodySetGyroscopicMode(body, 0);
    dGeomSetBody(shape, body);
    dJointAttach(dJointCreatePlane2D(world_, nullptr), body, nullptr);
    return body;
  }

  void add_walls(RobotLeague league) {
    for (const WallBox& wall : walls_of(league)) {
      const dGeomID box = dCreateBox(space_, 2.0 * wall.half.x(), 2.0 * wall.half.y(), height);
      dMatrix3 turned;
      dRFromAxisAndAngle(turned, 0.0, 0.0, 1.0, wall.angle);
      dGeomSetPosition(box, wall.centre.x(), wall.centre.y(), 0.0);
      dGeomSetRotation(box, turned);
    }
  }

  double step_;
  simulator::PerPair restitution_;
  dWorldID world_ = nullptr;
  dSpaceID space_ = nullptr;
  dJointGroupID joints_ = nullptr;
  std::vector<dBodyID> robots_;
  dBodyID ball_ = nullptr;
};

}  // namespace

std::vector<Contender> ode_contenders() {
  return stepped_contenders<Ode>(
      "ODE",
      "Debian's, double; boxes and a sphere held to the plane, dWorldStep (exact), ERP 0.2, "
      "CFM 1e-10, bounces from 0.05 m/s, denormals as zero");
}

}  // namespace mirocup::bench
