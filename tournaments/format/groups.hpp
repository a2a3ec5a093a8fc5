// SPDX-License-Identifier: MIT
//
// Groups, followed by a knockout among the best of each group.
#pragma once

#include "tournaments/format/knockout.hpp"

#include <vector>

namespace mirocup::league {

struct GroupsOptions {
  int groups = 2;
  int qualifiers = 2;           // teams of each group that enter the knockout
  int legs = legs_per_fixture;  // number of legs of each pair in a group
  KnockoutOptions knockout;
};

// Returns the teams of each group. Seeds are dealt to n groups in snake order (group 1 to n, then n
// to 1), so that the groups are of equal strength. Sizes of groups differ by at most one.
std::vector<std::vector<int>> deal_groups(int teams, int groups);

// Returns the round robins of all groups, round by round, then the knockout. The teams of a group
// meet again as late as the number of groups and of qualifiers allows: two of them only in the
// final.
std::vector<Fixture> groups_then_knockout(int teams, const GroupsOptions& options);

}  // namespace mirocup::league
