// SPDX-License-Identifier: MIT
//
// The source of a team that plays a policy.
#include "core/field/field.hpp"
#include "labs/training/policy/policy.hpp"
#include "system/text.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>

namespace mirocup::policy {

namespace {

constexpr std::string_view head =
    R"(// @NAME@: a learned team, made by `mirocup export`. It needs mirocup/strategy.h alone:
//   c++ -std=c++17 -O2 -fPIC -shared -I INCLUDE learned.cpp -o learned.so
// The same observation gives the same action everywhere: nothing is drawn and no library rounds.
#include "mirocup/elementary.h"
#include "mirocup/strategy.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <new>

namespace {

// ---- what was learned
)";

constexpr std::string_view network_code = R"(
// e^x for |x| < 700: x = k ln 2 + r with |r| < 0.35, and the series of e^r.
double exponential(double x) {
  const double k = std::floor(x * 1.4426950408889634 + 0.5);
  const double r = (x - k * 0.693147180369123816490) - k * 1.90821492927058770002e-10;
  double sum = 1.0;
  for (int i = 14; i > 0; --i) sum = 1.0 + sum * r / i;
  return std::ldexp(sum, static_cast<int>(k));
}

double hyperbolic_tangent(double x) {
  if (x > 20.0) return 1.0;
  if (x < -20.0) return -1.0;
  if (x > -0.01 && x < 0.01) {  // where 1 - e^2x would cancel
    const double s = x * x;
    return x * (1.0 - s * (1.0 / 3.0 - s * (2.0 / 15.0 - s * 17.0 / 315.0)));
  }
  const double e = exponential(2.0 * x);
  return (e - 1.0) / (e + 1.0);
}

double activated(double x) {
  return is_tanh ? hyperbolic_tangent(x) : std::max(x, 0.0);
}

void layer(const float* weights, const float* biases, int inputs, int outputs, bool is_first,
           const double* from, double* to) {
  double in[widest];
  for (int i = 0; i < inputs; ++i) in[i] = is_first ? from[i] : activated(from[i]);
  for (int o = 0; o < outputs; ++o) {
    double sum = 0.0;
    for (int i = 0; i < inputs; ++i) sum += static_cast<double>(weights[o * inputs + i]) * in[i];
    to[o] = sum + static_cast<double>(biases[o]);
  }
}

// From an observation to an action: numbers in [-1, 1].
void network(const float* observation, float* action) {
  double a[widest], b[widest];
  for (int i = 0; i < observation_size; ++i) a[i] = static_cast<double>(observation[i]);
@LAYERS@  for (int i = 0; i < action_size; ++i) {
    action[i] = static_cast<float>(std::clamp(@LAST@[i], -1.0, 1.0));
  }
}
)";

// Writes numbers in the order of the spec.
constexpr std::string_view writer_code = R"(
// ---- what it sees

// Takes the numbers of an observation one after the other, and writes them as learning had them.
class Writer {
 public:
  explicit Writer(float* to) : to_(to) {}
  void put(double value) {
    to_[at_] = static_cast<float>(std::clamp(value / scale[at_], low[at_], high[at_]));
    ++at_;
  }
  void put(double x, double y) {
    put(x);
    put(y);
  }

 private:
  float* to_;
  int at_ = 0;
};
)";

constexpr std::string_view standard_code = R"(
void put_robot(Writer& to, const mirocup_robot& r) {
  to.put(r.x, r.y);
  to.put(mirocup_cos(r.heading), mirocup_sin(r.heading));
  to.put(r.vx, r.vy);
  to.put(r.turn);
}

// The own robot `self` comes first of its team.
void observe(const mirocup_setup&, const mirocup_observation& now, int self, float* values) {
  Writer to(values);
  to.put(now.ball_x, now.ball_y);
  to.put(now.ball_vx, now.ball_vy);
  put_robot(to, now.own[self]);
  for (int i = 0; i < now.robots; ++i) {
    if (i != self) put_robot(to, now.own[i]);
  }
  for (int i = 0; i < now.robots; ++i) put_robot(to, now.opponent[i]);
  to.put(now.own_restart != 0 ? 1.0 : -1.0);
  to.put(now.stalemate_s);
}
)";

