// SPDX-License-Identifier: MIT
#include "tournaments/table/table.hpp"

#include "core/base/random.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <map>
#include <utility>

namespace mirocup::league {

namespace {

void add_result(TableRow& row, int own, int other, int penalties, bool loses,
                const Points& points) {
  ++row.played;
  row.goals_for += own;
  row.goals_against += other;
  row.penalties += penalties;
  if (loses || own < other) {
    ++row.lost;
    row.points += points.loss;
  } else if (own == other) {
    ++row.drawn;
    row.points += points.draw;
  } else {
    ++row.won;
    row.points += points.win;
  }
}

void add_bye(TableRow& row, const Points& points) {
  ++row.played;
  ++row.won;
  row.points += points.win;
}

// Orders teams. Rows and lists are indexed by team.
class Ranking {
 public:
  Ranking(const std::vector<int>& teams, const std::vector<LegResult>& results,
          const TableRules& rules, const std::vector<int>& stage_reached)
      : teams_(teams), results_(results), rules_(rules), stage_reached_(stage_reached) {
    int last = -1;
    for (const int team : teams) last = std::max(last, team);
    total_.resize(last + 1);
    legs_of_.resize(last + 1);
    is_in_.assign(last + 1, false);
    for (const int team : teams) {
      total_[team].team = team;
      is_in_[team] = true;
    }
    for (std::size_t i = 0; i < results.size(); ++i) add(i);
  }

  std::vector<TableRow> rows() {
    if (stage_reached_.empty()) {
      split(
          teams_, "absent", [this](int team) { return is_absent(team) ? 0.0 : 1.0; },
          [this](const std::vector<int>& level, bool) { by_strength(level); });
    } else {
      split(
          teams_, "knockout", [this](int team) { return double(stage_reached_[team]); },
          [this](const std::vector<int>& level, bool) { by_points(level); });
    }
    std::vector<TableRow> ordered;
    for (const int team : order_) {
      ordered.push_back(total_[team]);
      ordered.back().rank = is_absent(team) ? 0 : static_cast<int>(ordered.size());
    }
    if (!ordered.empty()) ordered.back().separated_by.clear();
    return ordered;
  }

 private:
  bool has(int team) const {
    return team >= 0 && team < static_cast<int>(is_in_.size()) && is_in_[team];
  }

  bool left(int team) const {
    return team < static_cast<int>(rules_.has_left.size()) && rules_.has_left[team];
  }

  void add(std::size_t index) {
    const LegResult& r = results_[index];
    if (r.away < 0) {
      if (!has(r.home) || !r.home_entry_still_plays) return;
      add_bye(total_[r.home], rules_.points);
      legs_of_[r.home].push_back(index);
      return;
    }
    if (!has(r.home) || !has(r.away)) return;
    if (r.home_goals != r.away_goals) {
      ++won_legs_;
      winners_goals_ += std::max(r.home_goals, r.away_goals);
      winners_difference_ += std::abs(r.difference(r.home));
    }
    if (r.home_entry_still_plays) {
      add_result(total_[r.home], r.home_goals, r.away_goals, r.home_penalties, r.both_lose,
                 rules_.points);
      legs_of_[r.home].push_back(index);
    }
    if (r.away_entry_still_plays) {
      add_result(total_[r.away], r.away_goals, r.home_goals, r.away_penalties, r.both_lose,
                 rules_.points);
      legs_of_[r.away].push_back(index);
    }
  }

  bool is_absent(int team) const { return rules_.by_points_per_leg && total_[team].played == 0; }

  void by_strength(const std::vector<int>& all) {
    split(
        all, "withdrawn", [this](int team) { return left(team) ? 0.0 : 1.0; },
        [this](const std::vector<int>& present, bool) {
          split(
              present, "strength",
              [this](int team) { return rules_.strengths.empty() ? 0.0 : rules_.strengths[team]; },
              [this](const std::vector<int>& level, bool) { by_points(level); });
        });
  }

  void by_points(const std::vector<int>& level) {
    const bool mean = rules_.by_points_per_leg || rules_.has_uneven_groups;
    split(
        level, mean ? "points per leg" : "points",
        [this, mean](int team) {
          const TableRow& row = total_[team];
          return mean && row.played > 0 ? double(row.points) / row.played : double(row.points);
        },
        [this](const std::vector<int>& rest, bool) {
          // Lots are for teams that have played.
          break_tie(rest, is_absent(rest[0]) ? rules_.tie_breaks.size() : 0, false);
        });
  }

  // Orders level teams by a value (higher is better), and calls next() for each group of teams that
  // are still level, with true if the group is smaller than before. The last team of each group
  // notes the rule that separates it from the group below.
  template <class Value, class Next>
  void split(std::vector<int> level, std::string_view what, Value value, Next next) {
    std::vector<double> values(total_.size());
    for (const int team : level) values[team] = value(team);
    std::ranges::stable_sort(level, [&](int a, int b) { return values[a] > values[b]; });
    for (std::size_t i = 0; i < level.size();) {
      std::size_t end = i + 1;
      while (end < level.size() && values[level[end]] == values[level[i]]) ++end;
      next({level.begin() + static_cast<std::ptrdiff_t>(i),
            level.begin() + static_cast<std::ptrdiff_t>(end)},
           end - i < level.size());
      if (end < level.size()) total_[order_.back()].separated_by = what;
      i = end;
    }
  }

