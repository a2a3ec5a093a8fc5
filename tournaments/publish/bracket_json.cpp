// SPDX-License-Identifier: MIT
#include "tournaments/publish/bracket_json.hpp"

#include <nlohmann/json.hpp>

#include <map>
#include <utility>

namespace mirocup::league {

namespace {

// The status of a match in brackets-model, which is a number there.
enum Status { locked = 0, waiting = 1, ready = 2, running = 3, completed = 4 };

// Fills the tables. Every row has an id, and the ids of its parents.
class BracketTables {
 public:
  explicit BracketTables(const LeagueState& state) : state_(state) {}

  Json make() {
    for (std::size_t i = 0; i < state_.file.teams.size(); ++i) {
      participants_.push_back(
          {{"id", i}, {"tournament_id", 0}, {"name", state_.file.teams[i].name}});
    }
    for (const FixtureState& f : state_.fixtures) add(f);
    return {{"participant", participants_},
            {"stage", stages_},
            {"group", groups_},
            {"round", rounds_},
            {"match", matches_},
            {"match_game", games_}};
  }

 private:
  std::size_t stage_of(const Fixture& f) {
    const bool is_knockout = f.part == Part::knockout;
    const auto [found, is_new] = stage_ids_.try_emplace(is_knockout, stages_.size());
    if (is_new) {
      const bool is_only = !state_.file.format.has_knockout() || stages_.empty();
      const std::string name = state_.file.title + (is_only       ? ""
                                                    : is_knockout ? ", knockout"
                                                                  : ", groups");
      stages_.push_back({{"id", stages_.size()},
                         {"tournament_id", 0},
                         {"name", name},
                         {"type", is_knockout ? "single_elimination" : "round_robin"},
                         {"number", stages_.size() + 1},
                         {"settings", Json::object()}});
    }
    return found->second;
  }

  // The id of a group, which is a bracket in the knockout; the tie for the third place is a second
  // bracket.
  std::size_t group_of(const Fixture& f, std::size_t stage) {
    int number = f.part == Part::group ? f.group : 1;
    if (f.is_for_third_place()) number = 2;
    const auto [found, is_new] = group_ids_.try_emplace({stage, number}, groups_.size());
    if (is_new)
      groups_.push_back({{"id", groups_.size()}, {"stage_id", stage}, {"number", number}});
    return found->second;
  }

  std::size_t round_of(const Fixture& f, std::size_t stage, std::size_t group) {
    const int number = f.is_for_third_place() ? 1 : f.round;
    const auto [found, is_new] = round_ids_.try_emplace({group, number}, rounds_.size());
    if (is_new) {
      rounds_.push_back(
          {{"id", rounds_.size()}, {"stage_id", stage}, {"group_id", group}, {"number", number}});
    }
    return found->second;
  }

  // Returns one side of a match or a game: null for a bye, a null id for a team not known yet.
  static Json opponent(int team) {
    if (team == no_team) return Json();
    return {{"id", team == unknown_team ? Json() : Json(team)}};
  }

  static Status game_status(const FixtureState& f, const PlayedLeg* played) {
    if (played != nullptr) return completed;
    return f.fixture.has_both() ? ready : locked;
  }

  static Status match_status(const FixtureState& f) {
    if (f.is_decided()) return completed;
    if (!f.fixture.has_both()) return locked;
    return f.decided() > 0 ? running : ready;
  }

  // Returns the number of legs that the team has won.
  static int wins(const FixtureState& f, int team) {
    int count = 0;
    for (int leg = 0; leg < f.needed(); ++leg) {
      if (f.legs[leg].played && f.legs[leg].played->result.difference(team) > 0) ++count;
    }
    return count;
  }

  // Returns one side of the whole fixture. Its score is the sum of goals in a knockout, where that
  // sum decides a tie, and the number of won legs elsewhere.
  Json match_opponent(const FixtureState& f, int team) const {
    Json side = opponent(team);
    if (!f.fixture.has_both()) return side;
    if (f.fixture.part != Part::knockout) {
      side["score"] = wins(f, team);
      return side;
    }
    side["score"] = f.goals(team);
    const TieOutcome o = outcome(state_, f);
    if (o.winner >= 0) side["result"] = o.winner == team ? "win" : "loss";
    return side;
  }

  Json game(const FixtureState& f, int leg, std::size_t stage, std::size_t match) const {
    const PlayedLeg* played = f.legs[leg].played.get();
    Json home = opponent(f.fixture.home);
    Json away = opponent(f.fixture.away);
    if (played != nullptr) {
      home["score"] = played->result.home_goals;
      away["score"] = played->result.away_goals;
    }
    return {{"id", games_.size()},
            {"stage_id", stage},
            {"parent_id", match},
            {"number", leg + 1},
            {"status", game_status(f, played)},
            {"opponent1", home},
            {"opponent2", away}};
  }

  void add(const FixtureState& f) {
    const std::size_t stage = stage_of(f.fixture);
    const std::size_t group = group_of(f.fixture, stage);
    const std::size_t round = round_of(f.fixture, stage, group);
    const std::size_t match = matches_.size();
    for (int leg = 0; leg < f.needed(); ++leg) games_.push_back(game(f, leg, stage, match));
    matches_.push_back({{"id", match},
                        {"stage_id", stage},
                        {"group_id", group},
                        {"round_id", round},
                        {"number", f.fixture.is_for_third_place() ? 1 : f.fixture.number},
                        {"child_count", f.fixture.legs},
                        {"status", match_status(f)},
                        {"opponent1", match_opponent(f, f.fixture.home)},
                        {"opponent2", match_opponent(f, f.fixture.away)}});
  }

  const LeagueState& state_;
  Json participants_ = Json::array();
  Json stages_ = Json::array();
  Json groups_ = Json::array();
  Json rounds_ = Json::array();
  Json matches_ = Json::array();
  Json games_ = Json::array();
  std::map<bool, std::size_t> stage_ids_;
  std::map<std::pair<std::size_t, int>, std::size_t> group_ids_;
  std::map<std::pair<std::size_t, int>, std::size_t> round_ids_;
};

}  // namespace

Json bracket_json(const LeagueState& state) {
  return BracketTables(state).make();
}

}  // namespace mirocup::league
