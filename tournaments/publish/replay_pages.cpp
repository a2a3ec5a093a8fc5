// SPDX-License-Identifier: MIT
#include "tournaments/publish/replay_pages.hpp"

#include "record/json_reader.hpp"
#include "record/kept_module.hpp"
#include "record/match_record.hpp"
#include "system/locations.hpp"
#include "system/process_set.hpp"
#include "tournaments/league/schedule_growth.hpp"
#include "tournaments/publish/league_statistics.hpp"
#include "tournaments/publish/page_values.hpp"
#include "tournaments/publish/site.hpp"

#include <filesystem>
#include <utility>

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

bool is_pruned(const LeagueState& state, const FixtureState& f) {
  return state.pruned_nights.contains(f.fixture.round);
}

// True if a record or its replay was changed after its statistics were made.
bool has_changed(const Folder& folder, const std::string& record) {
  namespace fs = std::filesystem;
  const auto time_of = [](const std::string& path) {
    std::error_code unknown;
    return fs::last_write_time(path, unknown);
  };
  const auto made = time_of(folder.site() + "/" + statistics_file_of(record));
  const std::string path = folder.path + "/" + record;
  return time_of(path) > made || time_of(record::replay_path_of(path)) > made;
}

// True if the statistics that are kept for a record are of the leg that the journal has, as far as
// they can be read and the leg counts.
bool are_of_its_leg(system::Files& files, const Folder& folder, const FixtureState& f,
                    const std::string& record) {
  const auto hash = counted_hash(files, folder, record);
  return std::none_of(f.legs.begin(), f.legs.end(), [&](const LegState& leg) {
    return hash && leg.played && leg.played->record == record && leg.played->state_hash != *hash;
  });
}

// True if the page of a record is there with statistics that can be read. Of a pruned leg the
// statistics are enough.
bool has_page(system::Files& files, const Folder& folder, const FixtureState& f,
              const std::string& record, bool is_pruned) {
  if (!is_pruned && !files.exists(folder.site() + "/" + replay_page_of(record))) return false;
  if (has_changed(folder, record) || !are_of_its_leg(files, folder, f, record)) return false;
  return counted_hash(files, folder, record).has_value();
}

// Returns the path inside site/ of the file with the league's part of a record's page, and the
// module that the page names.
std::string part_file_of(const std::string& record) {
  return "replays/" + std::filesystem::path(record).stem().string() + ".league.json";
}

// Returns the content of that file; null if there is none, or it cannot be read.
Json read_part(system::Files& files, const Folder& folder, const std::string& record) {
  const auto text = files.read(folder.site() + "/" + part_file_of(record),
                               {.max_size = system::size_limit::note});
  return text ? record::parse_json(*text).value : Json();
}

// A page to make, and what the league puts on it.
struct NewPage {
  std::string record;
  Json part;
};

// Returns the command that makes a page. `module`: the name of the module's file; "": the page has
// no proof.
std::vector<std::string> command_for(const Folder& folder, const NewPage& page,
                                     const std::string& module) {
  std::vector<std::string> words{system::sibling_program("mirocup"),
                                 "replay",
                                 folder.path + "/" + page.record,
                                 "--no-times",
                                 "--public",
                                 "-o",
                                 folder.site() + "/" + replay_page_of(page.record),
                                 "--statistics",
                                 folder.site() + "/" + statistics_file_of(page.record),
                                 "--links=" + record::text_in(page.part, "links")};
  if (!page.part["names"].empty()) words.emplace_back("--names");
  for (const Json& name : page.part["names"]) {
    if (const auto* text = name.get_ptr<const std::string*>()) words.push_back(*text);
  }
  if (!module.empty()) words.insert(words.end(), {"--proof-module", "../" + module});
  return words;
}

Result<std::vector<NewPage>> missing_pages(system::Files& files, const Folder& folder,
                                           const Overview& o, const FailedPages& failed) {
  std::vector<NewPage> missing;
  for (const FixtureState& f : o.state.fixtures) {
    for (const std::string& record : records_of(files, folder, f)) {
      if (failed.refused.contains(record) || failed.has(record)) continue;
      const bool is_gone = is_pruned(o.state, f);
      Json part = league_part(o, record);
      if (has_page(files, folder, f, record, is_gone) &&
          (is_gone || has_page_with(files, folder, record, part)))
        continue;
      for (const auto& name :
           {replay_page_of(record), commands_file_of(record), statistics_file_of(record)})
        MIROCUP_TRY_VOID(files.read_if_there(folder.site() + "/" + name,
                                             {.max_size = system::size_limit::page}));
      missing.push_back({record, std::move(part)});
    }
  }
  return missing;
}

