// SPDX-License-Identifier: MIT
#include "tournaments/app/commands.hpp"

#include "tournaments/publish/replay_pages.hpp"
#include "tournaments/publish/site.hpp"
#include "tournaments/run/runner.hpp"

#include <filesystem>
#include <iostream>
#include <memory>

namespace mirocup::league {

namespace {

struct Options {
  std::string folder;
  std::string config;              // init
  std::vector<std::string> teams;  // init: NAME=ENTRY
  double half_s = 0.0;             // init; 0: as the rules say
  std::uint64_t seed = 1;          // init
  int jobs = 0;                    // start
  bool json = false;
};

CLI::App* add(CLI::App& app, const char* name, const char* description, Run& run,
              const std::shared_ptr<Options>& options, Result<int> (*command)(const Options&)) {
  CLI::App* sub = app.add_subcommand(name, description);
  sub->add_option("DIR", options->folder, "the league's folder")->required();
  sub->callback(
      [options, command, &run] { run = [options, command] { return command(*options); }; });
  return sub;
}

Result<LeagueFile> file_from(record::Files& files, const Options& options) {
  if (!options.config.empty()) {
    const auto text = files.read(options.config);
    if (!text) return tl::unexpected(text.error());
    auto file = parse_league_file(*text, options.config);
    if (!file) return file;
    // Libraries are named from where the file is.
    const std::filesystem::path base = std::filesystem::path(options.config).parent_path();
    for (TeamEntry& team : file->teams) {
      if (team.source.rfind("house:", 0) != 0) team.source = (base / team.source).string();
    }
    return file;
  }
  LeagueFile file;
  file.seed = options.seed;
  file.title = std::filesystem::path(options.folder).filename().string();
  if (options.half_s > 0.0) file.rules.half_s = options.half_s;
  for (const std::string& text : options.teams) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos) {
      return fail(Errc::input, "--team " + text + ": NAME=house:TEAM or NAME=FILE.so is expected");
    }
    file.teams.push_back({text.substr(0, equals), text.substr(equals + 1), false});
  }
  // Through the parser, which knows what a good name is.
  return parse_league_file(print_league_file(file), "--team");
}

Result<int> init(const Options& options) {
  record::Disk disk;
  const auto file = file_from(disk, options);
  if (!file) return tl::unexpected(file.error());
  const Folder folder{options.folder};
  if (auto made = init_folder(disk, folder, *file); !made) return tl::unexpected(made.error());
  std::cout << folder.path << ": " << file->teams.size() << " teams, "
            << legs_per_fixture * round_robin(static_cast<int>(file->teams.size())).size()
            << " legs\n";
  return exit_yes;
}

Result<void> publish_site(record::Files& files, const Folder& folder, const LeagueState& state) {
  if (auto made = files.make_folder(folder.site()); !made) return made;
  for (const SiteFile& file : make_site(state)) {
    if (auto written = files.write(folder.site() + "/" + file.name, file.bytes); !written)
      return written;
  }
  const auto failed = make_replay_pages(files, folder, state);
  if (!failed) return tl::unexpected(failed.error());
  if (*failed > 0) {
    std::cerr << "mirocup: " << *failed
              << " replay pages could not be made; mirocup replay RECORD says why\n";
  }
  return {};
}

Result<int> start(const Options& options) {
  record::Disk disk;
  const Folder folder{options.folder};
  std::string notice;
  auto league = open_folder(disk, folder, &notice);
  if (!league) return tl::unexpected(league.error());
  if (!notice.empty()) std::cerr << "mirocup: " << notice << '\n';

  Runner runner(disk, folder, std::move(*league),
                [](const std::string& line) { std::cerr << line << '\n'; });
  const auto left = runner.run({.jobs = options.jobs});
  if (!left) return tl::unexpected(left.error());
  if (auto published = publish_site(disk, folder, runner.state()); !published) {
    return tl::unexpected(published.error());
  }
  std::cout << table_text(runner.state());
  if (*left == 0) return exit_yes;
  std::cerr << "mirocup: " << *left << " legs could not be decided: the host failed "
            << most_attempts << " times each; see the journal\n";
  return exit_no;
}

Result<int> status(const Options& options) {
  record::Disk disk;
  const auto league = open_folder(disk, Folder{options.folder});
  if (!league) return tl::unexpected(league.error());
  const LeagueState& state = league->state;
  if (options.json) {
    std::cout << table_json(state).dump() << '\n';
  } else {
    std::cout << state.file.title << ": " << state.played() << " of " << state.legs()
              << " legs played\n"
              << table_text(state);
  }
  return state.played() == state.legs() ? exit_yes : exit_no;
}

Result<int> publish(const Options& options) {
  record::Disk disk;
  const Folder folder{options.folder};
  const auto league = open_folder(disk, folder);
  if (!league) return tl::unexpected(league.error());
  if (auto published = publish_site(disk, folder, league->state); !published) {
    return tl::unexpected(published.error());
  }
  std::cout << std::filesystem::absolute(folder.site() + "/index.html").lexically_normal().string()
            << '\n';
  return exit_yes;
}

}  // namespace

void add_init(CLI::App& app, Run& run) {
  auto options = std::make_shared<Options>();
  CLI::App* sub = add(app, "init", "Make a league", run, options, init);
  sub->add_option("--config", options->config, "a league.json to start from");
  sub->add_option("--team", options->teams, "NAME=house:TEAM or NAME=FILE.so, once for each team")
      ->excludes("--config");
  sub->add_option("--half", options->half_s, "seconds of a half")->excludes("--config");
  sub->add_option("--seed", options->seed, "of everything that is drawn")->excludes("--config");
}

void add_start(CLI::App& app, Run& run) {
  auto options = std::make_shared<Options>();
  CLI::App* sub = add(app, "start", "Play the league, or go on with it", run, options, start);
  sub->add_option("--jobs", options->jobs, "legs at once (default: one for each processor)")
      ->check(CLI::Range(1, 1024));
}

void add_status(CLI::App& app, Run& run) {
  auto options = std::make_shared<Options>();
  CLI::App* sub = add(app, "status", "Say how the league stands", run, options, status);
  sub->add_flag("--json", options->json, "one JSON object on standard output");
}

void add_publish(CLI::App& app, Run& run) {
  auto options = std::make_shared<Options>();
  add(app, "publish", "Make the pages", run, options, publish);
}

}  // namespace mirocup::league
