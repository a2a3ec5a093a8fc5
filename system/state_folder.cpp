// SPDX-License-Identifier: MIT
#include "system/state_folder.hpp"

#include <cstdlib>

namespace mirocup::system {

std::string state_folder() {
  const auto folder_of = [](const char* variable) {
    const char* text = secure_getenv(variable);
    const std::string value = text != nullptr ? text : "";
    return value.starts_with('/') ? value : "";
  };
  const std::string of_unit = folder_of("STATE_DIRECTORY");
  if (!of_unit.empty()) return of_unit.substr(0, of_unit.find(':'));
  if (const std::string of_user = folder_of("XDG_STATE_HOME"); !of_user.empty())
    return of_user + "/mirocup";
  const std::string home = folder_of("HOME");
  return home.empty() ? "" : home + "/.local/state/mirocup";
}

}  // namespace mirocup::system
