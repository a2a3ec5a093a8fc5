// SPDX-License-Identifier: MIT
//
// Box2D 2.4. In plain SI units its tolerances (5 mm) are a quarter of the ball, so lengths are
// scaled by 20; polygons are shrunk by the skin that Box2D puts around them.
#include "labs/bench/kicks.hpp"

#include <box2d/box2d.h>

namespace mirocup::bench {

namespace {

constexpr double scale = 20.0;  // units per metre
constexpr int velocity_iterations = 8;
constexpr int position_iterations = 3;
constexpr float slowest_bounce = static_cast<float>(0.01 * scale);  // units/s

enum class Kind : std::uintptr_t { wall, robot, ball };
enum class Bullets { ball, all };

b2Vec2 scaled(const Vec2& v) {
  return {static_cast<float>(scale * v.x()), static_cast<float>(scale * v.y())};
}

Vec2 metres(const b2Vec2& v) {
  return {v.x / scale, v.y / scale};
}

// Box2D has one restitution for each body; the model has one for each kind of pair.
class Restitution final : public b2ContactListener {
 public:
  explicit Restitution(const simulator::PerPair& e) : e_(e) {}

  void BeginContact(b2Contact* contact) override {
    const auto a = static_cast<Kind>(contact->GetFixtureA()->GetUserData().pointer);
    const auto b = static_cast<Kind>(contact->GetFixtureB()->GetUserData().pointer);
    contact->SetRestitution(static_cast<float>(of(std::min(a, b), std::max(a, b))));
    contact->SetRestitutionThreshold(slowest_bounce);
  }

 private:
  double of(Kind less, Kind more) const {
    if (more == Kind::ball) return less == Kind::wall ? e_.ball_wall : e_.ball_robot;
    return less == Kind::wall ? e_.robot_wall : e_.robot_robot;
  }

  simulator::PerPair e_;
};

class Box2d {
 public:
  Box2d(const Start& start, double step, Bullets bullets)
      : world_(b2Vec2(0.0f, 0.0f)),
        restitution_(start.parameters.restitution),
        step_(static_cast<float>(step)) {
    const simulator::Parameters& p = start.parameters;
    world_.SetContactListener(&restitution_);
    world_.SetAllowSleeping(false);
    if (start.league) add_walls(*start.league);
    for (const simulator::BodyState& r : start.robots) add_robot(p, r, bullets);
    b2CircleShape circle;
    circle.m_radius = static_cast<float>(scale * p.ball_radius);
    ball_ = add_body(start.ball.position, 0.0, circle, Kind::ball, true);
    ball_->SetFixedRotation(true);  // sets the mass, too
    set_mass(ball_, p.effective_ball_mass(), 1.0);
    set_ball_velocity(start.ball.velocity);
  }

  RobotMotion robot_motion(int i) const {
    const b2Body* body = robots_[i];
    const b2Rot& q = body->GetTransform().q;
    return {metres(body->GetLinearVelocity()), body->GetAngularVelocity(), {q.c, q.s}};
  }
  void set_robot_motion(int i, const RobotMotion& m) {
    robots_[i]->SetLinearVelocity(scaled(m.velocity));
    robots_[i]->SetAngularVelocity(static_cast<float>(m.turn));
  }
  Vec2 ball_velocity() const { return metres(ball_->GetLinearVelocity()); }
  void set_ball_velocity(const Vec2& v) { ball_->SetLinearVelocity(scaled(v)); }
  void step() { world_.Step(step_, velocity_iterations, position_iterations); }

  simulator::BodyState robot(int i) const {
    return state_of(metres(robots_[i]->GetPosition()), robot_motion(i));
  }
  simulator::BallState ball() const { return {metres(ball_->GetPosition()), ball_velocity()}; }

 private:
  b2Body* add_body(const Vec2& at, double angle, const b2Shape& shape, Kind kind, bool bullet) {
    b2BodyDef definition;
    definition.type = kind == Kind::wall ? b2_staticBody : b2_dynamicBody;
    definition.position = scaled(at);
    definition.angle = static_cast<float>(angle);
    definition.bullet = bullet;
    b2Body* body = world_.CreateBody(&definition);
    b2FixtureDef fixture;
    fixture.shape = &shape;
    fixture.density = kind == Kind::wall ? 0.0f : 1.0f;
    fixture.friction = 0.0f;
    fixture.userData.pointer = static_cast<std::uintptr_t>(kind);
    body->CreateFixture(&fixture);
    return body;
  }

  void add_robot(const simulator::Parameters& p, const simulator::BodyState& r, Bullets bullets) {
    const Vec2 half = half_size(p);
    b2PolygonShape box;
    box.SetAsBox(static_cast<float>(scale * half.x()) - b2_polygonRadius,
                 static_cast<float>(scale * half.y()) - b2_polygonRadius);
    robots_.push_back(
        add_body(r.position, r.heading.angle(), box, Kind::robot, bullets == Bullets::all));
    set_mass(robots_.back(), p.robot_mass, p.robot_inertia());
    set_robot_motion(static_cast<int>(robots_.size()) - 1,
                     {r.heading.to_world({r.twist.forward, r.twist.left}), r.twist.omega, {}});
  }

  void set_mass(b2Body* body, double mass, double inertia) {
    const b2MassData data{
        static_cast<float>(mass), {0.0f, 0.0f}, static_cast<float>(inertia * scale * scale)};
    body->SetMassData(&data);
  }

  void add_walls(RobotLeague league) {
    for (const WallBox& wall : walls_of(league)) {
      b2PolygonShape box;
      box.SetAsBox(static_cast<float>(scale * wall.half.x()) - b2_polygonRadius,
                   static_cast<float>(scale * wall.half.y()) - b2_polygonRadius);
      add_body(wall.centre, wall.angle, box, Kind::wall, false);
    }
  }

  b2World world_;
  Restitution restitution_;
  float step_;
  std::vector<b2Body*> robots_;
  b2Body* ball_ = nullptr;
};

std::string settings(const char* bullets) {
  return "Debian's " + std::to_string(b2_version.major) + "." + std::to_string(b2_version.minor) +
         "." + std::to_string(b2_version.revision) +
         ", float; 20 units per metre, skins taken off the shapes, restitution per pair from 0.01 "
         "m/s, 8/3 iterations, no sleeping, its profiling clock stubbed; " +
         bullets;
}

}  // namespace

std::vector<Contender> box2d_contenders() {
  auto all = stepped_contenders<Box2d>(
      "Box2D, all bullets", settings("ball and robots are bullets (continuous collision)"),
      Bullets::all);
  for (Contender& c : stepped_contenders<Box2d>(
           "Box2D, ball bullet", settings("only the ball is a bullet"), Bullets::ball)) {
    all.push_back(std::move(c));
  }
  return all;
}

}  // namespace mirocup::bench
