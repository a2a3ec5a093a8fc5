// SPDX-License-Identifier: MIT
#include "tournaments/publish/replay_pages.hpp"

#include "system/locations.hpp"
#include "system/process_set.hpp"
#include "tournaments/publish/league_statistics.hpp"
#include "tournaments/publish/replay_nav.hpp"

#include <filesystem>

namespace mirocup::league {

namespace {

using Arguments = std::vector<std::string>;

// Returns the records of a fixture, those of void attempts included: they are evidence.
std::vector<std::string> records_of(system::Files& files, const Folder& folder,
                                    const FixtureState& f) {
  std::vector<std::string> records;
  for (int leg = 1; leg <= max_legs; ++leg) {
    const LegState& now = f.legs[leg - 1];
    for (int version = 1; version < now.version; ++version) {
      const std::string record = Folder::record_name(f.fixture, leg, version);
      if (files.exists(folder.path + "/" + record)) records.push_back(record);
    }
    if (now.played && !now.played->record.empty()) records.push_back(now.played->record);
  }
  return records;
}

// Returns the commands that make the missing pages.
std::vector<Arguments> missing_pages(system::Files& files, const Folder& folder,
                                     const LeagueState& state) {
  std::vector<Arguments> commands;
  for (const FixtureState& f : state.fixtures) {
    for (const std::string& record : records_of(files, folder, f)) {
      const std::string page = folder.site() + "/" + replay_page_of(record);
      if (files.exists(page) && has_statistics(files, folder, record)) continue;
      commands.push_back({system::sibling_program("mirocup"), "replay", folder.path + "/" + record,
                          "--no-times", "--public", "-o", page, "--statistics",
                          folder.site() + "/" + statistics_file_of(record)});
    }
  }
  return commands;
}

// Returns the number of pages that could not be made.
Result<int> make_missing_pages(system::Files& files, const Folder& folder, const LeagueState& state,
                               int jobs) {
  const std::vector<Arguments> commands = missing_pages(files, folder, state);
  if (commands.empty()) return 0;
  for (const char* name : {"/replays", "/statistics"}) {
    if (auto made = files.make_folder(folder.site() + name); !made) {
      return tl::unexpected(made.error());
    }
  }
  const std::size_t at_once =
      jobs > 0 ? static_cast<std::size_t>(jobs) : system::processors().size();
  system::ProcessSet processes;
  int failed = 0;
  std::size_t next = 0;
  while (next < commands.size() || processes.running() > 0) {
    if (next < commands.size() && processes.running() < at_once) {
      if (auto started = processes.start(commands[next++], 0, -1, "/dev/null"); !started) {
        return tl::unexpected(started.error());
      }
      continue;
    }
    const auto exit = processes.wait();
    if (!exit) return fail(Errc::interrupted, "interrupted while making replay pages");
    if (exit->code != exit_yes || exit->signal != 0) ++failed;
  }
  return failed;
}

// Writes the links of each page that has others by now. A page that cannot be read is left as it
// is.
Result<void> link_pages(system::Files& files, const Folder& folder, const Overview& overview) {
  for (const FixtureState& f : overview.state.fixtures) {
    for (const std::string& record : records_of(files, folder, f)) {
      const std::string path = folder.site() + "/" + replay_page_of(record);
      const auto page = files.read(path, {.max_size = system::size_limit::page});
      if (!page) continue;
      const std::string linked = with_league_links(*page, overview, record);
      if (linked == *page) continue;
      if (auto written = files.write(path, linked); !written) return written;
    }
  }
  return {};
}

}  // namespace

std::string replay_page_of(const std::string& record) {
  return "replays/" + std::filesystem::path(record).stem().string() + ".html";
}

Result<int> make_replay_pages(system::Files& files, const Folder& folder, const Overview& overview,
                              int jobs) {
  const auto failed = make_missing_pages(files, folder, overview.state, jobs);
  if (!failed) return failed;
  if (const auto linked = link_pages(files, folder, overview); !linked)
    return tl::unexpected(linked.error());
  return failed;
}

}  // namespace mirocup::league
