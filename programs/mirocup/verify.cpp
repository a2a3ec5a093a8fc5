// SPDX-License-Identifier: MIT
//
// mirocup verify RECORD: simulates the leg again and compares it with the record.
#include "core/replay/verification.hpp"
#include "programs/mirocup/commands.hpp"
#include "record/json_reader.hpp"
#include "record/match_record.hpp"
#include "system/child_process.hpp"
#include "system/printable.hpp"
#include "system/trusted_program.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

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

// Returns the words of a program that ends with yes; nothing if it does not, or does not end.
std::optional<std::string> words_of_yes(const std::vector<std::string>& command, double within_s) {
  auto answer = system::ask(command, {.seconds = within_s, .bytes = system::size_limit::note});
  if (!answer) std::cerr << "mirocup: " << system::printable(answer.error().what) << '\n';
  if (!answer || answer->code != exit_yes) return std::nullopt;
  return std::move(answer->output);
}

struct VerifyOptions {
  std::string path;
  bool json = false;
};

// Returns the answer of a program that reproduces the record; nothing if no such program exists.
// Precondition: the record's checksum is right. The function looks for programs in the folders of
// $MIROCUP_VERSIONS and in /opt/mirocup/*, each in bin/ and in the folder itself. It runs only
// programs that are called mirocup and that no stranger can have put there
// (system/trusted_program.hpp). `--version` must print the version that the record names. Standard
// error names each program that a stranger might have put there or that did not end, and the
// program that answers.
//
// A version that is asked asks none itself: two that do not reproduce the record would ask each
// other without end.
std::optional<std::string> answer_of_other_version(const VerifyOptions& options,
                                                   const record::MatchRecord& record) {
  if (std::getenv(system::asks_no_other) != nullptr) return std::nullopt;
  setenv(system::asks_no_other, "1", 1);  // for all programs that this one starts from here on
  for (const std::string& program : other_versions()) {
    constexpr double version_limit_s = 5.0;
    const auto version = words_of_yes({program, "--version"}, version_limit_s);
    if (!version || version->substr(0, version->find('\n')) != record.software.version) continue;
    std::vector<std::string> command{program, "verify", options.path};
    if (options.json) command.emplace_back("--json");
    auto answer =
        words_of_yes(command, system::limit_of_repeating(record.recording.setup.rules.half_s));
    if (!answer) continue;
    std::cerr << "mirocup: the leg was played by another version; " << system::printable(program)
              << " verifies it\n";
    return answer;
  }
  return std::nullopt;
}

Result<int> run_verify(const VerifyOptions& options) {
  system::Disk disk;
  const auto whole = record::load(disk, options.path);
  // For a record that was changed, its first wrong statement is a better answer than the checksum.
  MIROCUP_TRY(const auto record,
              whole ? whole : record::load(disk, options.path, record::ChecksumPolicy::ignored));
  const auto divergence = replay::verify(record.recording);
  const bool has_other_behaviour = record::has_other_behaviour(record);
  if (!whole && (!divergence || has_other_behaviour)) return tl::unexpected(whole.error());
  if (divergence && has_other_behaviour) {
    if (const auto answer = answer_of_other_version(options, record)) {
      std::cout << system::printable(*answer, system::LineEnds::kept);
      return exit_yes;
    }
    return tl::unexpected(record::behaviour_mismatch(options.path, record, divergence->tick));
  }

  if (options.json) {
    record::Json answer{{"record", options.path}, {"reproduced", !divergence}};
    answer["tick"] = divergence ? record::Json(divergence->tick) : record::Json();
    answer["what"] = divergence ? record::Json(divergence->what) : record::Json();
    std::cout << record::json_text(answer) << '\n';
  } else if (divergence) {
    std::cout << system::printable(options.path) << ": differs from tick " << divergence->tick
              << " on: " << system::printable(divergence->what) << '\n';
  } else {
    std::cout << system::printable(options.path) << ": reproduced, "
              << record.recording.ticks.size() << " ticks, state hash "
              << to_hex(record.recording.state_hash) << '\n';
  }
  return divergence ? exit_no : exit_yes;
}

}  // namespace

void add_verify(system::Commands& commands) {
  const auto [command, o] =
      commands.add(run_verify, "verify", after_a_leg,
                   "Simulate a record again from its commands and compare everything",
                   {"mirocup verify leg.json"});
  command.option("RECORD", o.path, "Match record").required();
  command.flag("--json", o.json, "Print the answer as one JSON object");
}

}  // namespace mirocup::app
