// SPDX-License-Identifier: MIT
#include "tournaments/league/schedule_growth.hpp"

#include "tournaments/format/swiss.hpp"

#include <algorithm>

namespace mirocup::league {

void ScheduleGrowth::add(const std::vector<Fixture>& fixtures) {
  // A schedule of 200 teams has 20 000 fixtures of half a kilobyte. Those that come later are few.
  const std::size_t size = state_.fixtures.size() + fixtures.size();
  if (state_.fixtures.empty()) {
    state_.fixtures.reserve(size);
    state_.index_of_fixture_.reserve(size);
  }
  for (const Fixture& fixture : fixtures) {
    const int index = static_cast<int>(state_.fixtures.size());
    state_.index_of_fixture_[fixture.id()] = index;
    state_.fixtures.emplace_back().fixture = fixture;
    give_walkover(index);
    count(index);
  }
}

void ScheduleGrowth::count(int index) {
  FixtureState& f = state_.fixtures[index];
  state_.needed_ -= f.counted_needed;
  state_.decided_ -= f.counted_decided;
  f.counted_needed = f.needed();
  f.counted_decided = f.decided();
  state_.needed_ += f.counted_needed;
  state_.decided_ += f.counted_decided;
}

void ScheduleGrowth::remove_last() {
  const FixtureState& last = state_.fixtures.back();
  state_.needed_ -= last.counted_needed;
  state_.decided_ -= last.counted_decided;
  state_.index_of_fixture_.erase(last.fixture.id());
  state_.fixtures.pop_back();
}

void ScheduleGrowth::fixture_changed(int fixture) {
  if (fixture != no_fixture) count(fixture);
  switch (state_.file.format.kind) {
    case FormatKind::groups:
    case FormatKind::knockout:
      fill_places(fixture);
      break;
    case FormatKind::swiss:
      pair_swiss();
      break;
    default:
      break;
  }
  state_.first_open_ = std::min(state_.first_open_, std::max(fixture, 0));
  const int size = static_cast<int>(state_.fixtures.size());
  while (state_.first_open_ < size && state_.fixtures[state_.first_open_].is_decided()) {
    ++state_.first_open_;
  }
}

void ScheduleGrowth::give_walkover(int index) {
  FixtureState& f = state_.fixtures[index];
  const bool is_tie = f.fixture.part == Part::knockout;
  if (f.fixture.home == unknown_team || f.fixture.away == unknown_team) return;
  if (!f.fixture.has_both() && !is_tie) return;
  if (is_tie && (f.walkover || (f.has_begun() && f.is_decided()))) return;
  const auto is_out = [this](int team) {
    return team == no_team || state_.teams[team].status == TeamStatus::withdrawn;
  };
  const bool home_out = is_out(f.fixture.home);
  const bool away_out = is_out(f.fixture.away);
  if (!home_out && !away_out) return;
  if (is_tie) {
    f.walkover = home_out && away_out ? TieOutcome{no_team, no_team}
                 : home_out           ? TieOutcome{f.fixture.away, f.fixture.home}
                                      : TieOutcome{f.fixture.home, f.fixture.away};
    if (!f.fixture.has_both()) return;
  }
  PlayedLeg leg;
  leg.result.home = f.fixture.home;
  leg.result.away = f.fixture.away;
  leg.result.both_lose = home_out && away_out;
  leg.end = LegEnd::withdrawn;
  if (!leg.result.both_lose) {
    (home_out ? leg.result.away_goals : leg.result.home_goals) = state_.file.rules.forfeit_goals;
  }
  const int legs = f.needed();
  for (int i = 0; i < legs; ++i) {
    if (!f.legs[i].played) f.legs[i].played = std::make_shared<const PlayedLeg>(leg);
  }
}

std::optional<int> ScheduleGrowth::team_of(const TeamSource& source) const {
  if (source.kind == TeamSource::Kind::team) return source.index;
  if (source.kind == TeamSource::Kind::place) {
    for (const FixtureState& f : state_.fixtures) {
      if (f.fixture.part == Part::group && f.fixture.group == source.index + 1 && !f.is_decided())
        return std::nullopt;
    }
    return state_.group_table(source.index)[source.place].team;
  }
  const TieOutcome o = outcome(state_, state_.fixtures[source.index]);
  const int team = source.kind == TeamSource::Kind::winner ? o.winner : o.loser;
  if (team == unknown_team) return std::nullopt;
  return team;
}

void ScheduleGrowth::fill_places(int changed) {
  // A team that is known stays, unless the tie or the group from which it comes has changed: of
  // those who leave, none changes who plays whom.
  std::vector<bool> has_changed(state_.fixtures.size());
  if (changed != no_fixture) has_changed[changed] = true;
  const auto team_from = [&](const TeamSource& source, int known) {
    bool is_new = known == unknown_team;
    if (source.kind == TeamSource::Kind::place) {
      const Fixture* f = changed != no_fixture ? &state_.fixtures[changed].fixture : nullptr;
      is_new = is_new || (f != nullptr && f->part == Part::group && f->group == source.index + 1);
    } else if (source.kind != TeamSource::Kind::team) {
      is_new = is_new || has_changed[source.index];
    }
    return is_new ? team_of(source).value_or(unknown_team) : known;
  };
  for (int i = 0; i < static_cast<int>(state_.fixtures.size()); ++i) {
    FixtureState& f = state_.fixtures[i];
    if (f.fixture.part != Part::knockout || f.has_begun()) continue;
    const int home = team_from(f.fixture.home_source, f.fixture.home);
    const int away = team_from(f.fixture.away_source, f.fixture.away);
    if (home == f.fixture.home && away == f.fixture.away) continue;
    f.fixture.home = home;
    f.fixture.away = away;
    f.legs = {};
    f.walkover.reset();
    has_changed[i] = true;
    give_walkover(i);
    count(i);
    state_.first_open_ = std::min(state_.first_open_, i);
  }
}

void ScheduleGrowth::pair_swiss() {
  // A round that has not begun is paired again, from the present results.
  std::vector<FixtureState>& fixtures = state_.fixtures;
  const auto last_round = [&] { return fixtures.empty() ? 0 : fixtures.back().fixture.round; };
  const auto of_round = [&](int round) {
    return std::ranges::find_if(
        fixtures, [round](const FixtureState& f) { return f.fixture.round == round; });
  };
  const int rounds = state_.file.format.swiss_rounds(static_cast<int>(state_.teams.size()));
  state_.unpaired_round = 0;
  while (true) {
    const int round = last_round();
    const auto begin = of_round(round);
    const bool has_begun = std::ranges::any_of(begin, fixtures.end(), &FixtureState::has_begun);
    if (round > 1 && !has_begun) {
      while (last_round() == round) remove_last();
      state_.first_open_ = std::min<int>(state_.first_open_, static_cast<int>(fixtures.size()));
      continue;
    }
    if (!std::ranges::all_of(fixtures, &FixtureState::is_decided) || round >= rounds) {
      return;
    }
    std::vector<SwissStanding> standings;
    for (const TableRow& row : state_.table()) {
      if (state_.teams[row.team].status != TeamStatus::withdrawn)
        standings.push_back({.team = row.team, .points = row.points});
    }
    std::vector<Fixture> before;
    for (const FixtureState& f : fixtures) before.push_back(f.fixture);
    const auto next = swiss_round(standings, before, round + 1, rounds);
    if (next.empty()) state_.unpaired_round = round + 1;
    add(next);
    return;
  }
}

void ScheduleGrowth::team_left(int team, bool annul) {
  for (int i = 0; i < static_cast<int>(state_.fixtures.size()); ++i) {
    FixtureState& f = state_.fixtures[i];
    if (f.fixture.home != team && f.fixture.away != team) continue;
    if (annul && f.fixture.part != Part::knockout) {
      f.is_annulled = true;
    } else {
      give_walkover(i);
    }
    count(i);
  }
  if (state_.fixtures.empty()) return;
  fixture_changed(no_fixture);
}

void ScheduleGrowth::team_joined(const TeamJoined& joined) {
  state_.index_of_team_[joined.team] = static_cast<int>(state_.teams.size());
  state_.file.teams.push_back({.name = joined.team, .source = joined.source, .has_joined = true});
  state_.teams.emplace_back();
  std::vector<std::string>& names = state_.shown_names;
  if (!names.empty() && names.size() < state_.teams.size()) names.push_back(joined.team);
}

void ScheduleGrowth::entry_booked(int team) {
  if (!state_.file.format.is_open_ended()) return;
  ++state_.entries_;
  std::vector<int> others;
  for (int other = 0; other < static_cast<int>(state_.teams.size()); ++other) {
    const TeamState& s = state_.teams[other];
    if (other != team && s.entry > 0 && s.status == TeamStatus::playing) others.push_back(other);
  }
  // Results of the entry before count for the opponents only, and its open legs are not played.
  for (int i = 0; i < static_cast<int>(state_.fixtures.size()); ++i) {
    FixtureState& f = state_.fixtures[i];
    if (f.fixture.home != team && f.fixture.away != team) continue;
    bool is_played = true;
    for (int leg = 0; leg < f.fixture.legs; ++leg) {
      if (!f.legs[leg].played) {
        is_played = false;
        continue;
      }
      PlayedLeg played = *f.legs[leg].played;
      (f.fixture.home == team ? played.result.home_entry_still_plays
                              : played.result.away_entry_still_plays) = false;
      f.legs[leg].played = std::make_shared<const PlayedLeg>(played);
    }
    f.is_annulled = f.is_annulled || !is_played;
    count(i);
  }
  if (state_.file.format.kind == FormatKind::ladder)
    add(ladder_fixtures(state_.entries_, team, others, state_.file.format.sample,
                        state_.file.seed));
  if (!state_.fixtures.empty()) fixture_changed(0);
}

void ScheduleGrowth::night_began(int number) {
  if (state_.file.format.kind != FormatKind::nightly) return;
  std::vector<int> teams;
  for (int team = 0; team < static_cast<int>(state_.teams.size()); ++team) {
    const TeamState& s = state_.teams[team];
    if (s.entry > 0 && s.status == TeamStatus::playing) teams.push_back(team);
  }
  add(night_fixtures(number, teams, state_.file.format.opponents));
  if (!state_.fixtures.empty()) fixture_changed(0);
}

}  // namespace mirocup::league
