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

// Returns "r1-f1 leg 2, a – b".
std::string leg_in_words(const LeagueState& state, const auto& e) {
  std::string words = e.fixture + " leg " + std::to_string(e.leg);
  const auto index = state.find_fixture(e.fixture);
  if (!index) return words;
  const Fixture& f = state.fixtures[*index].fixture;
  return f.has_both() ? words + ", " + state.shown_name(f.home) + " – " + state.shown_name(f.away)
                      : words;
}

struct DecisionWriter {
  const LeagueState& state;

  std::string operator()(const LegVoided& e) const {
    return leg_in_words(state, e) + ": void, to be played again with " +
           (e.has_new_seed ? "another seed" : "the same seed");
  }
  std::string operator()(const Ruled& e) const {
    return leg_in_words(state, e) + ": " + std::to_string(e.score.home) + ":" +
           std::to_string(e.score.away);
  }
  std::string operator()(const Withdrawn& e) const {
    return state.shown_name_of(e.team) + (e.results == WithdrawnResults::keep
                                              ? " withdrawn, its results stay"
                                              : " withdrawn, its results count for nothing");
  }
  std::string operator()(const Paused& e) const { return state.shown_name_of(e.team) + " paused"; }
  std::string operator()(const Resumed& e) const {
    return state.shown_name_of(e.team) + " plays on";
  }
  std::string operator()(const Frozen& e) const {
    return e.from.empty() ? "entries are taken again"
                          : "from " + shown_time(state.file, e.from) + " on, no entry is taken";
  }
  std::string operator()(const Extended& e) const {
    return state.shown_name_of(e.team) + " may hand in until " + shown_time(state.file, e.until);
  }
  std::string operator()(const Closed& e) const {
    return std::string("the league is closed") +
           (e.closing_round.empty() ? "" : "; a closing round decides the season");
  }
  std::string operator()(const Released& e) const {
    return "pages show " +
           (!e.through.empty()             ? "the rounds through " + e.through
            : e.level == ReleaseLevel::all ? "every round"
                                           : "no round") +
           (e.level == ReleaseLevel::teams ? "; teams read their own digests" : "");
  }
  std::string operator()(const Undone& e) const {
    for (std::size_t i = 0; i < state.decisions.size(); ++i) {
      if (state.decisions[i].line == e.line)
        return "decision " + std::to_string(i + 1) + " is undone";
    }
    return "a decision is undone";
  }
  std::string operator()(const auto&) const { return ""; }  // no decision
};

std::string undoing_in_words(const LeagueState& state, const Event& by, int number) {
  const std::string which = " by " + std::to_string(number);
  if (const auto* left = std::get_if<Withdrawn>(&by))
    return "covered" + which + ", " + state.shown_name_of(left->team) + " has withdrawn";
  if (std::holds_alternative<Undone>(by)) return "undone" + which;
  return (std::holds_alternative<Resumed>(by) ? "ended" : "overruled") + which;
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

std::string decision_in_words(const LeagueState& state, const Event& event) {
  return std::visit(DecisionWriter{state}, event);
}

std::vector<DecisionView> decision_views(const LeagueState& state) {
  std::vector<DecisionView> views;
  for (const Decision& decision : state.decisions) {
    DecisionView view{.number = static_cast<int>(views.size()) + 1,
                      .what = decision_in_words(state, decision.event)};
    const auto sign = [&view](const auto& e) {
      if constexpr (requires { e.signature; }) {
        view.kind = e.kind;
        view.signature = e.signature;
      }
    };
    std::visit(sign, decision.event);
    if (!decision.what.empty()) view.what += " (" + decision.what + ")";
    if (decision.undone_by) {
      view.undone_by = static_cast<int>(*decision.undone_by) + 1;
      view.undoing =
          undoing_in_words(state, state.decisions[*decision.undone_by].event, view.undone_by);
    }
    views.push_back(std::move(view));
  }
  return views;
}

}  // namespace mirocup::league