  // `is_smaller`: the group is a part of the group before it. Head-to-head counts are then taken
  // between the remaining teams only, so the rules start again at the first of these counts.
  void break_tie(const std::vector<int>& level, std::size_t next, bool is_smaller) {
    if (is_smaller && next > 0) next = std::min(next, first_head_to_head());
    if (level.size() == 1 || next >= rules_.tie_breaks.size()) {
      order_.insert(order_.end(), level.begin(), level.end());
      return;
    }
    const TieBreak rule = rules_.tie_breaks[next];
    if (is_head_to_head(rule) && !have_all_met(level)) return break_tie(level, next + 1, false);
    const std::map<int, TableRow> mini =
        is_head_to_head(rule) ? among(level) : std::map<int, TableRow>();
    split(
        level, to_string(rule), [&](int team) { return value(rule, team, mini); },
        [this, next](const std::vector<int>& rest, bool fewer) {
          break_tie(rest, next + 1, fewer);
        });
  }

  // Returns the rows from the legs between these teams alone.
  std::map<int, TableRow> among(const std::vector<int>& level) const {
    std::map<int, TableRow> rows;
    for (const int team : level) rows[team].team = team;
    for (auto& [team, row] : rows) {
      for (const std::size_t i : legs_of_[team]) {
        const LegResult& r = results_[i];
        const bool home = r.home == team;
        if (r.away < 0 || rows.count(home ? r.away : r.home) == 0) continue;
        add_result(row, home ? r.home_goals : r.away_goals, home ? r.away_goals : r.home_goals, 0,
                   r.both_lose, rules_.points);
      }
    }
    return rows;
  }

  // True if each pair of the level teams has met as often, and has met at all.
  bool have_all_met(const std::vector<int>& level) const {
    std::map<std::pair<int, int>, int> legs;
    for (const int team : level) {
      for (const std::size_t i : legs_of_[team])
        ++legs[{team, results_[i].home == team ? results_[i].away : results_[i].home}];
    }
    const int often = legs[{level[0], level[1]}];
    for (const int team : level) {
      for (const int other : level) {
        if (team != other && legs[{team, other}] != often) return false;
      }
    }
    return often > 0;
  }

  // Returns a sum over legs as it is compared between teams.
  double over(double sum, std::size_t legs) const {
    return legs > 0 ? sum / static_cast<double>(legs) : sum;
  }

  // The same for goals. A bye counts as a leg that was won like the others on average, because
  // other teams of the same points have won a leg more with goals.
  double over_goals(std::int64_t sum, std::int64_t of_winners, int team) const {
    const std::size_t with_goals = legs_with_goals(team);
    if (won_legs_ == 0) return over(double(sum), with_goals);
    const std::size_t legs = legs_of_[team].size();
    const double of_a_bye = double(of_winners) / double(won_legs_);
    return over(double(sum) + of_a_bye * double(legs - with_goals), legs);
  }

  // Returns the number of legs in which the team could score.
  std::size_t legs_with_goals(int team) const {
    return static_cast<std::size_t>(std::ranges::count_if(
        legs_of_[team], [this](std::size_t i) { return results_[i].away >= 0; }));
  }

  double value(TieBreak rule, int team, const std::map<int, TableRow>& mini) const {
    switch (rule) {
      case TieBreak::goal_difference:
        return over_goals(total_[team].difference(), winners_difference_, team);
      case TieBreak::goals:
        return over_goals(total_[team].goals_for, winners_goals_, team);
      case TieBreak::head_to_head_points:
        return static_cast<double>(mini.at(team).points);
      case TieBreak::head_to_head_goal_difference:
        return static_cast<double>(mini.at(team).difference());
      case TieBreak::penalties:
        return -over(double(total_[team].penalties), legs_with_goals(team));
      case TieBreak::lots:
        return Random(mix_seed(rules_.seed ^ static_cast<std::uint64_t>(team))).uniform();
      case TieBreak::wins:
        return over(double(total_[team].won), static_cast<std::size_t>(total_[team].played));
      case TieBreak::opponents_points: {
        std::int64_t sum = 0;
        double sum_by_leg = 0.0;
        for (const std::size_t i : legs_of_[team]) {
          const int other = results_[i].home == team ? results_[i].away : results_[i].home;
          const TableRow& row = total_[other < 0 || left(other) ? team : other];
          sum += row.points;
          sum_by_leg += row.played > 0 ? double(row.points) / row.played : 0.0;
        }
        return rules_.by_points_per_leg
                   ? sum_by_leg /
                         static_cast<double>(std::max<std::size_t>(legs_of_[team].size(), 1))
                   : over(double(sum), legs_of_[team].size());
      }
    }
    return 0.0;
  }

  static bool is_head_to_head(TieBreak rule) {
    return rule == TieBreak::head_to_head_points || rule == TieBreak::head_to_head_goal_difference;
  }

  std::size_t first_head_to_head() const {
    const auto& list = rules_.tie_breaks;
    return static_cast<std::size_t>(std::ranges::find_if(list, is_head_to_head) - list.begin());
  }

  const std::vector<int>& teams_;
  const std::vector<LegResult>& results_;
  const TableRules& rules_;
  const std::vector<int>& stage_reached_;
  std::vector<TableRow> total_;
  std::vector<bool> is_in_;
  std::vector<std::vector<std::size_t>> legs_of_;
  std::int64_t won_legs_ = 0;  // of all teams, without byes
  std::int64_t winners_goals_ = 0;
  std::int64_t winners_difference_ = 0;
  std::vector<int> order_;
};

}  // namespace

std::vector<TableRow> make_table(const std::vector<int>& teams,
                                 const std::vector<LegResult>& results, const TableRules& rules,
                                 const std::vector<int>& stage_reached) {
  return Ranking(teams, results, rules, stage_reached).rows();
}

std::vector<int> all_teams(int teams) {
  std::vector<int> all;
  for (int team = 0; team < teams; ++team) all.push_back(team);
  return all;
}

}  // namespace mirocup::league
