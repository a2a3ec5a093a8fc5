// SPDX-License-Identifier: MIT
#include "record/team_parameters_json.hpp"

#include "record/json_reader.hpp"
#include "system/number_of.hpp"

#include <optional>

namespace mirocup::record {

using match::TeamParameters;
using Json = nlohmann::ordered_json;

Json to_json(const TeamParameters& parameters) {
  Json object = Json::object();
  for (const auto& entry : parameters) object[entry.first] = entry.second;
  return object;
}

TeamParameters read_team_parameters(const JsonReader& json) {
  TeamParameters parameters;
  if (!json.expect_object()) return parameters;
  for (const auto& member : json.members()) parameters[member.first] = member.second.number();
  if (const std::string problem = match::problem_with(parameters); !problem.empty())
    json.complain(problem);
  return parameters;
}

Result<TeamParameters> parameters_with_changes(TeamParameters parameters,
                                               const std::vector<std::string>& changes,
                                               const std::string& option) {
  for (const std::string& change : changes) {
    const std::size_t equals = change.find('=');
    const auto value = equals == std::string::npos
                           ? std::nullopt
                           : system::number_of<double>(change.substr(equals + 1));
    if (!value) {
      return fail(Errc::input, option + " " + change + ": KEY=VALUE with a number is expected");
    }
    parameters[change.substr(0, equals)] = *value;
    if (const std::string problem = match::problem_with(parameters); !problem.empty())
      return fail(Errc::input, option + " " + change + ": " + problem);
  }
  return parameters;
}

std::vector<std::string> parameter_options(const TeamParameters& parameters,
                                           const std::string& option) {
  std::vector<std::string> words;
  for (const auto& entry : parameters) {
    words.push_back(option);
    words.push_back(entry.first + "=" + json_text(Json(entry.second)));
  }
  return words;
}

}  // namespace mirocup::record
