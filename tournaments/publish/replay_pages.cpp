// SPDX-License-Identifier: MIT
#include "tournaments/publish/replay_pages.hpp"

#include "record/json_reader.hpp"
#include "record/kept_module.hpp"
#include "record/match_record.hpp"
#include "system/locations.hpp"
#include "system/process_set.hpp"
#include "tournaments/league/schedule_growth.hpp"
#include "tournaments/publish/page_values.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <utility>

namespace mirocup::league {

namespace {

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

// Returns what the league has put on a page, with the names of the page's module and of its script;
// null if there is no such file, or it cannot be read.
Json kept_part(system::Files& files, const Folder& folder, const std::string& record) {
  const auto text = files.read(folder.site() + "/" + part_file_of(record),
                               {.max_size = system::size_limit::note});
  return text ? record::parse_json(*text).value : Json();
}

// What the league's part has besides the files beside the page.
bool is_same_part(Json kept, const Json& part) {
  for (const char* file : {"module", "script"}) {
    if (kept.is_object()) kept.erase(file);
  }
  return kept == part;
}

// A page to make, and what the league puts on it.
struct NewPage {
  LegName leg;
  std::string record;
  Json part;
};

// Returns the command that makes a page. `module`: the name of the module's file; "": the page has
// no proof.
std::vector<std::string> command_for(const Folder& folder, const NewPage& page,
                                     const std::string& module) {
  std::vector<std::string> words{system::sibling_program("mirocup"), "replay"};
  words.push_back(folder.path + "/" + page.record);
  words.insert(words.end(), {"--no-times", "--public", "-o"});
  words.push_back(folder.site() + "/" + replay_page_of(page.record));
  words.insert(words.end(),
               {"--statistics", folder.site() + "/" + statistics_file_of(page.record)});
  words.push_back("--links=" + record::text_in(page.part, "links"));
  words.insert(words.end(), {"--page-files", "../"});
  if (!page.part["names"].empty()) words.emplace_back("--names");
  for (const Json& name : page.part["names"]) {
    if (const auto* text = name.get_ptr<const std::string*>()) words.push_back(*text);
  }
  if (!module.empty()) words.insert(words.end(), {"--proof-module", "../" + module});
  return words;
}

bool is_ruled(const LeagueState& state, const std::string& fixture, int leg) {
  return std::ranges::any_of(state.decisions, [&](const Decision& d) {
    const auto* ruled = std::get_if<Ruled>(&d.event);
    return ruled != nullptr && !d.undone_by && ruled->fixture == fixture && ruled->leg == leg;
  });
}

// A record of a leg. That of a void attempt stays as evidence.
struct Attempt {
  LegName leg;
  std::string record;
  const PlayedLeg* played;  // null: the attempt is void
  bool is_pruned;
};

class ReplayPages {
 public:
  ReplayPages(system::Files& files, const Folder& folder, LeagueState& state,
              const PageParts& parts, int jobs)
      : files_(files), folder_(folder), state_(state), parts_(parts), jobs_(jobs) {}

  Result<PublishedLegs> make() {
    MIROCUP_TRY_VOID(remove_other_pages());
    read_legs(files_, folder_, state_, legs_.known);
    for (const Attempt& attempt : attempts()) pages_[attempt.record] = kept_page(attempt);
    // What is new first: a record that differs from its replay has no links from other pages.
    MIROCUP_TRY_VOID(make_missing(false));
    take_out_others();
    do {
      MIROCUP_TRY_VOID(make_missing(true));
    } while (take_out_others());
    // Statistics of pruned nights that were missing came with their pages.
    MIROCUP_TRY_VOID(remove_other_pages());
    std::set<std::string> modules;
    for (const Attempt& attempt : attempts()) {
      const Json& part = pages_[attempt.record].part;
      const std::string script = record::text_in(part, "script");
      modules.insert(
          {record::text_in(part, "module"), script, script.substr(0, script.rfind('.')) + ".css"});
    }
    MIROCUP_TRY_VOID(remove_former_pages(files_, folder_.site(), "module/", modules));
    return std::move(legs_);
  }

