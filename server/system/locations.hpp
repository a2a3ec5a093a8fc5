// SPDX-License-Identifier: MIT
//
// Where the program's own parts are: beside it in a build tree, in libexec and lib below a prefix
// when installed.
#pragma once

#include <string>

namespace mirocup::system {

// The folder of the running program.
std::string program_folder();

// The program of that name that belongs to this one.
std::string sibling_program(const std::string& name);

// What a new team is made of. The headers are for people to read.
struct TeamKit {
  std::string program;    // path of this program
  std::string prefix;     // for find_package(mirocup)
  std::string headers;    // folder of strategy.h
  std::string templates;  // folder
};
TeamKit team_kit();

// The library of a house team, or "" if there is no such team.
std::string house_team(const std::string& name);

}  // namespace mirocup::system
