// SPDX-License-Identifier: MIT
#include "record/drawn_situation.hpp"

#include "record/json_reader.hpp"

namespace mirocup::record {

namespace {

using DrawnJson = nlohmann::ordered_json;

constexpr int max_draws = 100;

bool is_range(const DrawnJson& json) {
  return json.is_object() && json.size() == 2 && json.contains("from") && json.contains("to");
}

Result<Situation> draw_once(const DrawnJson& ranges, League league, Random& random,
                            const std::string& path) {
  DrawnJson json{{"schema", "mirocup/situation/1"}, {"league", to_string(league)}};
  const DrawnJson numbers = drawn(ranges, random);
  for (const auto& [key, value] : numbers.items()) json[key] = value;
  std::optional<JsonProblem> problem;
  Situation situation = read_situation(JsonReader(json, "", problem));
  if (problem) return tl::unexpected(error_of(*problem, path, Errc::input));
  return situation;
}

}  // namespace

DrawnJson drawn(const DrawnJson& json, Random& random) {
  if (is_range(json) && json["from"].is_number() && json["to"].is_number()) {
    return random.uniform(json["from"].get<double>(), json["to"].get<double>());
  }
  DrawnJson result = json;
  for (auto& member : result) {
    if (member.is_structured()) member = drawn(member, random);
  }
  return result;
}

Result<Situation> draw_situation(const DrawnJson& ranges, League league, Random& random,
                                 const std::string& path) {
  auto situation = draw_once(ranges, league, random, path);
  for (int i = 1; !situation && i < max_draws; ++i) {
    situation = draw_once(ranges, league, random, path);
  }
  return situation;
}

}  // namespace mirocup::record
