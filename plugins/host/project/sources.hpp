// SPDX-License-Identifier: MIT
//
// Which files of a project become its library: all of C and C++, but for tests. So the build files
// of a team, which could start any program, are not used.
#pragma once

#include <string>
#include <vector>

namespace mirocup::plugins {

struct ProjectSources {
  std::string root;              // the folder of the project: that with the first source
  std::vector<std::string> c;    // paths from the root, sorted
  std::vector<std::string> cpp;  // the same
};

// Left out: files whose names end in _test before the dot, and what is in a folder test or tests.
ProjectSources sources_of_project(const std::string& folder);

}  // namespace mirocup::plugins