constexpr std::string_view relative_code = R"(
// All is seen from the own robot `self`, whose x points forward.
void observe(const mirocup_setup& setup, const mirocup_observation& now, int self, float* values) {
  const mirocup_robot& me = now.own[self];
  const double c = mirocup_cos(me.heading), s = mirocup_sin(me.heading);
  Writer to(values);
  const auto put_vector = [&](double x, double y) { to.put(c * x + s * y, c * y - s * x); };
  const auto put_place = [&](double x, double y) { put_vector(x - me.x, y - me.y); };
  put_place(now.ball_x, now.ball_y);
  put_vector(now.ball_vx, now.ball_vy);
  put_vector(me.vx, me.vy);
  to.put(me.turn);
  put_place(setup.half_length, 0.0);
  put_place(-setup.half_length, 0.0);
  to.put(me.x, me.y);
  to.put(c, s);
  to.put(now.ball_x, now.ball_y);
  // Directions have the length 1; that of nothing is forward. Nearness is 1/2 at 0.1 m.
  const auto length = [](double x, double y) { return std::sqrt(x * x + y * y); };
  const auto put_direction = [&](double x, double y) {
    const double d = length(x, y);
    if (d > 0.0) {
      put_vector(x / d, y / d);
    } else {
      to.put(1.0, 0.0);
    }
  };
  const auto put_nearness = [&](double x, double y) { to.put(0.1 / (0.1 + length(x, y))); };
  const double ball_x = now.ball_x - me.x, ball_y = now.ball_y - me.y;
  const double shot_x = setup.half_length - now.ball_x, shot_y = -now.ball_y;
  const double shot = length(shot_x, shot_y);
  const double gap = shot > 0.0 ? (setup.robot_side / 2.0 + setup.ball_radius) / shot : 0.0;
  const double behind_x = ball_x - gap * shot_x, behind_y = ball_y - gap * shot_y;
  put_direction(ball_x, ball_y);
  put_nearness(ball_x, ball_y);
  put_direction(setup.half_length - me.x, -me.y);
  put_direction(shot_x, shot_y);
  to.put(shot);
  put_direction(behind_x, behind_y);
  put_nearness(behind_x, behind_y);
  const auto put_robot = [&](const mirocup_robot& r) {
    put_place(r.x, r.y);
    put_vector(r.vx, r.vy);
    put_vector(mirocup_cos(r.heading), mirocup_sin(r.heading));
  };
  for (int i = 0; i < now.robots; ++i) {
    if (i != self) put_robot(now.own[i]);
  }
  for (int i = 0; i < now.robots; ++i) put_robot(now.opponent[i]);
  to.put(now.own_restart != 0 ? 1.0 : -1.0);
  to.put(now.stalemate_s);
}
)";

constexpr std::string_view vss_code = R"(
void put_motion(Writer& to, const mirocup_robot& r) {
  to.put(r.vx, r.vy);
  to.put(r.turn);
}

void put_own(Writer& to, const mirocup_robot& r) {
  to.put(r.x, r.y);
  to.put(mirocup_sin(r.heading), mirocup_cos(r.heading));
  put_motion(to, r);
}

// The own robot `self` comes first of its team.
void observe(const mirocup_setup&, const mirocup_observation& now, int self, float* values) {
  Writer to(values);
  to.put(now.ball_x, now.ball_y);
  to.put(now.ball_vx, now.ball_vy);
  put_own(to, now.own[self]);
  for (int i = 0; i < now.robots; ++i) {
    if (i != self) put_own(to, now.own[i]);
  }
  for (int i = 0; i < now.robots; ++i) {
    to.put(now.opponent[i].x, now.opponent[i].y);
    put_motion(to, now.opponent[i]);
  }
}
)";

