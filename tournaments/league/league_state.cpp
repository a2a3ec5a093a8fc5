// SPDX-License-Identifier: MIT
#include "tournaments/league/league_state.hpp"

#include "core/base/random.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace mirocup::league {

namespace {

// The stage that each team reached in the knockout, as a number: 4 for each round that it played,
// minus 3 in the tie for the third place, plus 2 for winning the final or that tie. A team thus
// ranks above all that reached an earlier round, and the tie for the third place ranks below the
// final.
std::vector<int> stage_reached(const LeagueState& state) {
  if (!state.file.format.has_knockout()) return {};
  std::vector<int> far(state.file.teams.size(), 0);
  int last_round = 0;
  for (const FixtureState& f : state.fixtures) {
    if (f.fixture.part == Part::knockout) last_round = std::max(last_round, f.fixture.round);
  }
  for (const FixtureState& f : state.fixtures) {
    const Fixture& tie = f.fixture;
    if (tie.part != Part::knockout) continue;
    for (const int team : {tie.home, tie.away}) {
      if (team >= 0) far[team] = std::max(far[team], 4 * tie.round);
    }
    const TieOutcome o = outcome(state, f);
    if (tie.round != last_round) continue;
    if (tie.is_for_third_place()) {
      for (const int team : {tie.home, tie.away}) {
        if (team >= 0) far[team] = 4 * last_round - 3;
      }
    }
    if (o.winner >= 0) far[o.winner] += 2;
  }
  return far;
}

}  // namespace

int FixtureState::goals(int team) const {
  int sum = 0;
  for (const LegState& leg : legs) {
    if (!leg.played) continue;
    sum += team == fixture.home ? leg.played->result.home_goals : leg.played->result.away_goals;
  }
  return sum;
}

int FixtureState::needed() const {
  if (is_annulled || fixture.home == no_team || fixture.away == no_team) return 0;
  if (fixture.part != Part::knockout) return fixture.legs;
  int home = 0;
  int away = 0;
  for (int i = 0; i < fixture.legs; ++i) {
    if (!legs[i].played) return fixture.legs;
    if (legs[i].played->end == LegEnd::withdrawn) return fixture.legs;
    home += legs[i].played->result.home_goals;
    away += legs[i].played->result.away_goals;
  }
  return fixture.legs + (home == away ? 1 : 0);
}

int FixtureState::decided() const {
  const int count = needed();
  int done = 0;
  for (int i = 0; i < count; ++i) done += legs[i].played ? 1 : 0;
  return done;
}

bool FixtureState::is_decided() const {
  if (fixture.home == unknown_team || fixture.away == unknown_team) return false;
  return decided() == needed();
}

bool FixtureState::has_begun() const {
  return std::ranges::any_of(legs, [](const LegState& leg) {
    return leg.voids > 0 || (leg.played && leg.played->end != LegEnd::withdrawn);
  });
}

bool LeagueState::is_over() const {
  if (file.format.kind == FormatKind::nightly && !is_closed) return false;
  return is_started && decided_ == needed_;
}

std::optional<int> LeagueState::find_fixture(const std::string& id) const {
  const auto found = index_of_fixture_.find(id);
  if (found == index_of_fixture_.end()) return std::nullopt;
  return found->second;
}

const std::string& LeagueState::frozen_from(const std::string& team) const {
  const std::string& all = frozen_from();
  for (const auto* known : {&extensions, &file.extensions}) {
    const auto found = known->find(team);
    if (found != known->end()) return all.empty() || found->second < all ? all : found->second;
  }
  return all;
}

std::string LeagueState::shown_name_of(const std::string& team) const {
  const auto index = find_team(team);
  return index ? shown_name(*index) : team;
}

std::optional<int> LeagueState::find_team(const std::string& name) const {
  const auto found = index_of_team_.find(name);
  if (found == index_of_team_.end()) return std::nullopt;
  return found->second;
}

std::vector<LegResult> LeagueState::results() const {
  std::vector<LegResult> results;
  for (const FixtureState& f : fixtures) {
    if (f.is_annulled) continue;
    if (f.fixture.away == no_team && f.fixture.part == Part::table) {
      // A bye counts as a win for each leg that it replaces.
      LegResult bye;
      bye.home = f.fixture.home;
      bye.away = no_team;
      results.insert(results.end(), legs_per_fixture, bye);
    }
    for (const LegState& leg : f.legs) {
      if (leg.played) results.push_back(leg.played->result);
    }
  }
  return results;
}

