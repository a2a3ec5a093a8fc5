// SPDX-License-Identifier: MIT
//
// The subcommands `submit`, which hands in entries, and `compare`, which finds the better of two.
#include "tournaments/app/commands.hpp"
#include "tournaments/app/progress_bar.hpp"
#include "tournaments/league/submission.hpp"
#include "tournaments/play/comparison_run.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <iostream>
#include <memory>

namespace mirocup::league {

namespace {

namespace fs = std::filesystem;

std::string time_now() {
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  gmtime_r(&now, &utc);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc);
  return text;
}

void print(const Submission& done, bool json) {
  if (!json) {
    std::cout << done.message << '\n';
    return;
  }
  const Json line{{"accepted", done.is_accepted},
                  {"entry", done.entry > 0 ? Json(done.entry) : Json()},
                  {"message", done.message},
                  {"verdict", done.verdict}};
  std::cout << line.dump(-1, ' ', false, Json::error_handler_t::replace) << '\n';
}

// Submits TEAM.so of an inbox, unless it is the team's last entry already.
Result<int> collect(system::Files& files, const SubmitOptions& options) {
  std::vector<fs::path> libraries;
  std::error_code code;
  for (const auto& file : fs::directory_iterator(options.inbox, code)) {
    if (file.path().extension() == ".so") libraries.push_back(file.path());
  }
  if (code) return fail(Errc::unavailable, options.inbox + " cannot be read: " + code.message());
  std::sort(libraries.begin(), libraries.end());
  const Folder folder{options.folder};
  int result = exit_yes;
  for (const fs::path& library : libraries) {
    const std::string team = library.stem().string();
    const int last = is_good_name(team) ? last_entry(files, folder, team) : 0;
    if (last > 0) {
      const auto before = files.read(folder.library(team, last));
      const auto now = files.read(library.string());
      if (before && now && *before == *now) continue;
    }
    const auto done = submit(files, folder, team, library.string(), time_now());
    if (!done) return tl::unexpected(done.error());
    print(*done, options.json);
    if (!done->is_accepted) result = exit_no;
  }
  return result;
}

// A folder that its destructor removes.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string name = (fs::temp_directory_path() / "mirocup-compare-XXXXXX").string();
    if (mkdtemp(name.data()) != nullptr) path_ = name;
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  ~ScratchFolder() {
    std::error_code ignored;
    if (!path_.empty()) fs::remove_all(path_, ignored);
  }
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

}  // namespace

Result<int> run_submit(const SubmitOptions& options) {
  system::Disk disk;
  if (!options.inbox.empty()) return collect(disk, options);
  if (options.file.empty())
    return fail(Errc::input, "TEAM and FILE.so are expected, or --inbox FOLDER");
  const auto done = submit(disk, Folder{options.folder}, options.team, options.file, time_now());
  if (!done) return tl::unexpected(done.error());
  print(*done, options.json);
  return done->is_accepted ? exit_yes : exit_no;
}

Result<int> run_compare(const CompareOptions& options) {
  system::Disk disk;
  const ScratchFolder scratch;
  if (scratch.path().empty())
    return fail(Errc::unavailable, "no folder for the records can be made");
  ComparisonRun run = options.run;
  run.league = *from_string<League>(options.league);
  run.folder = scratch.path();
  const auto progress = make_progress_reporter();
  const auto result = run_comparison(disk, run, *progress);
  if (!result) return tl::unexpected(result.error());
  const bool is_decided = result->verdict != ComparisonVerdict::undecided;
  const std::string& better = run.teams[result->verdict == ComparisonVerdict::second ? 1 : 0];
  if (options.json) {
    const Json json{{"better", is_decided ? Json(better) : Json()},
                    {"won", {result->first_wins, result->second_wins}},
                    {"level", result->level},
                    {"error", run.test.error}};
    std::cout << json.dump() << '\n';
  } else {
    std::cout << (is_decided ? better + " is better" : std::string("it cannot be said"))
              << ": fixtures won " << result->first_wins << " to " << result->second_wins << ", "
              << result->level << " level\n";
  }
  return is_decided ? exit_yes : exit_no;
}

}  // namespace mirocup::league
