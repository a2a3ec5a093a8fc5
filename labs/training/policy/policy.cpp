// SPDX-License-Identifier: MIT
#include "labs/training/policy/policy.hpp"

#include "core/field/field.hpp"
#include "labs/training/policy/npz.hpp"
#include "record/json_reader.hpp"

#include <algorithm>
#include <cmath>

namespace mirocup::policy {

namespace {

using record::JsonReader;

constexpr std::string_view policy_schema = "mirocup/policy/1";
constexpr std::string_view spec_schema = "mirocup/training-spec/1";
constexpr std::size_t max_layers = 16;
constexpr std::size_t max_numbers = 4096;  // of an observation or of a layer
constexpr double max_scale = 1e6;

Entry read_entry(const JsonReader& json) {
  Entry entry;
  entry.name = json.at("name").text();
  entry.scale = json.at("scale").positive_number();
  entry.low = json.at("low").number(-max_scale, max_scale);
  entry.high = json.at("high").number(entry.low, max_scale);
  return entry;
}

// The keys of the environment's spec that say how the team plays.
Policy read_spec(const JsonReader& json) {
  Policy policy;
  if (!json.expect_object()) return policy;
  json.expect_schema(spec_schema);
  policy.league = json.at("league").name<RobotLeague>();
  policy.sight = json.at("observation_kind").name<Sight>();
  policy.steering = json.at("action_kind").name<Steering>();
  policy.ticks_per_step = json.at("ticks_per_step").integer<int>(1, 1000);
  const int robots = field::make_field(policy.league).robots_per_team;
  std::string team;
  for (const JsonReader& slot : json.at("slots").elements(1, 2 * max_robots_per_team)) {
    if (team.empty()) team = slot.at("team").text();
    if (slot.at("team").text() != team) continue;  // self-play: the other team is the same
    std::vector<int>& actor = policy.actors.emplace_back();
    for (const JsonReader& robot :
         slot.at("robots").elements(1, static_cast<std::size_t>(robots))) {
      actor.push_back(robot.integer<int>(0, robots - 1));
    }
  }
  for (const JsonReader& entry : json.at("observation").elements(1, max_numbers)) {
    policy.observation.push_back(read_entry(entry));
  }
  return policy;
}

class Arrays {
 public:
  Arrays(std::map<std::string, Array> arrays, std::string path)
      : arrays_(std::move(arrays)), path_(std::move(path)) {}

  Result<std::string> text(const std::string& name) const {
    const auto found = arrays_.find(name);
    if (found == arrays_.end() || !found->second.is_text) {
      return fail(Errc::input, path_ + ": the text " + name + " is missing");
    }
    return found->second.text;
  }
  const Array* numbers(const std::string& name) const {
    const auto found = arrays_.find(name);
    return found == arrays_.end() || found->second.is_text ? nullptr : &found->second;
  }
  // What is there besides the named ones; "" if nothing is.
  std::string other_than(const std::vector<std::string>& names) const {
    for (const auto& [name, ignored] : arrays_) {
      if (std::find(names.begin(), names.end(), name) == names.end()) return name;
    }
    return "";
  }

