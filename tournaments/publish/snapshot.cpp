// SPDX-License-Identifier: MIT
#include "tournaments/publish/snapshot.hpp"

#include "record/json_fields.hpp"
#include "tournaments/league/apply.hpp"
#include "tournaments/league/decisions.hpp"

#include <algorithm>

namespace mirocup::league {

namespace {

using Round = std::pair<bool, int>;  // as Fixture::round_order()

// Returns the round of a league with that name.
Result<Round> find_round(const LeagueState& whole, const std::string& name) {
  for (const FixtureState& f : whole.fixtures) {
    if (f.fixture.round_key() == name) return f.fixture.round_order();
  }
  return fail(Errc::input,
              "there is no round " + name + "; rounds are named like r3, without the fixture");
}

// As state_through(), for a round in its order.
Result<LeagueState> state_up_to(const LeagueState& whole, const Journal& journal, Round last,
                                const std::set<LegName>* legs = nullptr) {
  LeagueState state = new_league(whole.file);
  state.shown_names = whole.shown_names;
  state.pruned_nights = whole.pruned_nights;
  state.notice = whole.notice;
  const std::set<int> undone = undone_lines(journal, journal.lines().size());
  const bool is_nightly = whole.file.format.kind == FormatKind::nightly;
  bool has_last_begun = false;  // the last night; teams that join later are not in its pages
  for (const Json& line : journal.lines()) {
    const auto event = read_event(line);
    if (!event) return fail(Errc::damaged, journal.path() + ": " + event.error().what);
    if (const auto* night = std::get_if<NightBegan>(&*event)) {
      has_last_begun = is_nightly && night->number >= last.second;
      if (is_nightly && night->number > last.second) continue;
    }
    if (std::holds_alternative<TeamJoined>(*event)) {
      if (has_last_begun) continue;
    } else if (const std::string team = record::text_in(line, "team"); !team.empty()) {
      if (!state.find_team(team)) continue;  // it is to join later
    }
    const int number = record::value_in(line, "n", 0);
    if (const std::string id = record::text_in(line, "fixture"); !id.empty()) {
      // An unknown fixture follows from one that is left out.
      const auto index = state.find_fixture(id);
      if (!index) continue;
      const Round of = state.fixtures[*index].fixture.round_order();
      const LegName leg{id, record::value_in(line, "leg", 0)};
      if (of > last || (of == last && legs != nullptr && !legs->contains(leg))) continue;
    }
    if (undone.contains(number) && is_of_person(*event)) {
      note_undone_decision(state, *event, number);
      continue;
    }
    if (const auto* e = std::get_if<Undone>(&*event)) {
      if (std::ranges::count(state.decisions, e->line, &Decision::line) == 0)
        continue;  // a decision on a later round
    }
    if (const auto valid = validate(state, *event); !valid) {
      return fail(Errc::input,
                  "the rounds cannot be shown without the later ones: " + valid.error().what);
    }
    apply(state, *event, number);
  }
  return state;
}

}  // namespace

Result<LeagueState> state_through(const LeagueState& whole, const Journal& journal,
                                  const std::string& round, const std::set<LegName>* legs) {
  MIROCUP_TRY(const auto last, find_round(whole, round));
  return state_up_to(whole, journal, last, legs);
}

bool sees_all(Viewer viewer, const LeagueState& whole) {
  const Released& release = whole.release;
  return viewer == Viewer::staff ||
         (viewer == Viewer::team && release.level == ReleaseLevel::teams) ||
         (release.level == ReleaseLevel::all && release.through.empty());
}

bool sees_nights(Viewer viewer, const LeagueState& whole) {
  return sees_all(viewer, whole) || whole.file.format.kind == FormatKind::nightly;
}

SeenState seen_by(Viewer viewer, const LeagueState& whole, const LeagueState& released) {
  return SeenState(sees_all(viewer, whole) ? whole : released);
}

Result<LeagueState> released_state(const LeagueState& whole, const Journal& journal) {
  if (sees_all(Viewer::visitor, whole)) return whole;
  if (whole.release.through.empty()) return state_up_to(whole, journal, {});
  return state_through(whole, journal, whole.release.through);
}

}  // namespace mirocup::league