Ratings LeagueState::ratings(const std::vector<FixtureResults>& further) const {
  std::vector<FixtureResults> fixtures_played;
  std::vector<int> present(teams.size(), no_entry);
  for (const FixtureState& f : fixtures) {
    FixtureResults played;
    for (int i = 0; i < f.needed(); ++i) {
      // A leg that was not played says nothing about strength.
      const PlayedLeg* leg = f.legs[i].played.get();
      if (leg != nullptr && !leg->record.empty()) played.push_back(leg->result);
    }
    if (!played.empty()) fixtures_played.push_back(std::move(played));
  }
  fixtures_played.insert(fixtures_played.end(), further.begin(), further.end());
  if (!file.format.is_open_ended()) return rate(static_cast<int>(teams.size()), fixtures_played);
  for (const LegResult& leg : results()) {
    if (leg.home_entry_still_plays) present[leg.home] = teams[leg.home].entry;
    if (leg.away_entry_still_plays) present[leg.away] = teams[leg.away].entry;
  }
  return rate_entries(present, std::move(fixtures_played), file.format.kind == FormatKind::ladder);
}

std::vector<TableRow> LeagueState::table() const {
  return table(file.format.is_open_ended() ? ratings() : Ratings());
}

std::vector<TableRow> LeagueState::table(const Ratings& ratings) const {
  TableRules rules = file.table_rules();
  rules.by_points_per_leg = file.format.is_open_ended();
  rules.has_uneven_groups = file.format.kind == FormatKind::groups &&
                            static_cast<int>(teams.size()) % file.format.groups != 0;
  // Strengths that pages show as equal are equal.
  for (const Strength& strength : ratings.strengths) {
    if (rules.by_points_per_leg) rules.strengths.push_back(std::round(strength.value));
  }
  for (const TeamState& team : teams)
    rules.has_left.push_back(team.status == TeamStatus::withdrawn);
  std::vector<TableRow> rows = make_table(all_teams(static_cast<int>(file.teams.size())), results(),
                                          rules, stage_reached(*this));
  // The absent come last, and have no rank that lots could decide: Gruppe 2 before Gruppe 10.
  std::stable_sort(std::ranges::find(rows, 0, &TableRow::rank), rows.end(),
                   [this](const TableRow& a, const TableRow& b) {
                     return strverscmp(shown_name(a.team).c_str(), shown_name(b.team).c_str()) < 0;
                   });
  return rows;
}

std::vector<TableRow> LeagueState::group_table(int group) const {
  std::vector<LegResult> results;
  for (const FixtureState& f : fixtures) {
    if (f.is_annulled || f.fixture.part != Part::group || f.fixture.group != group + 1) continue;
    for (const LegState& leg : f.legs) {
      if (leg.played) results.push_back(leg.played->result);
    }
  }
  const auto groups = deal_groups(static_cast<int>(teams.size()), file.format.groups);
  return make_table(groups[group], results, file.table_rules());
}

TieOutcome outcome(const LeagueState& state, const FixtureState& tie) {
  const Fixture& f = tie.fixture;
  if (!tie.is_decided()) return {};
  if (tie.walkover) return *tie.walkover;
  int difference = tie.goals(f.home) - tie.goals(f.away);
  for (const LegState& leg : tie.legs) {
    // Only the leg that decides a level tie can end in a shoot-out.
    if (difference == 0 && leg.played && leg.played->end == LegEnd::shoot_out)
      difference = leg.played->winner == f.home ? 1 : leg.played->winner == f.away ? -1 : 0;
  }
  if (difference == 0) {
    difference = Random(fixture_seed(state.file.seed, f)).coin() ? 1 : -1;
  }
  return difference > 0 ? TieOutcome{f.home, f.away} : TieOutcome{f.away, f.home};
}

std::string unpaired_in_words(const LeagueState& state) {
  if (state.unpaired_round == 0) return "";
  const int rounds = state.file.format.swiss_rounds(static_cast<int>(state.teams.size()));
  return "round " + std::to_string(state.unpaired_round) + " of " + std::to_string(rounds) +
         " is not played: teams have left, and those that remain cannot be paired without a pair "
         "that has met already";
}

}  // namespace mirocup::league