 private:
  std::map<std::string, Array> arrays_;
  std::string path_;
};

std::string sizes_text(const Array& array) {
  std::string text;
  for (const std::size_t n : array.shape) text += (text.empty() ? "" : ", ") + std::to_string(n);
  return "(" + text + ")";
}

Result<Layer> layer_of(const Array& weights, const Array* biases, int inputs,
                       const std::string& where) {
  const std::string expected = " (outputs, " + std::to_string(inputs) + ")";
  if (weights.shape.size() != 2 || weights.shape[1] != static_cast<std::size_t>(inputs) ||
      weights.shape[0] == 0 || weights.shape[0] > max_numbers) {
    return fail(Errc::input, where + ": weights of shape" + expected + " are expected, not " +
                                 sizes_text(weights));
  }
  if (biases == nullptr || biases->shape != std::vector<std::size_t>{weights.shape[0]}) {
    return fail(Errc::input, where + ": one bias for each output is expected");
  }
  for (const Array* array : {&weights, biases}) {
    for (const float number : array->numbers) {
      if (!std::isfinite(number)) return fail(Errc::input, where + ": a number is not finite");
    }
  }
  return Layer{.inputs = inputs,
               .outputs = static_cast<int>(weights.shape[0]),
               .weights = weights.numbers,
               .biases = biases->numbers};
}

Result<void> read_layers(const Arrays& arrays, const std::string& path, Policy& policy) {
  std::vector<std::string> names{"schema", "spec", "activation"};
  int inputs = static_cast<int>(policy.observation.size());
  for (std::size_t i = 0; i < max_layers; ++i) {
    const std::string number = std::to_string(i);
    const Array* weights = arrays.numbers("w" + number);
    if (weights == nullptr) break;
    names.insert(names.end(), {"w" + number, "b" + number});
    MIROCUP_TRY(auto layer, layer_of(*weights, arrays.numbers("b" + number), inputs,
                                     path + ": layer " + number));
    inputs = layer.outputs;
    policy.layers.push_back(std::move(layer));
  }
  if (policy.layers.empty()) return fail(Errc::input, path + ": the array w0 is missing");
  const std::string unknown = arrays.other_than(names);
  if (!unknown.empty()) return fail(Errc::input, path + ": the array " + unknown + " is unknown");
  const std::size_t numbers = 2 * policy.actors.front().size();
  if (static_cast<std::size_t>(inputs) != numbers) {
    return fail(Errc::input, path + ": the last layer has " + std::to_string(inputs) +
                                 " outputs, but an action has " + std::to_string(numbers) +
                                 " numbers");
  }
  return {};
}

// How many numbers an observation has.
std::size_t numbers_of(Sight sight, int robots) {
  const auto n = static_cast<std::size_t>(robots);
  if (sight == Sight::standard) return 4 + 14 * n + 2;
  if (sight == Sight::relative) return 28 + 6 * (2 * n - 1) + 2;
  return 4 + 12 * n;
}

Result<void> check_actors(const Policy& policy, const std::string& path) {
  for (const auto& actor : policy.actors) {
    if (actor.size() != policy.actors.front().size()) {
      return fail(
          Errc::input,
          path + ": spec: /slots: all learners of a team must have the same number of robots");
    }
    if (policy.sight == Sight::relative && actor.size() != 1) {
      return fail(Errc::input, path +
                                   ": spec: /slots: a policy with \"relative\" observations "
                                   "steers one robot");
    }
  }
  const int robots = field::make_field(policy.league).robots_per_team;
  const std::size_t expected = numbers_of(policy.sight, robots);
  if (policy.observation.size() != expected) {
    return fail(Errc::input, path + ": spec: /observation: " + std::to_string(expected) +
                                 " numbers are expected, not " +
                                 std::to_string(policy.observation.size()));
  }
  return {};
}

}  // namespace

Result<Policy> parse_policy(std::string_view bytes, const std::string& path) {
  MIROCUP_TRY(auto read, read_npz(bytes, path));
  const Arrays arrays(std::move(read), path);
  const auto schema = arrays.text("schema");
  if (schema && *schema != policy_schema) {
    return fail(Errc::damaged, path + ": it is a " + *schema + ", not a mirocup/policy/1");
  }
  MIROCUP_TRY(const auto spec, arrays.text("spec"));
  auto policy = record::read_json<Policy>(spec, path + ": spec", Errc::input, read_spec);
  if (!policy) return policy;
  MIROCUP_TRY_VOID(check_actors(*policy, path));
  MIROCUP_TRY(const auto activation, arrays.text("activation"));
  const auto named = from_string<Activation>(activation);
  if (!named) {
    return fail(Errc::input, path + ": activation: one of " + list_of_names<Activation>() +
                                 " is expected, not \"" + activation + "\"");
  }
  policy->activation = *named;
  MIROCUP_TRY_VOID(read_layers(arrays, path, *policy));
  return policy;
}

}  // namespace mirocup::policy
