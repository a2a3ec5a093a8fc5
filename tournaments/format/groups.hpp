// SPDX-License-Identifier: MIT
//
// The format "groups": a round robin in each group, then a knockout among the best of each group.
#pragma once

#include "tournaments/format/knockout.hpp"

#include <vector>

namespace mirocup::league {

struct GroupsOptions {
  int groups = 2;
  int qualifiers = 2;           // teams of each group that go on; fewer if a group is smaller
  int legs = legs_per_fixture;  // of each pair in a group
  KnockoutOptions knockout;
};

// Returns the teams of each group. Seeds 1, 2, 3 ... are dealt out in serpentine order (first to
// last group, then back), which spreads them evenly. Group sizes differ by at most one.
std::vector<std::vector<int>> deal_groups(int teams, int groups);

// Returns the round robins of all groups, round by round, then the knockout. Teams of the same
// group do not meet in their first tie of the knockout if that is possible.
std::vector<Fixture> groups_then_knockout(int teams, const GroupsOptions& options);

}  // namespace mirocup::league