constexpr std::string_view wheels_code = R"(
mirocup_wheels wheels_from(const mirocup_setup& setup, float a, float b) {
  const double limit = setup.wheel_speed_limit;
  return {limit * static_cast<double>(a), limit * static_cast<double>(b)};
}
)";

constexpr std::string_view drive_code = R"(
mirocup_wheels wheels_from(const mirocup_setup& setup, float forward, float turn) {
  const auto wheel = [&](double share) {
    return setup.wheel_speed_limit * std::clamp(share, -1.0, 1.0);
  };
  return {wheel(static_cast<double>(forward) - static_cast<double>(turn)),
          wheel(static_cast<double>(forward) + static_cast<double>(turn))};
}
)";

constexpr std::string_view dead_zone_code = R"(
mirocup_wheels wheels_from(const mirocup_setup& setup, float a, float b) {
  const auto wheel = [&](double share) {
    const double speed = setup.wheel_speed_limit * share;
    return std::abs(speed) * setup.wheel_radius < 0.05 ? 0.0 : speed;
  };
  return {wheel(static_cast<double>(a)), wheel(static_cast<double>(b))};
}
)";

constexpr std::string_view team_code = R"(
// ---- the team

struct Learned {
  const mirocup_setup* setup;
  mirocup_command command{};
  int held = 0;  // ticks for which the command has been held
};

void* create(const mirocup_setup* setup) {
  if (setup->robots != robots) {
    setup->log(setup->host, "this team has learned with another number of robots");
    return nullptr;
  }
  return new (std::nothrow) Learned{setup};
}

void decide(void* team, const mirocup_observation* now, mirocup_command* command) {
  Learned& self = *static_cast<Learned*>(team);
  if (now->state != MIROCUP_PLAY) {  // it has learned what begins with the whistle
    self.held = 0;
    return;
  }
  if (self.held == 0) {
    for (const auto& actor : actors) {
      float observation[observation_size], action[action_size];
      observe(*self.setup, *now, is_one_first ? actor[0] : 0, observation);
      network(observation, action);
      for (int i = 0; i < action_size / 2; ++i) {
        self.command.wheels[actor[i]] = wheels_from(*self.setup, action[2 * i], action[2 * i + 1]);
      }
    }
  }
  self.held = (self.held + 1) % ticks_per_step;
  *command = self.command;
}

void destroy(void* team) {
  delete static_cast<Learned*>(team);
}

const mirocup_strategy strategy = {
    MIROCUP_ABI_VERSION, sizeof(mirocup_strategy), "@NAME@", create, decide, destroy, nullptr};

}  // namespace

extern "C" const mirocup_strategy* mirocup_entry(void) {
  return &strategy;
}
)";

// The shortest of the usual forms that gives the same number back.
std::string number_text(double number, int digits) {
  std::array<char, 40> text;
  std::snprintf(text.data(), text.size(), "%.*g", digits, number);
  std::string result = text.data();
  if (result.find_first_of(".en") == std::string::npos) result += ".0";
  return result;
}

// "const float w0[6] = {…};" in lines of at most 100 columns.
template <class Numbers>
std::string array_code(const std::string& type, const std::string& name, const Numbers& numbers) {
  const bool is_float = type == "float";
  std::string code = "const " + type + " " + name + "[" + std::to_string(numbers.size()) + "] = {";
  std::string line;
  for (const auto number : numbers) {
    const std::string text =
        number_text(static_cast<double>(number), is_float ? 9 : 17) + (is_float ? "f" : "") + ",";
    if (line.empty() || line.size() + text.size() > 96) {
      code += line + "\n   ";
      line.clear();
    }
    line += " " + text;
  }
  return code + line + "};\n";
}

std::string constant(const std::string& name, int value) {
  return "constexpr int " + name + " = " + std::to_string(value) + ";\n";
}

