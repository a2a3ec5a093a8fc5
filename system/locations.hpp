// SPDX-License-Identifier: MIT
//
// The places of the project's own programs and files: beside the program in a build tree, in
// libexec, lib and share below the prefix of an installation.
#pragma once

#include <string>
#include <vector>

namespace mirocup::system {

// Returns the path of another program of the same build or installation.
std::string sibling_program(const std::string& name);

// Returns the folder that CMake builds into: that of this program, or, for an installed program,
// the name "build".
std::string build_folder();

// The locations from which `mirocup new` takes the parts of a new team.
struct TeamKit {
  std::string program;    // path of `mirocup`
  std::string prefix;     // for find_package(mirocup)
  std::string headers;    // folder of strategy.h, for people to read
  std::string templates;  // has a folder for each language, with the files of a new team
  std::string python;     // folder of the package mirocup for Python; "" if it is not installed
};
TeamKit team_kit();

// Returns the folder of the drills that come with mirocup.
std::string drill_folder();
// Like the function above, for a library in another program. `folder` is the library's folder.
std::string drill_folder(const std::string& folder);
// Returns the folder of the sheets of exercises that come with mirocup.
std::string course_folder();

// Returns the folder of the module for browsers, which is not always built.
std::string browser_folder();

// Returns the names of the house teams, sorted.
std::vector<std::string> house_teams();

// Returns the path of the library of a house team; "" if no house team has the name.
std::string house_team(const std::string& name);
// Like the function above, for a library in another program. `folder` is the library's folder.
std::string house_team(const std::string& name, const std::string& folder);

// Returns the folder, which may be missing, for data of this computer that belong to no league:
// $STATE_DIRECTORY (set by systemd), otherwise $XDG_STATE_HOME/mirocup, otherwise
// $HOME/.local/state/mirocup; "" if none of these variables has an absolute path.
std::string state_folder();

}  // namespace mirocup::system
