// SPDX-License-Identifier: MIT
//
// MuJoCo held to the plane: bodies on two slides, robots with a hinge. Its contacts are springs
// with dampers, soft on purpose; a bounce is half a period of one and takes some steps.
#include "core/base/math.hpp"
#include "labs/bench/kicks.hpp"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <mujoco/mujoco.h>

namespace mirocup::bench {

namespace {

constexpr double steps_of_bounce = 4.0;  // half a period: 2, 3 and 6 were tried, too
constexpr double impedance = 0.99;       // how much of the spring's acceleration is had
constexpr double least_restitution = 0.01;
constexpr double height = 0.05;  // m, of all boxes

class Xml {
 public:
  template <class... Numbers>
  void add(const char* format, Numbers... numbers) {
    if constexpr (sizeof...(numbers) == 0) {
      text_ += format;
    } else {
      char line[512];
      std::snprintf(line, sizeof line, format, numbers...);
      text_ += line;
    }
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

[[noreturn]] void give_up(const char* why) {
  std::fprintf(stderr, "mirocup-bench: MuJoCo does not take the scene: %s\n", why);
  std::exit(1);
}

class MuJoCo {
 public:
  MuJoCo(const Start& start, double step)
      : robots_(static_cast<int>(start.robots.size())), model_(compile(xml_of(start, step))) {
    data_ = mj_makeData(model_);
    for (int i = 0; i < robots_; ++i) {
      const simulator::BodyState& r = start.robots[i];
      mjtNum* at = data_->qpos + 3 * i;
      at[0] = r.position.x();
      at[1] = r.position.y();
      at[2] = r.heading.angle();
      set_robot_motion(i, {r.heading.to_world({r.twist.forward, r.twist.left}), r.twist.omega, {}});
    }
    data_->qpos[3 * robots_] = start.ball.position.x();
    data_->qpos[3 * robots_ + 1] = start.ball.position.y();
    set_ball_velocity(start.ball.velocity);
  }

  MuJoCo(const MuJoCo&) = delete;
  MuJoCo& operator=(const MuJoCo&) = delete;

  ~MuJoCo() {
    mj_deleteData(data_);
    mj_deleteModel(model_);
  }

  RobotMotion robot_motion(int i) const {
    const mjtNum* v = data_->qvel + 3 * i;
    return {{v[0], v[1]}, v[2], Heading::from_angle(data_->qpos[3 * i + 2])};
  }
  void set_robot_motion(int i, const RobotMotion& m) {
    mjtNum* v = data_->qvel + 3 * i;
    v[0] = m.velocity.x();
    v[1] = m.velocity.y();
    v[2] = m.turn;
  }
  Vec2 ball_velocity() const {
    const mjtNum* v = data_->qvel + 3 * robots_;
    return {v[0], v[1]};
  }
  void set_ball_velocity(const Vec2& v) {
    data_->qvel[3 * robots_] = v.x();
    data_->qvel[3 * robots_ + 1] = v.y();
  }

  void step() { mj_step(model_, data_); }

  simulator::BodyState robot(int i) const {
    const mjtNum* at = data_->qpos + 3 * i;
    return state_of({at[0], at[1]}, robot_motion(i));
  }
  simulator::BallState ball() const {
    const mjtNum* at = data_->qpos + 3 * robots_;
    return {{at[0], at[1]}, ball_velocity()};
  }

 private:
  static constexpr const char* slides =
      "<joint type=\"slide\" axis=\"1 0 0\"/><joint type=\"slide\" axis=\"0 1 0\"/>";

  // Only the pairs that are named touch, each with its own restitution.
  static std::string xml_of(const Start& start, double step) {
    const simulator::Parameters& p = start.parameters;
    const Vec2 half = half_size(p);
    Xml xml;
    xml.add(
        "<mujoco><option timestep=\"%.17g\" gravity=\"0 0 0\" solver=\"Newton\"/>"
        "<default><geom contype=\"0\" conaffinity=\"0\"/></default>",
        step);
    // As a box it would have contacts some cm deep with boxes that it does not touch.
    xml.add("<asset><mesh name=\"robot\" vertex=\"");
    for (const double x : {-half.x(), half.x()}) {
      for (const double y : {-half.y(), half.y()}) {
        for (const double z : {-height / 2.0, height / 2.0}) xml.add(" %.17g %.17g %.17g", x, y, z);
      }
    }
    xml.add("\"/></asset><worldbody>");
    const std::vector<WallBox> walls =
        start.league ? walls_of(*start.league) : std::vector<WallBox>{};
    for (std::size_t i = 0; i < walls.size(); ++i) {
      const WallBox& w = walls[i];
      xml.add("<geom name=\"w%zu\" type=\"box\" pos=\"%.17g %.17g 0\" size=\"%.17g %.17g %.17g\" ",
              i, w.centre.x(), w.centre.y(), w.half.x(), w.half.y(), height / 2.0);
      xml.add("quat=\"%.17g 0 0 %.17g\"/>", std::cos(0.5 * w.angle), std::sin(0.5 * w.angle));
    }
    for (std::size_t i = 0; i < start.robots.size(); ++i) {
      xml.add("<body>%s<joint type=\"hinge\" axis=\"0 0 1\"/>", slides);
      add_mass(p.robot_mass, p.robot_inertia(), xml);
      xml.add("<geom name=\"r%zu\" type=\"mesh\" mesh=\"robot\"/></body>", i);
    }
    xml.add("<body>%s", slides);
    add_mass(p.effective_ball_mass(), 1.0, xml);
    xml.add("<geom name=\"ball\" type=\"sphere\" size=\"%.17g\"/></body></worldbody><contact>",
            p.ball_radius);
    const simulator::PerPair& e = p.restitution;
    const auto robot = [](std::size_t i) { return "r" + std::to_string(i); };
    for (std::size_t i = 0; i < start.robots.size(); ++i) {
      add_pair("ball", robot(i), e.ball_robot, step, xml);
      for (std::size_t j = 0; j < i; ++j) add_pair(robot(j), robot(i), e.robot_robot, step, xml);
    }
    for (std::size_t w = 0; w < walls.size(); ++w) {
      const std::string wall = "w" + std::to_string(w);
      add_pair("ball", wall, e.ball_wall, step, xml);
      for (std::size_t i = 0; i < start.robots.size(); ++i) {
        add_pair(robot(i), wall, e.robot_wall, step, xml);
      }
    }
    xml.add("</contact></mujoco>");
    return xml.text();
  }

  static void add_mass(double mass, double inertia, Xml& xml) {
    xml.add("<inertial pos=\"0 0 0\" mass=\"%.17g\" diaginertia=\"%.17g %.17g %.17g\"/>", mass,
            inertia, inertia, inertia);
  }

  // x'' = -b x' - k x returns after half a period, t = pi / omega, with e^(-b t / 2) of its speed.
  static void add_pair(const std::string& one, const std::string& other, double restitution,
                       double step, Xml& xml) {
    const double half_period = steps_of_bounce * step;
    const double omega = pi / half_period;
    const double b = -2.0 * std::log(std::max(restitution, least_restitution)) / half_period;
    const double k = omega * omega + 0.25 * b * b;
    xml.add("<pair geom1=\"%s\" geom2=\"%s\" condim=\"1\" solref=\"%.17g %.17g\" ", one.c_str(),
            other.c_str(), -k * impedance, -b * impedance);
    xml.add("solimp=\"%g %g 0.001\"/>", impedance, impedance);
  }

  static mjModel* compile(const std::string& text) {
    const auto files = std::make_unique<mjVFS>();  // megabytes
    mj_defaultVFS(files.get());
    const char* name = "scene.xml";
    mj_makeEmptyFileVFS(files.get(), name, static_cast<int>(text.size()));
    std::memcpy(files->filedata[0], text.data(), text.size());
    char why[256] = "";
    mjModel* model = mj_loadXML(name, files.get(), why, sizeof why);
    mj_deleteVFS(files.get());
    if (model == nullptr) give_up(why);
    return model;
  }

  int robots_;
  mjModel* model_;
  mjData* data_ = nullptr;
};

}  // namespace

std::vector<Contender> mujoco_contenders() {
  return stepped_contenders<MuJoCo>(
      "MuJoCo",
      "Debian's 2.2.2, double; robots as convex meshes, frictionless contacts, Newton, "
      "restitution by springs whose half period is four steps");
}

}  // namespace mirocup::bench
