// SPDX-License-Identifier: MIT
#include "system/locations.hpp"

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
