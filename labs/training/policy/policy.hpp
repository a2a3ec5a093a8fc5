// SPDX-License-Identifier: MIT
//
// A learned network that plays as a team: its observation, its action, and its layers. The file of
// a policy, "mirocup/policy/1", is an .npz of numpy.savez; labs/docs/training.md describes its
// arrays.
//
// The file may come from a stranger: the program reads it with limits, and runs nothing in it.
#pragma once

#include "core/base/error.hpp"
#include "core/field/league.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace mirocup::policy {

enum class Activation { tanh, relu };

// The kind of observation and of action, as in training.
enum class Sight { standard, relative, vss };
enum class Steering { wheels, drive, vss };

// A number of an observation: clamp(value / scale, low, high).
struct Entry {
  std::string name;
  double scale = 1.0;
  double low = -1.0;
  double high = 1.0;
};

// A layer: multiplies with the weights (a row for each output) and adds the biases.
struct Layer {
  int inputs = 0;
  int outputs = 0;
  std::vector<float> weights;
  std::vector<float> biases;
};

struct Policy {
  RobotLeague league = RobotLeague::small;
  Sight sight = Sight::standard;
  Steering steering = Steering::wheels;
  int ticks_per_step = 1;                // control periods for which an action holds
  std::vector<std::vector<int>> actors;  // the network acts once for each list of robots
  std::vector<Entry> observation;
  Activation activation = Activation::tanh;
  std::vector<Layer> layers;
};

// Reads the bytes of a policy. Errors: Errc::damaged if the file is not an .npz; Errc::input, with
// `path` and the array or key, if the file is not a policy.
Result<Policy> parse_policy(std::string_view bytes, const std::string& path);

// Returns the source of a team in C++17 that needs strategy.h alone. `name` is the name of the
// team. The results of the team depend on the observation only: the team computes in double
// precision, with its own tanh, and rounds observations and actions to float as training does.
std::string source_of(const Policy& policy, const std::string& name);

}  // namespace mirocup::policy

namespace mirocup {

template <>
inline constexpr std::array<std::string_view, 2> enum_names<policy::Activation>{"tanh", "relu"};
template <>
inline constexpr std::array<std::string_view, 3> enum_names<policy::Sight>{"standard", "relative",
                                                                           "vss"};
template <>
inline constexpr std::array<std::string_view, 3> enum_names<policy::Steering>{"wheels", "drive",
                                                                              "vss"};

}  // namespace mirocup