// Makes the pages that are missing or have another part, but for those that have failed.
Result<void> make_missing_pages(system::Files& files, const Folder& folder, const Overview& o,
                                int jobs, const std::optional<SiteModule>& module,
                                FailedPages& failed) {
  MIROCUP_TRY(auto missing, missing_pages(files, folder, o, failed));
  if (missing.empty()) return {};
  for (const char* name : {"/replays", "/statistics", "/module"}) {
    if (name == std::string("/module") && !module) continue;
    MIROCUP_TRY_VOID(files.make_folder(folder.site() + name));
  }
  if (module) MIROCUP_TRY_VOID(files.write(folder.site() + "/" + module->name, module->text));
  const std::string module_name = module ? module->name : "";
  const std::size_t at_once =
      jobs > 0 ? static_cast<std::size_t>(jobs) : system::processors().size();
  system::ProcessSet processes;
  for (std::size_t next = 0; next < missing.size() || processes.running() > 0;) {
    if (next < missing.size() && processes.running() < at_once) {
      MIROCUP_TRY_VOID(processes.start(
          command_for(folder, missing[next], module_name), static_cast<int>(next), -1, "/dev/null",
          {.seconds = record::limit_of_repeating(o.state.file.rules.half_s),
           .bytes = system::size_limit::page}));
      ++next;
      continue;
    }
    const auto exit = processes.wait();
    if (!exit) return fail(Errc::interrupted, "interrupted while making replay pages");
    NewPage& page = missing[static_cast<std::size_t>(exit->tag)];
    if (exit->signal == 0 && exit->code == exit_no) {
      failed.refused.insert(page.record);
    } else if (exit->signal != 0 || exit->code != exit_yes) {
      failed.records.push_back(page.record);
    } else {
      page.part["module"] = module_name;
      MIROCUP_TRY_VOID(files.write(folder.site() + "/" + part_file_of(page.record),
                                   record::json_text(page.part) + "\n"));
    }
  }
  return {};
}

// Removes modules that no page names.
Result<void> remove_other_modules(system::Files& files, const Folder& folder,
                                  const LeagueState& state) {
  std::set<std::string> modules;
  for (const FixtureState& f : state.fixtures) {
    for (const std::string& record : records_of(files, folder, f))
      modules.insert(record::text_in(read_part(files, folder, record), "module"));
  }
  return remove_former_pages(files, folder.site(), "module/", modules);
}

// Removes what was made of other legs: those of rounds that are not shown any more, and of nights
// that are pruned.
Result<void> remove_other_pages(system::Files& files, const Folder& folder,
                                const LeagueState& state) {
  std::set<std::string> shown;
  for (const FixtureState& f : state.fixtures) {
    for (const std::string& record : records_of(files, folder, f)) {
      shown.insert(statistics_file_of(record));
      if (is_pruned(state, f)) continue;
      shown.insert(replay_page_of(record));
      shown.insert(commands_file_of(record));
      shown.insert(part_file_of(record));
    }
  }
  for (const std::string part : {"replays/", "statistics/"}) {
    MIROCUP_TRY_VOID(remove_former_pages(files, folder.site(), part, shown));
  }
  return {};
}

bool is_ruled(const LeagueState& state, const std::string& fixture, int leg) {
  return std::any_of(state.decisions.begin(), state.decisions.end(), [&](const Decision& d) {
    const auto* ruled = std::get_if<Ruled>(&d.event);
    return ruled != nullptr && !d.undone_by && ruled->fixture == fixture && ruled->leg == leg;
  });
}

// Takes the legs of these records out of the state, and legs that are not those of the journal.
// Leaves in `records` those that count: the rest are of void attempts, or a person has decided.
void take_out(system::Files& files, const Folder& folder, LeagueState& state,
              std::set<std::string>& records) {
  std::set<std::string> counting;
  for (std::size_t i = 0; i < state.fixtures.size(); ++i) {
    for (int leg = 0; leg < max_legs; ++leg) {
      FixtureState& f = state.fixtures[i];
      if (!f.legs[leg].played || f.legs[leg].played->record.empty()) continue;
      PlayedLeg decided = *f.legs[leg].played;
      const std::string record = std::exchange(decided.record, "");
      if (!records.contains(record) && are_of_its_leg(files, folder, f, record)) continue;
      const bool counts = !is_ruled(state, f.fixture.id(), leg + 1);
      if (counts) counting.insert(record);
      f.legs[leg].played = counts ? nullptr : std::make_shared<const PlayedLeg>(decided);
      ScheduleGrowth(state).fixture_changed(static_cast<int>(i));
    }
  }
  records = counting;
}

}  // namespace