std::string constant(const std::string& name, bool value) {
  return "constexpr bool " + name + " = " + (value ? "true" : "false") + ";\n";
}

std::string actors_code(const Policy& policy) {
  std::string code = "// The robots that each use of the network steers.\nconst int actors[" +
                     std::to_string(policy.actors.size()) + "][" +
                     std::to_string(policy.actors.front().size()) + "] = {";
  for (std::size_t i = 0; i < policy.actors.size(); ++i) {
    code += i == 0 ? "{" : ", {";
    for (std::size_t k = 0; k < policy.actors[i].size(); ++k) {
      code += (k == 0 ? "" : ", ") + std::to_string(policy.actors[i][k]);
    }
    code += "}";
  }
  return code + "};\n";
}

std::string learned_code(const Policy& policy, int robots) {
  const auto column = [&](double Entry::*member) {
    std::vector<double> values;
    for (const Entry& entry : policy.observation) values.push_back(entry.*member);
    return values;
  };
  int widest = 0;
  for (const Layer& layer : policy.layers) {
    widest = std::max({widest, layer.inputs, layer.outputs});
  }
  const auto& actor = policy.actors.front();
  std::string code = constant("robots", robots);
  code += constant("observation_size", static_cast<int>(policy.observation.size()));
  code += constant("action_size", static_cast<int>(2 * actor.size()));
  code += constant("ticks_per_step", policy.ticks_per_step);
  code += constant("widest", widest);
  code += constant("is_tanh", policy.activation == Activation::tanh);
  // A learner that is one of several robots sees itself first.
  const bool sees_itself = policy.actors.size() > 1 || policy.sight == Sight::relative;
  code += constant("is_one_first", sees_itself && actor.size() == 1);
  code += actors_code(policy);
  code += "// An observed number is clamp(value / scale, low, high).\n";
  code += array_code("double", "scale", column(&Entry::scale));
  code += array_code("double", "low", column(&Entry::low));
  code += array_code("double", "high", column(&Entry::high));
  code += "// Layers: a row of weights for each output.\n";
  for (std::size_t i = 0; i < policy.layers.size(); ++i) {
    code += array_code("float", "w" + std::to_string(i), policy.layers[i].weights);
    code += array_code("float", "b" + std::to_string(i), policy.layers[i].biases);
  }
  return code;
}

std::string network_of(const Policy& policy) {
  std::string calls;
  const char* from = "a";
  const char* to = "b";
  for (std::size_t i = 0; i < policy.layers.size(); ++i) {
    const std::string n = std::to_string(i);
    calls += "  layer(w" + n + ", b" + n + ", " + std::to_string(policy.layers[i].inputs) + ", " +
             std::to_string(policy.layers[i].outputs) + ", " + (i == 0 ? "true" : "false") + ", " +
             from + ", " + to + ");\n";
    std::swap(from, to);
  }
  return system::replaced(system::replaced(std::string(network_code), "@LAYERS@", calls), "@LAST@",
                          from);
}

std::string_view sight_of(Sight sight) {
  switch (sight) {
    case Sight::standard:
      return standard_code;
    case Sight::relative:
      return relative_code;
    case Sight::vss:
      break;
  }
  return vss_code;
}

std::string_view steering_of(Steering steering) {
  switch (steering) {
    case Steering::wheels:
      return wheels_code;
    case Steering::drive:
      return drive_code;
    case Steering::vss:
      break;
  }
  return dead_zone_code;
}

}  // namespace

std::string source_of(const Policy& policy, const std::string& name) {
  std::string code(head);
  code += learned_code(policy, field::make_field(policy.league).robots_per_team);
  code += network_of(policy);
  code += writer_code;
  code += sight_of(policy.sight);
  code += "\n// ---- what it does\n";
  code += steering_of(policy.steering);
  code += team_code;
  return system::replaced(std::move(code), "@NAME@", name);
}

}  // namespace mirocup::policy
