// SPDX-License-Identifier: MIT
//
// The rounds of a league on pages. Round n of all groups is a single round. Rounds of a knockout
// come last.
#pragma once

#include "tournaments/publish/leg_view.hpp"

#include <string>
#include <vector>

namespace mirocup::league {

// A fixture whose teams are known, with its legs.
struct FixtureView {
  const FixtureState* state = nullptr;
  std::vector<const LegView*> legs;
};

struct RoundView {
  std::string key;    // "r3", "k1", as in release --through
  std::string title;  // "Round 3", "Semi-final"
  std::vector<FixtureView> fixtures;
  int legs = 0;
  int decided = 0;  // number of decided legs
  int goals = 0;

  std::string page() const { return "rounds/" + key + ".html"; }
};

// Returns the rounds in the order in which they are played. The rounds refer to the overview, which
// must outlive them.
std::vector<RoundView> rounds_of(const Overview& overview);

// Returns the link to a fixture on the page of its round, relative to the folder site/:
// "rounds/r3.html#r3-f2".
std::string fixture_link(const Fixture& fixture);

// Returns the knockout as an SVG element for the front page, in which each tie links to its place
// on the page of its round, and each score of a leg to its replay; "" if the league has no
// knockout. The score of a shoot-out is in brackets.
std::string bracket_svg(const Overview& overview);

}  // namespace mirocup::league
