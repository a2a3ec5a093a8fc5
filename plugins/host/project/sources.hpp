// SPDX-License-Identifier: MIT
//
// Finds the files of a project that become its library: all files of C and C++ except tests. A
// team's build files, which could start any program, are not used.
#pragma once

#include <string>
#include <vector>

namespace mirocup::plugins {

struct ProjectSources {
  std::string root;              // the outermost folder whose content is not just one folder
  std::vector<std::string> c;    // sources in C: paths from the root, sorted
  std::vector<std::string> cpp;  // sources in C++: paths from the root, sorted
};

// Finds the sources of a project, but no files whose names end in _test before the dot, and no
// files in a folder test or tests.
ProjectSources sources_of_project(const std::string& folder);

}  // namespace mirocup::plugins
