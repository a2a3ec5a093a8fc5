// SPDX-License-Identifier: MIT
#include "tournaments/league/decisions.hpp"

#include <algorithm>

namespace mirocup::league {

namespace {

bool is_pause_of(const std::string& team, const Event& event) {
  const auto* paused = std::get_if<Paused>(&event);
  return paused != nullptr && paused->team == team;
}

template <class OfLeg>
bool is_of_leg(const std::string& fixture, int leg, const Event& event) {
  const auto* e = std::get_if<OfLeg>(&event);
  return e != nullptr && e->fixture == fixture && e->leg == leg;
}

// True if the decision made a leg void that has not been played again since. `state` is the state
// after all decisions of its list.
bool awaits_replay(const LeagueState& state, std::size_t decision) {
  const auto* voided = std::get_if<LegVoided>(&state.decisions[decision].event);
  if (voided == nullptr) return false;
  const auto fixture = state.find_fixture(voided->fixture);
  if (!fixture || state.fixtures[*fixture].legs[voided->leg - 1].played) return false;
  // After a later void, the leg has been played in between.
  return std::none_of(state.decisions.begin() + static_cast<std::ptrdiff_t>(decision) + 1,
                      state.decisions.end(), [&](const Decision& d) {
                        return is_of_leg<LegVoided>(voided->fixture, voided->leg, d.event);
                      });
}

// Says whether an event ends the effect of an earlier decision that no other has ended.
struct Undoes {
  const LeagueState& state;  // before the event
  std::size_t decision;      // the earlier one
  const Event& earlier = state.decisions[decision].event;

  bool operator()(const Ruled& e) const {
    if (is_of_leg<LegVoided>(e.fixture, e.leg, earlier)) return awaits_replay(state, decision);
    return is_of_leg<Ruled>(e.fixture, e.leg, earlier);
  }

  bool operator()(const LegVoided& e) const { return is_of_leg<Ruled>(e.fixture, e.leg, earlier); }

  bool operator()(const Withdrawn& e) const {
    if (is_pause_of(e.team, earlier)) return true;
    const std::string* id = fixture_of(earlier);
    const auto index = id != nullptr ? state.find_fixture(*id) : std::nullopt;
    if (!index) return false;
    const Fixture& fixture = state.fixtures[*index].fixture;
    const int team = *state.find_team(e.team);
    if (fixture.home != team && fixture.away != team) return false;
    const bool is_annulled = e.results == WithdrawnResults::annul && fixture.part != Part::knockout;
    return is_annulled || awaits_replay(state, decision);
  }

  bool operator()(const Resumed& e) const { return is_pause_of(e.team, earlier); }

  bool operator()(const Frozen&) const { return std::holds_alternative<Frozen>(earlier); }

  bool operator()(const Extended& e) const {
    const auto* extended = std::get_if<Extended>(&earlier);
    return extended != nullptr && extended->team == e.team;
  }

  bool operator()(const Released&) const { return std::holds_alternative<Released>(earlier); }

  bool operator()(const Undone& e) const { return state.decisions[decision].line == e.line; }

  template <class NoDecision>
  bool operator()(const NoDecision&) const {
    return false;
  }
};

std::string score_before(const LeagueState& state, const auto& event) {
  const auto index = state.find_fixture(event.fixture);
  if (!index || event.leg < 1 || event.leg > max_legs) return "";
  const auto& played = state.fixtures[*index].legs[event.leg - 1].played;
  if (!played) return "was not decided";
  return "was " + std::to_string(played->result.home_goals) + ":" +
         std::to_string(played->result.away_goals);
}

}  // namespace

std::string before_in_words(const LeagueState& state, const Event& event) {
  if (const auto* ruled = std::get_if<Ruled>(&event)) return score_before(state, *ruled);
  const auto* voided = std::get_if<LegVoided>(&event);
  return voided != nullptr ? score_before(state, *voided) : "";
}

bool is_of_person(const Event& event) {
  if (const auto* voided = std::get_if<LegVoided>(&event))
    return voided->cause == VoidCause::ruling;
  if (const auto* paused = std::get_if<Paused>(&event)) return !paused->is_by_program;
  return std::holds_alternative<Ruled>(event) || std::holds_alternative<Withdrawn>(event) ||
         std::holds_alternative<Resumed>(event) || std::holds_alternative<Frozen>(event) ||
         std::holds_alternative<Extended>(event) || std::holds_alternative<Closed>(event) ||
         std::holds_alternative<Released>(event) || std::holds_alternative<Undone>(event);
}

void note_decision(LeagueState& state, const Event& event, int line) {
  if (!is_of_person(event)) return;
  const std::size_t count = state.decisions.size();
  for (std::size_t i = 0; i < count; ++i) {
    Decision& decision = state.decisions[i];
    if (!decision.undone_by && std::visit(Undoes{state, i}, event)) decision.undone_by = count;
  }
  note_undone_decision(state, event, line);
}

void note_undone_decision(LeagueState& state, const Event& event, int line) {
  if (!is_of_person(event)) return;
  state.decisions.push_back(
      {.event = event, .line = line, .what = before_in_words(state, event), .undone_by = {}});
}

}  // namespace mirocup::league
