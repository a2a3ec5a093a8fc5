// SPDX-License-Identifier: MIT
#include "tournaments/league/decision_view.hpp"

namespace mirocup::league {

namespace {

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
    return leg_in_words(state, e) + ": void, to be played again";
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
    return "pages show " + (!e.through.empty()             ? "the rounds through " + e.through
                            : e.level == ReleaseLevel::all ? "every round"
                                                           : "no round");
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
