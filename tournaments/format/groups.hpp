// SPDX-License-Identifier: MIT
//
// Groups, then a knockout among the first of each.
#pragma once

#include "tournaments/format/knockout.hpp"

#include <vector>

namespace mirocup::league {

struct GroupsOptions {
  int groups = 2;
  int qualifiers = 2;           // of each group go on; fewer if a group is smaller
  int legs = legs_per_fixture;  // of each pair in a group
  KnockoutOptions knockout;
};

// The teams of each group, dealt out like cards in a snake so that seeds 1, 2, 3 ... are spread
// evenly. Sizes differ by one at most.
std::vector<std::vector<int>> deal_groups(int teams, int groups);

// The round robins of all groups, round by round, then the knockout. Those who come from one group
// do not meet in their first tie of the knockout if that can be had.
std::vector<Fixture> groups_then_knockout(int teams, const GroupsOptions& options);

}  // namespace mirocup::league
