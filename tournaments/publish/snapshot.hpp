// SPDX-License-Identifier: MIT
//
// The state of a league after a round, for a host who shows the results round by round, and
// the part of a league that the public sees.
#pragma once

#include "tournaments/journal/journal.hpp"
#include "tournaments/league/league_state.hpp"
#include "tournaments/publish/leg_facts.hpp"

#include <set>
#include <string>
#include <utility>

namespace mirocup::league {

// Returns the state of a league as if nothing had been played after a round. "r3" is the third
// round of a table or of all groups; "k1" is the first round of a knockout, which follows all
// groups. `whole` is the present state. Withdrawals and pauses show in every round. If `legs` is
// set, only these legs of the round count as played. Errors:
// Errc::input if the league lacks the round, or if an event of a shown round depends on an event of
// a later round.
Result<LeagueState> state_through(const LeagueState& whole, const Journal& journal,
                                  const std::string& round,
                                  const std::set<LegName>* legs = nullptr);

// The people who look at a league. A team counts as a team if it looks at its own legs and its own
// digest, and as a visitor if it looks at the league.
enum class Viewer { visitor, team, staff };

// True if a viewer may see the legs of every round; otherwise the viewer sees released_state().
bool sees_all(Viewer viewer, const LeagueState& whole);

// True if a viewer may see the news of nights. If a night is not a round, the news would show what
// is held back of the night.
bool sees_nights(Viewer viewer, const LeagueState& whole);

// Returns the state that visitors see: the rounds that the league's staff has released. The errors
// are the ones that state_through() returns.
Result<LeagueState> released_state(const LeagueState& whole, const Journal& journal);

// The part of a league that a viewer may see. Only seen_by() makes one, so code that takes a
// SeenState cannot read the whole league by mistake. It refers to the states that seen_by() got.
class SeenState {
 public:
  const LeagueState& operator*() const { return *state_; }
  const LeagueState* operator->() const { return state_; }

 private:
  friend SeenState seen_by(Viewer viewer, const LeagueState& whole, const LeagueState& released);
  explicit SeenState(const LeagueState& state) : state_(&state) {}

  const LeagueState* state_;
};

SeenState seen_by(Viewer viewer, const LeagueState& whole, const LeagueState& released);

}  // namespace mirocup::league
