// SPDX-License-Identifier: MIT
#include "system/locations.hpp"

#include <algorithm>
#include <filesystem>

namespace mirocup::system {

namespace fs = std::filesystem;

namespace {

// A name that no file can have, for example a very long one, is that of no file.
bool is_there(const fs::path& path) {
  std::error_code none;
  return fs::exists(path, none);
}

}  // namespace

std::string program_folder() {
  return fs::read_symlink("/proc/self/exe").parent_path().string();
}

std::string sibling_program(const std::string& name) {
  const fs::path here = program_folder();
  const fs::path installed = here.parent_path() / "libexec" / "mirocup" / name;
  return is_there(here / name) ? (here / name).string() : installed.string();
}

TeamKit team_kit() {
  const fs::path program = fs::read_symlink("/proc/self/exe");
  // A build tree has its programs at the top.
  const bool is_installed = program.parent_path().filename() == "bin";
  const fs::path prefix =
      is_installed ? program.parent_path().parent_path() : program.parent_path();
  return {.program = program.string(),
          .prefix = prefix.string(),
          .headers = (prefix / "include" / "mirocup").string(),
          .templates = (prefix / "share" / "mirocup" / "team").string()};
}

std::string drill_folder() {
  return (fs::path(team_kit().prefix) / "share" / "mirocup" / "drills").string();
}

std::vector<std::string> house_teams() {
  std::vector<std::string> names;
  const std::string idle = house_team("idle");  // one that is always there
  if (idle.empty()) return names;
  for (const auto& file : fs::directory_iterator(fs::path(idle).parent_path())) {
    if (file.path().extension() == ".so") names.push_back(file.path().stem());
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::string house_team(const std::string& name) {
  return house_team(name, program_folder());
}

std::string house_team(const std::string& name, const std::string& folder) {
  if (name.empty() || name.find('/') != std::string::npos) return "";
  // A library is in lib/, or in a folder of lib/ that is named after the architecture.
  const fs::path here = folder;
  for (const fs::path& teams : {here / "house", here.parent_path() / "lib" / "mirocup" / "house",
                                here.parent_path() / "mirocup" / "house"}) {
    const fs::path library = teams / (name + ".so");
    if (is_there(library)) return library.string();
  }
  return "";
}

}  // namespace mirocup::system
