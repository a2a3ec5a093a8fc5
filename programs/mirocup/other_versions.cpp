// SPDX-License-Identifier: MIT
#include "programs/mirocup/other_versions.hpp"

#include "core/base/error.hpp"
#include "system/child_process.hpp"
#include "system/printable.hpp"
#include "system/trusted_program.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <sstream>
#include <unistd.h>

namespace mirocup::app {

namespace {

namespace fs = std::filesystem;

constexpr const char* shared_versions = "/opt/mirocup";

void add_program(const fs::path& folder, std::vector<std::string>& found) {
  std::error_code none;
  for (const fs::path& program : {folder / "bin" / "mirocup", folder / "mirocup"}) {
    if (fs::symlink_status(program, none).type() == fs::file_type::not_found) continue;
    if (fs::is_directory(program, none)) continue;
    const auto real = system::trusted_program(program, "mirocup");
    if (!real) {
      std::cerr << "mirocup: " << system::printable(program.string())
                << " is not asked to verify the record: " << system::printable(real.error().what)
                << '\n';
    } else if (*real != fs::read_symlink("/proc/self/exe", none) &&
               std::find(found.begin(), found.end(), *real) == found.end()) {
      found.push_back(*real);
    }
  }
}

std::vector<std::string> other_versions() {
  std::vector<std::string> found;
  if (const char* named = secure_getenv("MIROCUP_VERSIONS")) {
    std::istringstream folders(named);
    for (std::string folder; std::getline(folders, folder, ':');) {
      if (!folder.empty()) add_program(folder, found);
    }
  }
  std::vector<fs::path> folders;
  std::error_code none;
  for (const auto& folder : fs::directory_iterator(shared_versions, none))
    folders.push_back(folder.path());
  std::sort(folders.rbegin(), folders.rend());  // new ones first
  for (const fs::path& folder : folders) add_program(folder, found);
  return found;
}

// Returns what the program prints of its version; "" if it does not answer.
std::string version_of(const std::string& program) {
  std::error_code none;
  std::string path = (fs::temp_directory_path(none) / "mirocup-version-XXXXXX").string();
  const system::Descriptor file(mkstemp(path.data()));
  if (!file.is_open()) return "";
  const auto code = system::run_child({.arguments = {program, "--version"}, .log = path});
  system::Disk disk;
  std::string text = disk.read(path, {.max_size = system::size_limit::note}).value_or("");
  fs::remove(path, none);
  if (!code || *code != exit_yes) return "";
  return text.substr(0, text.find('\n'));
}

}  // namespace

// A version that is asked asks none itself: two that do not reproduce the record would ask each
// other without end.
std::string version_that_reproduces(const std::string& path, const record::MatchRecord& record) {
  if (std::getenv(system::asks_no_other) != nullptr) return "";
  setenv(system::asks_no_other, "1", 1);  // for all programs that this one starts from here on
  for (const std::string& program : other_versions()) {
    const std::string version = version_of(program);
    if (version.empty() || version != record.software.version) continue;
    const auto answer =
        system::run_child({.arguments = {program, "verify", path}, .log = "/dev/null"});
    if (answer && *answer == exit_yes) return program;
  }
  return "";
}

}  // namespace mirocup::app
