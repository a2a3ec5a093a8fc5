// SPDX-License-Identifier: MIT
#include "server/app/other_versions.hpp"

#include "core/base/error.hpp"
#include "system/child_process.hpp"
#include "system/locations.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace mirocup::app {

namespace {

namespace fs = std::filesystem;

constexpr const char* shared_versions = "/opt/mirocup";

// Set in the environment of a version that another one asks.
constexpr const char* is_asked = "MIROCUP_IS_ASKED";

// The owners whose programs are run.
enum class Owner {
  any,   // for folders that the host has named
  known  // root, this user and the owner of this program: beside the prefix /usr there is /tmp
};

// True if the file or the folder has a known owner, and other users may not write to it.
bool has_known_owner(const fs::path& path) {
  struct stat about {};
  struct stat self {};
  if (stat(path.c_str(), &about) != 0 || stat("/proc/self/exe", &self) != 0) return false;
  const bool is_known =
      about.st_uid == 0 || about.st_uid == geteuid() || about.st_uid == self.st_uid;
  return is_known && (about.st_mode & S_IWOTH) == 0;
}

void add_program(const fs::path& folder, Owner owner, std::vector<std::string>& found) {
  std::error_code none;
  for (const fs::path& program : {folder / "bin" / "mirocup", folder / "mirocup"}) {
    const fs::path real = fs::canonical(program, none);
    if (none || !fs::is_regular_file(real, none) || real == fs::read_symlink("/proc/self/exe"))
      continue;
    if (owner == Owner::known && !(has_known_owner(real) && has_known_owner(real.parent_path())))
      continue;
    if (std::find(found.begin(), found.end(), real) == found.end()) found.push_back(real);
  }
}

}  // namespace

std::vector<std::string> other_versions() {
  std::vector<std::string> found;
  if (const char* named = std::getenv("MIROCUP_VERSIONS")) {
    std::istringstream folders(named);
    for (std::string folder; std::getline(folders, folder, ':');) {
      if (!folder.empty()) add_program(folder, Owner::any, found);
    }
  }
  const fs::path beside = fs::path(system::team_kit().prefix).parent_path();
  for (const auto& [all, owner] :
       {std::pair(fs::path(shared_versions), Owner::any), std::pair(beside, Owner::known)}) {
    std::vector<fs::path> folders;
    std::error_code none;
    for (const auto& folder : fs::directory_iterator(all, none)) folders.push_back(folder.path());
    std::sort(folders.rbegin(), folders.rend());  // new ones first
    for (const fs::path& folder : folders) add_program(folder, owner, found);
  }
  return found;
}

// A version that is asked asks none itself: two that do not reproduce the record would ask each
// other without end.
std::string version_that_reproduces(const std::string& record) {
  if (std::getenv(is_asked) != nullptr) return "";
  for (const std::string& program : other_versions()) {
    const auto answer = system::run_child(
        {.arguments = {"/usr/bin/env", std::string(is_asked) + "=1", program, "verify", record},
         .cpu = -1,
         .log = "/dev/null"});
    if (answer && *answer == exit_yes) return program;
  }
  return "";
}

}  // namespace mirocup::app
