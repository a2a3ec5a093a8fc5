// SPDX-License-Identifier: MIT
#include "system/locations.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>

namespace mirocup::system {

namespace fs = std::filesystem;

namespace {

// A name that no file can have, for example a very long one, is that of no file.
bool is_there(const fs::path& path) {
  std::error_code none;
  return fs::exists(path, none);
}

// A library is in lib/, or in a folder of lib/ that is named after the architecture.
std::array<fs::path, 3> house_folders(const fs::path& here) {
  return {here / "house", here.parent_path() / "lib" / "mirocup" / "house",
          here.parent_path() / "mirocup" / "house"};
}

}  // namespace

static fs::path program_folder() {
  return fs::read_symlink("/proc/self/exe").parent_path();
}

// A build tree has its programs at the top.
static bool is_installed() {
  return program_folder().filename() == "bin";
}

static fs::path prefix() {
  return is_installed() ? program_folder().parent_path() : program_folder();
}

std::string sibling_program(const std::string& name) {
  const fs::path here = program_folder();
  const fs::path installed = here.parent_path() / "libexec" / "mirocup" / name;
  return is_there(here / name) ? (here / name).string() : installed.string();
}

std::string build_folder() {
  return is_installed() ? "build" : program_folder().string();
}

TeamKit team_kit() {
  fs::path python;
  for (const char* folder : {"python", "share/mirocup/python", "lib/python3/dist-packages"}) {
    if (python.empty() && is_there(prefix() / folder / "mirocup" / "team.py"))
      python = prefix() / folder;
  }
  return {.program = (program_folder() / "mirocup").string(),
          .prefix = prefix().string(),
          .headers = (prefix() / "include" / "mirocup").string(),
          .templates = (prefix() / "share" / "mirocup" / "team").string(),
          .python = python.string()};
}

std::string browser_folder() {
  return (prefix() / (is_installed() ? "share/mirocup/browser" : "browser")).string();
}

std::string drill_folder() {
  return (prefix() / "share" / "mirocup" / "drills").string();
}

std::string course_folder() {
  return (prefix() / "share" / "mirocup" / "course").string();
}

std::string drill_folder(const std::string& folder) {
  // Beside the library in a build tree; in a prefix, one or two folders above it.
  std::error_code none;
  fs::path above = folder;
  for (int i = 0; i < 3; ++i, above = above.parent_path()) {
    const fs::path drills = above / "share" / "mirocup" / "drills";
    if (fs::is_directory(drills, none)) return drills.string();
  }
  return drill_folder();
}

std::string house_team(const std::string& name) {
  return house_team(name, program_folder().string());
}

std::vector<std::string> house_teams() {
  std::vector<std::string> names;
  for (const fs::path& folder : house_folders(program_folder())) {
    std::error_code none;
    for (const auto& file : fs::directory_iterator(folder, none)) {
      if (file.path().extension() == ".so") names.push_back(file.path().stem().string());
    }
    if (!names.empty()) break;
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::string house_team(const std::string& name, const std::string& folder) {
  if (name.empty() || name.find('/') != std::string::npos) return "";
  // drill:NAME and course:NAME are in folders of their own.
  std::string file = name;
  if (name.starts_with("drill:") || name.starts_with("course:")) file[name.find(':')] = '/';
  for (const fs::path& teams : house_folders(folder)) {
    const fs::path library = teams / (file + ".so");
    if (is_there(library)) return library.string();
  }
  return "";
}

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
