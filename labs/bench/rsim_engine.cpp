// SPDX-License-Identifier: MIT
#include "labs/bench/rsim_engine.hpp"

#ifndef MIROCUP_BENCH_ODE

namespace mirocup::bench {

struct RsimEngine::World {};
RsimEngine::RsimEngine() = default;
RsimEngine::~RsimEngine() = default;
bool RsimEngine::is_built_in() {
  return false;
}
void RsimEngine::step() {}

}  // namespace mirocup::bench

#else

#include "core/base/math.hpp"
#include "core/base/random.hpp"

#include <array>
#include <ode/ode.h>
#include <vector>

namespace mirocup::bench {

namespace {

// The numbers of rSim's VSS robots, ball and field (3 a side). Metres, kilograms, N m, rad/s.
constexpr double robot_half = 0.0375;
constexpr double robot_height = 0.056;
constexpr double robot_z = 0.030;  // of its centre
constexpr double chassis_mass = 0.296 * 0.99;
constexpr double wheel_radius = 0.026;
constexpr double wheel_thickness = 0.0025;
constexpr double wheel_mass = 0.021;
constexpr double caster_radius = 0.002;
constexpr double caster_mass = 0.001;
constexpr double motor_torque = 0.0211;
constexpr double motor_speed = 1270.0 * 2.0 * pi / 60.0;
constexpr double mu_across = 1.0;
constexpr double mu_along = 0.8413767350560942;
constexpr double ball_radius = 0.0215;
constexpr double ball_mass = 0.043;
constexpr double ball_friction = 0.01;
constexpr double gravity = 9.81;
constexpr double length = 1.5, width = 1.3, goal_depth = 0.1, goal_width = 0.4, thick = 0.025;
constexpr double wall_height = 0.4;

constexpr double step_s = 0.025;
constexpr int engine_steps = 5;
constexpr int most_contacts = 10;
constexpr int robots = 6;

enum class Surface { plain, wheel, ball };

}  // namespace

struct RsimEngine::World {
  World();
  ~World();
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  void add_robot(double x, double y);
  void add_walls();
  void add_wall(double x, double y, double size_x, double size_y, double angle);
  dBodyID add_body(dGeomID geom, const dMass& mass, double x, double y, double z);
  void step();
  void roll_ball();
  template <Surface surface>
  static void meet(void* self, dGeomID a, dGeomID b) {
    static_cast<World*>(self)->collide(surface, a, b);
  }
  void collide(Surface surface, dGeomID a, dGeomID b);

