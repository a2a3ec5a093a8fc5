// SPDX-License-Identifier: MIT
//
// The project's own programs, run to be timed.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace mirocup::bench {

// Beside the program that runs; it need not be there.
std::filesystem::path program_beside(const std::string& name);

// A folder for files that nobody keeps, removed with this. Its path is empty if there could be none.
class ScratchFolder {
 public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

// A bench keeps itself to one core; what it runs may have the others, too.
enum class Cores { this_one, all };

struct ProgramTimes {
  double wall_seconds = 0.0;
  double cpu_seconds = 0.0;  // with what it ran and waited for
};

// Waits for the program, whose standard output nobody sees. Nothing if it failed.
std::optional<ProgramTimes> run(std::vector<std::string> words, Cores cores);

}  // namespace mirocup::bench
