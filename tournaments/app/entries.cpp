// SPDX-License-Identifier: MIT
//
// Handing in entries, and finding out which of two is better.
#include "tournaments/app/commands.hpp"
#include "tournaments/app/progress_bar.hpp"
#include "tournaments/run/comparison_run.hpp"
#include "tournaments/run/submission.hpp"

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <iostream>
#include <memory>

namespace mirocup::league {

namespace {

namespace fs = std::filesystem;

struct SubmitOptions {
  std::string folder;
  std::string team;
  std::string file;
  std::string inbox;
  bool json = false;
};

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

// TEAM.so of an inbox, unless it is the team's last entry already.
Result<int> collect(record::Files& files, const SubmitOptions& options) {
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

Result<int> run_submit(const SubmitOptions& options) {
  record::Disk disk;
  if (!options.inbox.empty()) return collect(disk, options);
  if (options.file.empty())
    return fail(Errc::input, "TEAM and FILE.so are expected, or --inbox FOLDER");
  const auto done = submit(disk, Folder{options.folder}, options.team, options.file, time_now());
  if (!done) return tl::unexpected(done.error());
  print(*done, options.json);
  return done->is_accepted ? exit_yes : exit_no;
}

struct CompareOptions {
  ComparisonRun run;
  std::string league = "small";
  bool json = false;
};

// Gone when it goes.
class Scratch {
 public:
  Scratch() {
    std::string name = (fs::temp_directory_path() / "mirocup-compare-XXXXXX").string();
    if (mkdtemp(name.data()) != nullptr) path_ = name;
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  ~Scratch() {
    std::error_code ignored;
    if (!path_.empty()) fs::remove_all(path_, ignored);
  }
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

Result<int> run_compare(CompareOptions options) {
  record::Disk disk;
  const Scratch scratch;
  if (scratch.path().empty())
    return fail(Errc::unavailable, "no folder for the records can be made");
  ComparisonRun& run = options.run;
  run.league = *from_string<League>(options.league);
  run.folder = scratch.path();
  const auto progress = make_progress();
  const auto result = run_comparison(disk, run, *progress);
  if (!result) return tl::unexpected(result.error());
  const bool is_decided = result->verdict != Verdict::undecided;
  const std::string& better = run.teams[result->verdict == Verdict::second ? 1 : 0];
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

}  // namespace

void add_submit(CLI::App& app, Run& run) {
  auto options = std::make_shared<SubmitOptions>();
  CLI::App* sub = app.add_subcommand("submit", "Hand in an entry: check it, keep it, let it play");
  sub->add_option("DIR", options->folder, "the league's folder")->required();
  auto* team = sub->add_option("TEAM", options->team, "its name");
  auto* file = sub->add_option("FILE.so", options->file, "its library");
  sub->add_option("--inbox", options->inbox, "take TEAM.so of this folder, each that is new")
      ->excludes(team)
      ->excludes(file);
  sub->add_flag("--json", options->json, "one JSON object for each entry on standard output");
  sub->callback([options, &run] { run = [options] { return run_submit(*options); }; });
}

void add_compare(CLI::App& app, Run& run) {
  auto options = std::make_shared<CompareOptions>();
  ComparisonRun& r = options->run;
  CLI::App* sub =
      app.add_subcommand("compare", "Play two entries until it can be said which is better");
  sub->add_option("A", r.teams[0], "a library, or the name of a house team")->required();
  sub->add_option("B", r.teams[1], "the other")->required();
  sub->add_option("--league", options->league, "small (3 a side), middle (5), large (11)")
      ->check(CLI::IsMember({"small", "middle", "large"}))
      ->capture_default_str();
  sub->add_option("--half", r.half_s, "seconds of a half")->check(CLI::Range(0.1, 36000.0));
  sub->add_option("--seed", r.seed, "of the fixtures")->capture_default_str();
  sub->add_option("--jobs", r.jobs, "legs at once (default: one for each processor)")
      ->check(CLI::Range(1, 1024));
  sub->add_option("--most", r.most, "fixtures of two legs, before it gives up")
      ->check(CLI::Range(1, 1'000'000))
      ->capture_default_str();
  sub->add_option("--share", r.test.share,
                  "of the fixtures that are not level, that the better one wins at least")
      ->check(CLI::Range(0.51, 0.99))
      ->capture_default_str();
  sub->add_flag("--json", options->json, "one JSON object on standard output");
  sub->callback([options, &run] { run = [options] { return run_compare(*options); }; });
}

}  // namespace mirocup::league