  dWorldID world;
  dSpaceID chassis, wheels, walls;
  dGeomID ground, ball;
  dBodyID ball_body;
  dJointGroupID contacts;
  std::vector<dJointID> motors;
  Random random{7};
};

RsimEngine::World::World() {
  static const int once = dInitODE2(0);
  (void)once;
  world = dWorldCreate();
  dWorldSetGravity(world, 0.0, 0.0, -gravity);
  chassis = dSimpleSpaceCreate(nullptr);
  wheels = dSimpleSpaceCreate(nullptr);
  walls = dSimpleSpaceCreate(nullptr);
  contacts = dJointGroupCreate(0);
  ground = dCreatePlane(nullptr, 0.0, 0.0, 1.0, 0.0);
  ball = dCreateSphere(nullptr, ball_radius);
  dMass mass;
  dMassSetSphereTotal(&mass, ball_mass, ball_radius);
  ball_body = add_body(ball, mass, 0.05, 0.02, ball_radius);
  add_walls();
  for (int i = 0; i < robots; ++i) {
    const double x = 0.35 * (i % 3 - 1);
    add_robot(x + 0.1, i < 3 ? -0.3 : 0.3);
  }
}

RsimEngine::World::~World() {
  dJointGroupDestroy(contacts);
  dGeomDestroy(ground);
  dGeomDestroy(ball);
  dSpaceDestroy(chassis);
  dSpaceDestroy(wheels);
  dSpaceDestroy(walls);
  dWorldDestroy(world);
}

dBodyID RsimEngine::World::add_body(dGeomID geom, const dMass& mass, double x, double y, double z) {
  const dBodyID body = dBodyCreate(world);
  dBodySetPosition(body, x, y, z);
  dBodySetMass(body, &mass);
  dGeomSetBody(geom, body);
  return body;
}

// A chassis, two wheels with hinge and motor, four casters with a hinge each.
void RsimEngine::World::add_robot(double x, double y) {
  dMass mass;
  const double side = 2.0 * robot_half;
  dMassSetBoxTotal(&mass, chassis_mass, side, side, robot_height);
  const dBodyID body = add_body(dCreateBox(chassis, side, side, robot_height), mass, x, y, robot_z);
  const auto join = [&](dBodyID part, double axis_x, double axis_y) {
    const dJointID hinge = dJointCreateHinge(world, nullptr);
    dJointAttach(hinge, body, part);
    const dReal* at = dBodyGetPosition(part);
    dJointSetHingeAxis(hinge, axis_x, axis_y, 0.0);
    dJointSetHingeAnchor(hinge, at[0], at[1], at[2]);
  };
  for (const double left : {1.0, -1.0}) {
    dMassSetCylinderTotal(&mass, wheel_mass, 1, wheel_radius, wheel_thickness);
    const dBodyID wheel = add_body(dCreateCylinder(wheels, wheel_radius, wheel_thickness), mass, x,
                                   y + left * (robot_half + wheel_thickness / 2.0), wheel_radius);
    dQuaternion turned;
    dQFromAxisAndAngle(turned, -left, 0.0, 0.0, pi / 2.0);
    dBodySetQuaternion(wheel, turned);
    join(wheel, 0.0, left);
    const dJointID motor = dJointCreateAMotor(world, nullptr);
    dJointAttach(motor, body, wheel);
    dJointSetAMotorNumAxes(motor, 1);
    dJointSetAMotorAxis(motor, 0, 1, 0.0, left, 0.0);
    dJointSetAMotorParam(motor, dParamFMax, motor_torque);
    motors.push_back(motor);
  }
  for (const double forward : {1.0, -1.0}) {
    for (const double left : {1.0, -1.0}) {
      dMassSetSphereTotal(&mass, caster_mass, caster_radius);
      const double out = robot_half - caster_radius;
      const dBodyID caster = add_body(dCreateSphere(wheels, caster_radius), mass, x + forward * out,
                                      y + left * out, caster_radius + 0.0001);
      join(caster, forward, left);
    }
  }
}

void RsimEngine::World::add_wall(double x, double y, double size_x, double size_y, double angle) {
  const dGeomID wall = dCreateBox(walls, size_x, size_y, wall_height);
  dMatrix3 turned;
  dRFromAxisAndAngle(turned, 0.0, 0.0, 1.0, angle);
  dGeomSetPosition(wall, x, y, 0.0);
  dGeomSetRotation(wall, turned);
}

void RsimEngine::World::add_walls() {
  const double x = length / 2.0 + thick / 2.0;
  const double y = width / 2.0 + thick / 2.0;
  const double beside = (2.0 * y - goal_width) / 2.0;  // an end wall
  const double deep = goal_depth + thick;
  const double post = (goal_width + thick) / 2.0;
  for (const double side : {-1.0, 1.0}) {
    add_wall(0.0, side * y, 2.0 * x, thick, 0.0);
    add_wall(side * (x + goal_depth), 0.0, thick, goal_width, 0.0);
    for (const double up : {-1.0, 1.0}) {
      add_wall(side * x, up * (post + beside / 2.0), thick, beside, 0.0);
      add_wall(side * (length + deep) / 2.0, up * post, deep, thick, 0.0);
      add_wall(side * (x - deep / 2.8), up * (y - deep / 2.8), deep, thick,
               side * up > 0.0 ? -pi / 4.0 : pi / 4.0);
    }
  }
}

void RsimEngine::World::collide(Surface surface, dGeomID a, dGeomID b) {
  std::array<dContact, most_contacts> found;
  const int count = dCollide(a, b, most_contacts, &found[0].geom, sizeof(dContact));
  for (int i = 0; i < count; ++i) {
    dContact& contact = found[static_cast<std::size_t>(i)];
    contact.surface = {};
    contact.surface.mode = dContactApprox1;
    contact.surface.mu = 0.5;
    if (surface == Surface::ball) {
      contact.surface.mode |= dContactBounce;
      contact.surface.mu = 1.0;
      contact.surface.bounce = 0.5;
      contact.surface.bounce_vel = 0.1;
    } else if (surface == Surface::wheel) {
      const dBodyID wheel = dGeomGetBody(a) != nullptr ? dGeomGetBody(a) : dGeomGetBody(b);
      const dReal* r = dBodyGetRotation(wheel);
      contact.surface.mode |= dContactFDir1 | dContactMu2 | dContactSoftCFM;
      contact.surface.mu = mu_across;
      contact.surface.mu2 = mu_along;
      contact.surface.soft_cfm = 0.002;
      contact.fdir1[0] = r[2];
      contact.fdir1[1] = r[6];
      contact.fdir1[2] = contact.fdir1[3] = 0.0;
    }
    dJointAttach(dJointCreateContact(world, contacts, &contact), dGeomGetBody(contact.geom.g1),
                 dGeomGetBody(contact.geom.g2));
  }
}

// Rolling resistance as a force and a torque; a slow ball stands.
void RsimEngine::World::roll_ball() {
  const dReal* v = dBodyGetLinearVel(ball_body);
  const double speed = dSqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  if (speed <= 0.01) {
    dBodySetAngularVel(ball_body, 0.0, 0.0, 0.0);
    dBodySetLinearVel(ball_body, 0.0, 0.0, 0.0);
    return;
  }
  const double force = ball_friction * ball_mass * gravity;
  const double x = -force * v[0] / speed;
  const double y = -force * v[1] / speed;
  dBodyAddTorque(ball_body, -y * ball_radius, x * ball_radius, 0.0);
  dBodyAddForce(ball_body, x, y, 0.0);
}

void RsimEngine::World::step() {
  for (const dJointID motor : motors) {
    dJointSetAMotorParam(motor, dParamVel, random.uniform(-motor_speed, motor_speed));
  }
  const auto group = [](dSpaceID space) { return reinterpret_cast<dGeomID>(space); };
  for (int i = 0; i < engine_steps; ++i) {
    roll_ball();
    dSpaceCollide2(group(wheels), ground, this, &meet<Surface::wheel>);
    dSpaceCollide2(ball, ground, this, &meet<Surface::ball>);
    dSpaceCollide2(group(chassis), ball, this, &meet<Surface::plain>);
    dSpaceCollide2(ball, group(walls), this, &meet<Surface::ball>);
    dSpaceCollide2(group(chassis), group(walls), this, &meet<Surface::plain>);
    dSpaceCollide(chassis, this, &meet<Surface::plain>);
    dWorldStep(world, step_s / engine_steps);
    dJointGroupEmpty(contacts);
  }
}

RsimEngine::RsimEngine() : world_(std::make_unique<World>()) {}
RsimEngine::~RsimEngine() = default;

bool RsimEngine::is_built_in() {
  return true;
}

void RsimEngine::step() {
  world_->step();
}

}  // namespace mirocup::bench

#endif
