// SPDX-License-Identifier: MIT
#include "tournaments/table/table.hpp"

#include "core/base/random.hpp"

#include <algorithm>
#include <map>
#include <optional>

namespace mirocup::league {

namespace {

// Adds up the results between the chosen teams; rows are in the order of `teams`.
std::vector<Row> add_up(const std::vector<int>& teams, const std::vector<LegResult>& results,
                        const Points& points) {
  std::map<int, Row> rows;
  for (const int team : teams) rows[team].team = team;
  const auto book = [&points](Row& row, int own, int other, int penalties, bool loses) {
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
  };
  for (const LegResult& r : results) {
    const auto home = rows.find(r.home);
    const auto away = rows.find(r.away);
    if (home == rows.end() || away == rows.end()) continue;
    book(home->second, r.home_goals, r.away_goals, r.home_penalties, r.both_lose);
    book(away->second, r.away_goals, r.home_goals, r.away_penalties, r.both_lose);
  }
  std::vector<Row> ordered;
  for (const int team : teams) ordered.push_back(rows[team]);
  return ordered;
}

class Ranking {
 public:
  Ranking(int teams, const std::vector<LegResult>& results, const Points& points,
          const std::vector<TieBreak>& tie_breaks, std::uint64_t seed)
      : results_(results), points_(points), tie_breaks_(tie_breaks), seed_(seed) {
    std::vector<int> all;
    for (int i = 0; i < teams; ++i) all.push_back(i);
    total_ = add_up(all, results, points);
  }

  std::vector<Row> rows() {
    std::vector<int> all;
    for (const Row& row : total_) all.push_back(row.team);
    split(
        all, "points", [this](int team) { return total_[team].points; }, 0);
    std::vector<Row> ordered;
    for (const int team : order_) {
      Row row = total_[team];
      row.separated_by = separated_by_[team];
      ordered.push_back(row);
    }
    if (!ordered.empty()) ordered.back().separated_by.clear();
    return ordered;
  }

 private:
  // Orders teams that are level so far by a value (higher is better); those still level go to the
  // tie-break `next`. The last of each group notes what separates it from the group below.
  template <class Value>
  void split(std::vector<int> level, std::string_view what, Value value, std::size_t next) {
    std::stable_sort(level.begin(), level.end(), [&](int a, int b) { return value(a) > value(b); });
    for (std::size_t i = 0; i < level.size();) {
      std::size_t end = i + 1;
      while (end < level.size() && value(level[end]) == value(level[i])) ++end;
      break_tie({level.begin() + static_cast<std::ptrdiff_t>(i),
                 level.begin() + static_cast<std::ptrdiff_t>(end)},
                next, end - i < level.size());
      if (end < level.size()) separated_by_[order_.back()] = what;
      i = end;
    }
  }

  // `is_smaller`: the group is smaller than the one before it. Head-to-head counts are then taken
  // anew among those who are left, so the list starts again at the first of them.
  void break_tie(const std::vector<int>& level, std::size_t next, bool is_smaller) {
    if (level.size() == 1 || next > tie_breaks_.size()) {
      order_.insert(order_.end(), level.begin(), level.end());
      return;
    }
    if (is_smaller && next > 0) next = std::min(next, first_head_to_head());
    if (next == tie_breaks_.size()) {
      order_.insert(order_.end(), level.begin(), level.end());
      return;
    }
    const TieBreak rule = tie_breaks_[next];
    const std::vector<Row> among = add_up(level, results_, points_);
    const auto mini = [&among](int team) -> const Row& {
      return *std::find_if(among.begin(), among.end(),
                           [team](const Row& r) { return r.team == team; });
    };
    const auto value = [&](int team) -> double {
      switch (rule) {
        case TieBreak::goal_difference:
          return total_[team].difference();
        case TieBreak::goals:
          return total_[team].goals_for;
        case TieBreak::head_to_head_points:
          return mini(team).points;
        case TieBreak::head_to_head_goal_difference:
          return mini(team).difference();
        case TieBreak::penalties:
          return -total_[team].penalties;
        case TieBreak::lots:
          return Random(mix_seed(seed_ ^ static_cast<std::uint64_t>(team))).uniform();
      }
      return 0.0;
    };
    split(level, to_string(rule), value, next + 1);
  }

  std::size_t first_head_to_head() const {
    const auto found = std::find_if(tie_breaks_.begin(), tie_breaks_.end(), [](TieBreak t) {
      return t == TieBreak::head_to_head_points || t == TieBreak::head_to_head_goal_difference;
    });
    return static_cast<std::size_t>(found - tie_breaks_.begin());
  }

  const std::vector<LegResult>& results_;
  const Points& points_;
  const std::vector<TieBreak>& tie_breaks_;
  std::uint64_t seed_;
  std::vector<Row> total_;
  std::vector<int> order_;
  std::map<int, std::string> separated_by_;
};

}  // namespace

std::vector<Row> make_table(int teams, const std::vector<LegResult>& results, const Points& points,
                            const std::vector<TieBreak>& tie_breaks, std::uint64_t seed) {
  return Ranking(teams, results, points, tie_breaks, seed).rows();
}

}  // namespace mirocup::league
