// SPDX-License-Identifier: MIT
#include "core/match/team_parameters.hpp"

#include <cmath>

namespace mirocup::match {

std::string problem_with(const TeamParameters& parameters) {
  if (parameters.size() > max_team_parameters) {
    return "at most " + std::to_string(max_team_parameters) + " parameters are expected, not " +
           std::to_string(parameters.size());
  }
  for (const auto& entry : parameters) {
    if (!is_parameter_name(entry.first)) {
      return "a name of letters, digits, '_', '-' and '.' is expected, which begins with a letter "
             "and has at most " +
             std::to_string(max_parameter_name) + " bytes, not \"" + entry.first + "\"";
    }
    if (!std::isfinite(entry.second)) return entry.first + ": a finite number is expected";
  }
  return "";
}

}  // namespace mirocup::match
