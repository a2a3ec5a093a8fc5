// SPDX-License-Identifier: MIT
#include "tournaments/publish/bracket.hpp"

#include <nlohmann/json.hpp>

#include <map>
#include <utility>

namespace mirocup::league {

namespace {

// Of a match in brackets-model.
enum Status { locked = 0, waiting = 1, ready = 2, running = 3, completed = 4 };

// Fills the flat tables: every row has an id and its parents' ids.
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
                         {"number", stages_.size() + 1}});
    }
    return found->second;
  }

  // A bracket, and beside it the one for the third place.
  std::size_t group_of(const Fixture& f, std::size_t stage) {
    int number = f.part == Part::group ? f.group : 1;
    if (f.home_source.kind == TeamSource::Kind::loser) number = 2;
    const auto [found, is_new] = group_ids_.try_emplace({stage, number}, groups_.size());
    if (is_new)
      groups_.push_back({{"id", groups_.size()}, {"stage_id", stage}, {"number", number}});
    return found->second;
  }

  std::size_t round_of(const Fixture& f, std::size_t stage, std::size_t group) {
    const int number = f.home_source.kind == TeamSource::Kind::loser ? 1 : f.round;
    const auto [found, is_new] = round_ids_.try_emplace({group, number}, rounds_.size());
    if (is_new) {
      rounds_.push_back(
          {{"id", rounds_.size()}, {"stage_id", stage}, {"group_id", group}, {"number", number}});
    }
    return found->second;
  }

  // Null is a bye there, a null id somebody who is not known yet.
  static Json opponent(int team) {
    if (team == no_team) return Json();
    return {{"id", team == unknown_team ? Json() : Json(team)}};
  }

  void add(const FixtureState& f) {
    const std::size_t stage = stage_of(f.fixture);
    const std::size_t group = group_of(f.fixture, stage);
    const std::size_t round = round_of(f.fixture, stage, group);
    const std::size_t match = matches_.size();
    Json home = opponent(f.fixture.home);
    Json away = opponent(f.fixture.away);
    int home_wins = 0;
    int away_wins = 0;
    for (int leg = 0; leg < f.needed(); ++leg) {
      const auto& played = f.legs[leg].played;
      Json game{{"id", games_.size()},
                {"stage_id", stage},
                {"parent_id", match},
                {"number", leg + 1},
                {"status", played                 ? completed
                           : f.fixture.has_both() ? ready
                                                  : locked}};
      Json own = home;
      Json other = away;
      if (played) {
        own["score"] = played->result.home_goals;
        other["score"] = played->result.away_goals;
        home_wins += played->result.home_goals > played->result.away_goals ? 1 : 0;
        away_wins += played->result.away_goals > played->result.home_goals ? 1 : 0;
      }
      game["opponent1"] = own;
      game["opponent2"] = other;
      games_.push_back(game);
    }
    const bool is_tie = f.fixture.part == Part::knockout;
    if (f.fixture.has_both()) {
      home["score"] = is_tie ? f.goals(f.fixture.home) : home_wins;
      away["score"] = is_tie ? f.goals(f.fixture.away) : away_wins;
      const TieOutcome o = is_tie ? outcome(state_, f) : TieOutcome{};
      if (o.winner >= 0) {
        home["result"] = o.winner == f.fixture.home ? "win" : "loss";
        away["result"] = o.winner == f.fixture.away ? "win" : "loss";
      }
    }
    const Status status = f.is_decided()          ? completed
                          : !f.fixture.has_both() ? locked
                          : f.decided() > 0       ? running
                                                  : ready;
    matches_.push_back(
        {{"id", match},
         {"stage_id", stage},
         {"group_id", group},
         {"round_id", round},
         {"number", f.fixture.home_source.kind == TeamSource::Kind::loser ? 1 : f.fixture.number},
         {"child_count", f.fixture.legs},
         {"status", status},
         {"opponent1", home},
         {"opponent2", away}});
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