const FixtureState* fixture_of_record(const LeagueState& state, const std::string& record) {
  std::string id = std::filesystem::path(record).stem();
  for (int part = 0; part < 2; ++part) id = id.substr(0, id.rfind('-'));
  const auto index = state.find_fixture(id);
  return index ? &state.fixtures[static_cast<std::size_t>(*index)] : nullptr;
}

std::string page_of_record(const LeagueState& state, const std::string& root,
                           const std::string& record) {
  const FixtureState* f = fixture_of_record(state, record);
  return f != nullptr && is_pruned(state, *f) ? "" : root + replay_page_of(record);
}

std::string replay_page_of(const std::string& record) {
  return "replays/" + std::filesystem::path(record).stem().string() + ".html";
}

std::string commands_file_of(const std::string& record) {
  return "replays/" + std::filesystem::path(record).stem().string() + ".proof.js";
}

Result<FailedPages> make_replay_pages(system::Files& files, const Folder& folder,
                                      LeagueState& state, int jobs,
                                      const std::optional<SiteModule>& module) {
  MIROCUP_TRY_VOID(remove_other_pages(files, folder, state));
  FailedPages failed;
  const auto make = [&] {
    return make_missing_pages(files, folder, overview(state), jobs, module, failed);
  };
  MIROCUP_TRY_VOID(make());
  std::set<std::string> counting = failed.refused;
  take_out(files, folder, state, counting);
  MIROCUP_TRY_VOID(make());  // those that have a link to a leg that was taken out
  failed.refused = std::move(counting);
  // Statistics of pruned nights that were missing came with their pages.
  MIROCUP_TRY_VOID(remove_other_pages(files, folder, state));
  MIROCUP_TRY_VOID(remove_other_modules(files, folder, state));
  return failed;
}

namespace {

Json link_to(const Overview& o, const LegView* leg) {
  if (leg == nullptr) return false;
  return {{"page", leg->page("../")},
          {"pair", o.state.shown_name(leg->home) + " – " + o.state.shown_name(leg->away)}};
}

std::string nav(const Overview& o, const std::string& record) {
  const FixtureState* f = fixture_of_record(o.state, record);
  if (f == nullptr || !f->fixture.has_both()) return "";
  const LegView* own = nullptr;
  const LegView* before = nullptr;
  const LegView* after = nullptr;
  for (const LegView& leg : o.legs) {
    if (!leg.has_replay() || (leg.is_pruned && leg.played->record != record)) continue;
    if (own != nullptr) {
      after = &leg;
      break;
    }
    if (leg.played->record == record) {
      own = &leg;
    } else {
      before = &leg;
    }
  }
  std::string where = round_in_words(o.state, f->fixture);
  if (own != nullptr) where += ", leg " + std::to_string(own->leg);
  std::string note;
  if (own == nullptr) {
    note = "This attempt is void; the leg was or will be played again.";
  } else if (!own->played->ruling.empty()) {
    note = "A ruling decided this leg " + score_text(*own, own->home) + ": " + own->played->ruling;
  }
  return filled_page("replay_nav.html", {{"league", o.state.file.title},
                                         {"round_page", fixture_link(f->fixture)},
                                         {"where", where},
                                         {"home", team_values(o, f->fixture.home, "../")},
                                         {"away", team_values(o, f->fixture.away, "../")},
                                         {"before", link_to(o, own == nullptr ? nullptr : before)},
                                         {"after", link_to(o, after)},
                                         {"note", note}});
}

}  // namespace

Json league_part(const Overview& o, const std::string& record) {
  Json part{{"links", nav(o, record)}, {"names", Json::array()}};
  const FixtureState* f = fixture_of_record(o.state, record);
  const std::size_t version = record.rfind('-');
  if (f == nullptr || !f->fixture.has_both() || version == std::string::npos) return part;
  const int blue = blue_team(f->fixture, record[version - 1] - '0');
  const int yellow = blue == f->fixture.home ? f->fixture.away : f->fixture.home;
  for (const int team : {blue, yellow}) part["names"].push_back(o.state.shown_name(team));
  return part;
}

bool has_page_with(system::Files& files, const Folder& folder, const std::string& record,
                   const Json& part) {
  Json known = read_part(files, folder, record);
  if (known.is_object()) known.erase("module");
  return known == part && files.exists(folder.site() + "/" + replay_page_of(record));
}

}  // namespace mirocup::league
