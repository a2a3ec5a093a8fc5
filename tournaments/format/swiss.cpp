// SPDX-License-Identifier: MIT
#include "tournaments/format/swiss.hpp"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace mirocup::league {

namespace {

// A small field can run out of pairings long before all pairs have met, so up to this number of
// teams a pairing must leave room for the remaining rounds. In a larger field with at most half as
// many rounds as teams, each team has at least half of the field left as opponents; then a pairing
// exists (Dirac 1952).
constexpr int max_look_ahead_teams = 8;

// A search for the pairing of one round. Teams are numbered by rank, best first.
class Pairing {
 public:
  Pairing(std::vector<std::vector<bool>> have_met, std::vector<std::int64_t> points)
      : have_met_(std::move(have_met)),
        points_(std::move(points)),
        partner_(points_.size(), no_team) {}

  // Pairs all teams such that `more` further rounds can be paired. False if that is impossible.
  bool find(int more) {
    const auto free = std::ranges::find(partner_, no_team);
    if (free == partner_.end()) return leaves(more);
    const int a = static_cast<int>(free - partner_.begin());
    for (const int b : candidates(a)) {
      partner_[a] = b;
      partner_[b] = a;
      if (find(more)) return true;
      partner_[a] = no_team;
      partner_[b] = no_team;
    }
    return false;
  }

  // The same, with the last team, the bye, for the first of `candidates` for which that is
  // possible.
  bool find_from_bye(const std::vector<int>& candidates, int more) {
    const int bye = size() - 1;
    for (const int team : candidates) {
      if (have_met_[team][bye]) continue;
      partner_[team] = bye;
      partner_[bye] = team;
      if (find(more)) return true;
      partner_[team] = partner_[bye] = no_team;
    }
    return false;
  }

  const std::vector<int>& partner() const { return partner_; }

 private:
  bool leaves(int more) const {
    if (more <= 0 || size() > max_look_ahead_teams) return true;
    Pairing after(have_met_, points_);
    for (int a = 0; a < size(); ++a) after.have_met_[a][partner_[a]] = true;
    return after.find(more - 1);
  }

  // The possible opponents of the best team that is left: those of equal points first, and among
  // them the one that stands half a group below.
  std::vector<int> candidates(int a) const {
    struct Candidate {
      int rank;
      std::int64_t points_below;
      int position;  // among teams of equal points
    };
    std::vector<Candidate> others;
    int position = 0;
    int like = 0;
    for (int b = a + 1; b < size(); ++b) {
      if (partner_[b] != no_team) continue;
      if (points_[b] != points_[b - 1]) position = 0;
      if (points_[b] == points_[a]) ++like;
      if (!have_met_[a][b]) others.push_back({b, points_[a] - points_[b], position});
      ++position;
    }
    std::ranges::stable_sort(others, {}, [like](const Candidate& one) {
      const int middle = one.points_below == 0 ? like / 2 : 0;
      return std::pair(one.points_below, std::abs(one.position - middle));
    });
    std::vector<int> ranks;
    for (const Candidate& other : others) ranks.push_back(other.rank);
    return ranks;
  }

  int size() const { return static_cast<int>(points_.size()); }

  std::vector<std::vector<bool>> have_met_;
  std::vector<std::int64_t> points_;
  std::vector<int> partner_;
};

// Puts the teams that had a bye behind the other teams with as many points, because they won some
// of these points without an opponent.
void put_byes_last(std::vector<SwissStanding>& standings, const std::vector<Fixture>& before) {
  std::set<int> byes;
  for (const Fixture& f : before) {
    if (f.away == no_team) byes.insert(f.home);
  }
  std::ranges::stable_sort(standings, {}, [&byes](const SwissStanding& s) {
    return std::pair(-s.points, byes.contains(s.team));
  });
}

// The ranks of all teams in the order in which they are asked to have the bye: the fewest points
// first, and of teams with equal points the best ranked first. For the last of equals has had the
// weakest opponents; a bye, which brings no opponent, would put it below its equals for good.
std::vector<int> bye_candidates(const std::vector<SwissStanding>& standings, bool last_first) {
  std::vector<int> ranks(standings.size());
  std::iota(ranks.begin(), ranks.end(), 0);
  if (last_first) {
    std::ranges::reverse(ranks);
  } else {
    std::ranges::stable_sort(ranks, {}, [&standings](int rank) { return standings[rank].points; });
  }
  return ranks;
}

}  // namespace

int usual_swiss_rounds(int teams) {
  int rounds = 0;
  while ((1 << rounds) < teams) ++rounds;
  return std::min(rounds, max_swiss_rounds(teams));
}

int max_swiss_rounds(int teams) {
  const int places = teams + teams % 2;
  return places <= max_look_ahead_teams ? places - 1 : places / 2;
}

std::vector<Fixture> swiss_round(std::vector<SwissStanding> standings,
                                 const std::vector<Fixture>& before, int round, int rounds) {
  const bool has_bye = standings.size() % 2 == 1;
  if (has_bye) put_byes_last(standings, before);
  // With an odd number the bye takes part as the last team, so no team has it twice.
  std::map<int, int> rank;
  std::vector<int> team;
  std::vector<std::int64_t> points;
  for (const SwissStanding& s : standings) {
    rank[s.team] = static_cast<int>(team.size());
    team.push_back(s.team);
    points.push_back(s.points);
  }
  if (has_bye) {
    rank[no_team] = static_cast<int>(team.size());
    team.push_back(no_team);
    points.push_back(points.back() - 1);
  }
  std::vector<std::vector<bool>> have_met(team.size(), std::vector<bool>(team.size(), false));
  for (const Fixture& f : before) {
    const auto home = rank.find(f.home);
    const auto away = rank.find(f.away);
    if (home == rank.end() || away == rank.end()) continue;
    have_met[home->second][away->second] = true;
    have_met[away->second][home->second] = true;
  }
  Pairing pairing(std::move(have_met), std::move(points));
  const bool is_found =
      has_bye ? pairing.find_from_bye(bye_candidates(standings, round == 1), rounds - round)
              : pairing.find(rounds - round);
  if (!is_found) return {};

  std::vector<Fixture> fixtures;
  for (int a = 0; a < static_cast<int>(team.size()); ++a) {
    const int b = pairing.partner()[a];
    if (b < a) continue;
    Fixture f;
    f.round = round;
    f.number = static_cast<int>(fixtures.size()) + 1;
    // The better team is home in odd rounds.
    const bool swapped = round % 2 == 0 && team[b] != no_team;
    f.home = swapped ? team[b] : team[a];
    f.away = swapped ? team[a] : team[b];
    if (f.away == no_team) f.legs = 0;
    fixtures.push_back(f);
  }
  return fixtures;
}

}  // namespace mirocup::league