 private:
  struct KeptPage {
    bool is_fresh = false;  // page and statistics are there, and not older than the record
    Json part;              // as kept_part()
    int code = exit_yes;    // exit_no: the record differs from its replay; other: no page was made
  };

  std::vector<Attempt> attempts() const {
    std::vector<Attempt> all;
    for (const FixtureState& f : state_.fixtures) {
      const auto add = [&](int leg, const std::string& record, const PlayedLeg* played) {
        all.push_back({{f.fixture.id(), leg}, record, played, is_pruned(state_, f)});
      };
      for (int leg = 1; leg <= max_legs; ++leg) {
        const LegState& now = f.legs[leg - 1];
        for (int version = 1; version < now.version; ++version) {
          const std::string record = Folder::record_name(f.fixture, leg, version);
          if (files_.exists(folder_.path + "/" + record)) add(leg, record, nullptr);
        }
        if (now.played && !now.played->record.empty())
          add(leg, now.played->record, now.played.get());
      }
    }
    return all;
  }

  // Of a pruned leg the statistics are enough.
  KeptPage kept_page(const Attempt& attempt) {
    const std::string& record = attempt.record;
    auto& report = legs_.known[record].report;
    if (attempt.played == nullptr) report = kept_report(files_, folder_, attempt.leg, record);
    const bool is_there =
        attempt.is_pruned || files_.exists(folder_.site() + "/" + replay_page_of(record));
    return {.is_fresh = is_there && report && !has_changed(folder_, record) &&
                        (attempt.played == nullptr || is_of(*report, *attempt.played)),
            .part = kept_part(files_, folder_, record)};
  }

  // Removes what was made of other legs: those of rounds that are not shown any more, and of nights
  // that are pruned.
  Result<void> remove_other_pages() {
    std::set<std::string> shown;
    for (const Attempt& attempt : attempts()) {
      const std::string& record = attempt.record;
      shown.insert(statistics_file_of(record));
      if (attempt.is_pruned) continue;
      shown.insert({replay_page_of(record), commands_file_of(record), part_file_of(record)});
    }
    for (const std::string part : {"replays/", "statistics/"})
      MIROCUP_TRY_VOID(remove_former_pages(files_, folder_.site(), part, shown));
    return {};
  }

  // Returns the pages that are missing or, if `compares_parts`, have another part, but for those
  // that have failed.
  Result<std::vector<NewPage>> missing(bool compares_parts) {
    std::vector<NewPage> missing;
    std::optional<Overview> o;
    for (const Attempt& attempt : attempts()) {
      const std::string& record = attempt.record;
      const KeptPage& kept = pages_[record];
      const bool may_stay = kept.is_fresh && (attempt.is_pruned || !compares_parts);
      if (may_stay || kept.code != exit_yes) continue;
      if (!o) o.emplace(overview(state_));
      Json part = league_part(*o, record);
      if (kept.is_fresh && is_same_part(kept.part, part)) continue;
      for (const auto& name :
           {replay_page_of(record), commands_file_of(record), statistics_file_of(record)})
        MIROCUP_TRY_VOID(files_.read_if_there(folder_.site() + "/" + name,
                                              {.max_size = system::size_limit::page}));
      missing.push_back({attempt.leg, record, std::move(part)});
    }
    return missing;
  }

  Result<void> make_missing(bool compares_parts) {
    MIROCUP_TRY(auto missing, this->missing(compares_parts));
    if (missing.empty()) return {};
    for (const char* name : {"/replays", "/statistics", "/module"})
      MIROCUP_TRY_VOID(files_.make_folder(folder_.site() + name));
    const std::string module = parts_.module ? parts_.module->name : "";
    for (const SiteFile& file : parts_.all())
      MIROCUP_TRY_VOID(files_.update(folder_.site() + "/" + file.name, file.bytes));
    const std::size_t at_once =
        jobs_ > 0 ? static_cast<std::size_t>(jobs_) : system::processors().size();
    system::ProcessSet processes;
    for (std::size_t next = 0; next < missing.size() || processes.running() > 0;) {
      if (next < missing.size() && processes.running() < at_once) {
        MIROCUP_TRY_VOID(processes.start(
            command_for(folder_, missing[next], module), static_cast<int>(next), -1, "/dev/null",
            {.seconds = record::limit_of_repeating(state_.file.rules.half_s),
             .bytes = system::size_limit::page}));
        ++next;
        continue;
      }
      const auto exit = processes.wait();
      if (!exit) return fail(Errc::interrupted, "interrupted while making replay pages");
      NewPage& page = missing[static_cast<std::size_t>(exit->tag)];
      page.part["module"] = module;
      page.part["script"] = parts_.page.front().name;
      MIROCUP_TRY_VOID(note_end(page, exit->signal == 0 ? exit->code : exit_code(Errc::host)));
    }
    return {};
  }

