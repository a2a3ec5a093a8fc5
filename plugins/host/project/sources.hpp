// SPDX-License-Identifier: MIT
//
// Finds the files of a project that become its library: all of C and C++ except tests. So a team's
// build files, which could start any program, are not used.
#pragma once

#include <string>
#include <vector>

namespace mirocup::plugins {

struct ProjectSources {
  std::string root;              // the project's folder: the one with the first source
  std::vector<std::string> c;    // paths from the root, sorted
  std::vector<std::string> cpp;  // the same for C++
};

// Leaves out files whose names end in _test before the dot, and files in a folder test or tests.
ProjectSources sources_of_project(const std::string& folder);

}  // namespace mirocup::plugins
