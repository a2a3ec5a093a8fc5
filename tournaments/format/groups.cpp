// SPDX-License-Identifier: MIT
#include "tournaments/format/groups.hpp"

#include <algorithm>
#include <cstddef>
#include <set>
#include <utility>

namespace mirocup::league {

namespace {

// Seeds the places of groups in a bracket: all winners first, so that they have the byes, then all
// seconds. Groups of one place may change their seeds, so that group mates meet late.
class Seeding {
 public:
  Seeding(const std::vector<std::vector<int>>& groups, int qualifiers) : groups_(groups) {
    int count = 0;
    for (int place = 0; place < qualifiers; ++place) {
      for (const auto& group : groups) count += place < static_cast<int>(group.size()) ? 1 : 0;
    }
    seeds_.resize(count);
    for (int size = 1; size < count; size *= 2) ++rounds_;
    const std::vector<int> order = bracket_order(1 << rounds_);
    slot_.resize(order.size());
    for (std::size_t slot = 0; slot < order.size(); ++slot)
      slot_[order[slot]] = static_cast<int>(slot);
    for (earliest_ = rounds_; !have_places(qualifiers); --earliest_) {
    }
  }

  const std::vector<TeamSource>& seeds() const { return seeds_; }

 private:
  // Tries to seed all places so that no group mates meet before round `earliest_`.
  bool have_places(int qualifiers) {
    parts_.assign(groups_.size(), {});
    first_ = 0;
    for (int place = 0; place < qualifiers; ++place) {
      std::vector<int> groups;
      for (std::size_t group = 0; group < groups_.size(); ++group) {
        if (place < static_cast<int>(groups_[group].size()))
          groups.push_back(static_cast<int>(group));
      }
      group_of_.assign(groups.size(), no_team);
      for (std::size_t i = 0; i < groups.size(); ++i) {
        std::set<std::size_t> asked;
        if (!give_seed(groups[i], i, asked)) return false;
      }
      for (std::size_t i = 0; i < groups.size(); ++i) {
        parts_[group_of_[i]].insert(part(i));
        seeds_[first_ + i] = {
            .kind = TeamSource::Kind::place, .index = group_of_[i], .place = place};
      }
      first_ += groups.size();
    }
    return true;
  }

  // The part of the bracket that a seed wins in the round before `earliest_`.
  int part(std::size_t seed) const { return slot_[first_ + seed] >> (earliest_ - 1); }

  // Gives a group a seed of the present place, its natural one if it can; another group may have to
  // take another seed for it.
  bool give_seed(int group, std::size_t natural, std::set<std::size_t>& asked) {
    for (std::size_t i = 0; i < group_of_.size(); ++i) {
      const std::size_t seed = i == 0 ? natural : i <= natural ? i - 1 : i;
      if (parts_[group].contains(part(seed)) || !asked.insert(seed).second) continue;
      const int other = group_of_[seed];
      if (other != no_team && !give_seed(other, seed, asked)) continue;
      group_of_[seed] = group;
      return true;
    }
    return false;
  }

  const std::vector<std::vector<int>>& groups_;
  std::vector<TeamSource> seeds_;
  std::vector<int> slot_;  // by seed: its slot in the bracket
  int rounds_ = 0;
  int earliest_ = 0;                  // the round in which group mates may meet
  std::vector<std::set<int>> parts_;  // by group: the parts in which it has a team
  std::size_t first_ = 0;             // the first seed of the present place
  std::vector<int> group_of_;         // by seed of the present place
};

}  // namespace

std::vector<std::vector<int>> deal_groups(int teams, int groups) {
  std::vector<std::vector<int>> dealt(groups);
  for (int team = 0; team < teams; ++team) {
    const int lap = team / groups;
    const int step = team % groups;
    dealt[lap % 2 == 0 ? step : groups - 1 - step].push_back(team);
  }
  return dealt;
}

std::vector<Fixture> groups_then_knockout(int teams, const GroupsOptions& options) {
  const auto groups = deal_groups(teams, options.groups);
  std::vector<Fixture> fixtures;
  for (int group = 0; group < options.groups; ++group) {
    for (Fixture fixture : round_robin(static_cast<int>(groups[group].size()), options.legs)) {
      fixture.part = Part::group;
      fixture.group = group + 1;
      fixture.home = groups[group][fixture.home];
      fixture.away = groups[group][fixture.away];
      fixtures.push_back(fixture);
    }
  }
  std::ranges::stable_sort(fixtures, {},
                           [](const Fixture& f) { return std::pair(f.round, f.group); });
  const auto ties = knockout(Seeding(groups, options.qualifiers).seeds(), options.knockout,
                             static_cast<int>(fixtures.size()));
  fixtures.insert(fixtures.end(), ties.begin(), ties.end());
  return fixtures;
}

}  // namespace mirocup::league
