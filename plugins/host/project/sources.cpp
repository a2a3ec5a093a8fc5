// SPDX-License-Identifier: MIT
#include "plugins/host/project/sources.hpp"

#include <algorithm>
#include <filesystem>

namespace mirocup::plugins {

namespace {

namespace fs = std::filesystem;

bool is_test(const fs::path& path) {
  if (path.stem().string().ends_with("_test")) return true;
  const fs::path folder = path.parent_path();
  return std::any_of(folder.begin(), folder.end(),
                     [](const fs::path& part) { return part == "test" || part == "tests"; });
}

// An archive of a folder has that folder at its top, and nothing beside it.
fs::path root_of(fs::path folder) {
  while (true) {
    std::vector<fs::path> inside;
    for (const auto& entry : fs::directory_iterator(folder)) inside.push_back(entry.path());
    if (inside.size() != 1 || !fs::is_directory(inside.front())) return folder;
    folder = inside.front();
  }
}

}  // namespace

ProjectSources sources_of_project(const std::string& folder) {
  ProjectSources sources;
  const fs::path root = root_of(folder);
  sources.root = root.string();
  for (const auto& entry : fs::recursive_directory_iterator(root)) {
    if (!entry.is_regular_file()) continue;
    const fs::path path = entry.path().lexically_relative(root);
    if (is_test(path)) continue;
    const std::string end = path.extension();
    if (end == ".c") sources.c.push_back(path.string());
    if (end == ".cpp" || end == ".cc" || end == ".cxx") sources.cpp.push_back(path.string());
  }
  std::sort(sources.c.begin(), sources.c.end());
  std::sort(sources.cpp.begin(), sources.cpp.end());
  return sources;
}

}  // namespace mirocup::plugins