  // Takes over what `mirocup replay` has made of a leg.
  Result<void> note_end(NewPage& page, int code) {
    pages_[page.record].code = code;
    if (code != exit_yes && code != exit_no) legs_.without_page.push_back(page.record);
    if (code != exit_yes) return {};
    MIROCUP_TRY_VOID(files_.write(folder_.site() + "/" + part_file_of(page.record),
                                  record::json_text(page.part) + "\n"));
    legs_.known[page.record].report = kept_report(files_, folder_, page.leg, page.record);
    pages_[page.record] = {.is_fresh = true, .part = std::move(page.part)};
    return {};
  }

  // Takes legs out whose record differs from its replay, or is not that of the journal's leg.
  // Returns false if there is none.
  bool take_out_others() {
    bool any = false;
    for (std::size_t i = 0; i < state_.fixtures.size(); ++i) {
      for (int leg = 0; leg < max_legs; ++leg) {
        FixtureState& f = state_.fixtures[i];
        if (!f.legs[leg].played || f.legs[leg].played->record.empty()) continue;
        PlayedLeg decided = *f.legs[leg].played;
        const std::string record = std::exchange(decided.record, "");
        const auto& report = legs_.known[record].report;
        if (pages_[record].code != exit_no && (!report || is_of(*report, decided))) continue;
        any = true;
        const bool counts = !is_ruled(state_, f.fixture.id(), leg + 1);
        if (counts) legs_.refused.insert(record);
        f.legs[leg].played = counts ? nullptr : std::make_shared<const PlayedLeg>(decided);
        ScheduleGrowth(state_).fixture_changed(static_cast<int>(i));
      }
    }
    return any;
  }

  system::Files& files_;
  const Folder& folder_;
  LeagueState& state_;
  const PageParts& parts_;
  const int jobs_;
  PublishedLegs legs_;
  std::map<std::string, KeptPage> pages_;  // by record
};

// Returns the fixture of a record, also of a void attempt: "r1-f2" for "records/r1-f2-1-1.json".
const FixtureState* fixture_of_record(const LeagueState& state, const std::string& record) {
  std::string id = std::filesystem::path(record).stem();
  for (int part = 0; part < 2; ++part) id = id.substr(0, id.rfind('-'));
  const auto index = state.find_fixture(id);
  return index ? &state.fixtures[static_cast<std::size_t>(*index)] : nullptr;
}

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

std::vector<SiteFile> PageParts::all() const {
  std::vector<SiteFile> files = page;
  if (module) files.push_back(*module);
  return files;
}

Result<PublishedLegs> publish_legs(system::Files& files, const Folder& folder, LeagueState& state,
                                   const PageParts& parts, int jobs) {
  return ReplayPages(files, folder, state, parts, jobs).make();
}

Json league_part(const Overview& o, const std::string& record) {
  Json part{{"links", nav(o, record)}, {"names", Json::array()}};
  const FixtureState* f = fixture_of_record(o.state, record);
  const std::size_t version = record.rfind('-');
  if (f == nullptr || !f->fixture.has_both() || version == std::string::npos) return part;
  const auto [blue, yellow] = f->fixture.colours(record[version - 1] - '0');
  for (const int team : {blue, yellow}) part["names"].push_back(o.state.shown_name(team));
  return part;
}

bool has_page_with(system::Files& files, const Folder& folder, const std::string& record,
                   const Json& part) {
  return is_same_part(kept_part(files, folder, record), part) &&
         files.exists(folder.site() + "/" + replay_page_of(record));
}

}  // namespace mirocup::league
