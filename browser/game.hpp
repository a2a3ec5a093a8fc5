// SPDX-License-Identifier: MIT
//
// A leg as a page plays it, with its teams and the marks of a drill. A leg can continue a record.
#pragma once

#include "browser/teams.hpp"
#include "record/drills/judge.hpp"
#include "record/match_record.hpp"

#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace mirocup::browser {

using record::Json;

// Reads a record and the bytes of its replay, unpacked. Errors: Errc::damaged, which names `path`.
Result<record::MatchRecord> read_record(const std::string& text, const std::string& replay,
                                        const std::string& path);

// Verifies the record as `mirocup verify` does. `is_whole`: the digests of its files are right.
// Returns {reproduced, tick, what, ticks, state_hash, found}.
Result<Json> verify(const std::string& text, const std::string& replay, bool is_whole,
                    const std::string& path);

class Game {
 public:
  // Makes a leg from {league, rules, stage, seed, conditions, pitch, situation, drill, teams}, each
  // with the form and the default that it has in a record; `drill` is a drill's text, which gives
  // everything but the seed and the tested team. `teams`: {"blue", "yellow"}, names of house teams,
  // or "" for robots that stand. Errors: Errc::input.
  static Result<std::unique_ptr<Game>> make(const Json& options);

  // Plays the record's commands up to `tick`; from there on `teams` play, of which "recorded"
  // stands for the record's own commands. Errors: Errc::input, Errc::damaged.
  static Result<std::unique_ptr<Game>> go_on(record::MatchRecord past, std::uint32_t tick,
                                             const Json& teams);

  // Plays at most so many ticks; stops when the leg or the drill's try is over. Returns those
  // played.
  int play(int ticks);

  // Ends the leg, so that it has a record.
  void stop();

  Driver& driver(Team team) { return *drivers_[index_of(team)]; }
  const match::Leg& leg() const { return *leg_; }
  bool is_over() const { return leg_->is_over() || is_decided_; }

  // The state after the last tick as a situation (docs/situations.md), which a leg can start from.
  Json situation() const;

  // {tick, clock, state, phase, left, score, decisions, stalemate_s, drill}: what a page shows
  // beside the bodies. `decisions` are those from number `first` on.
  Json status(std::size_t first) const;

  // The record of a leg that is over; its replay has the name leg.replay.zst.
  record::MatchRecord record() const;

 private:
  Game() = default;
  Result<void> seat(const Json& teams);

  std::unique_ptr<record::MatchRecord> past_;
  std::optional<record::PlayedOnFrom> from_;
  std::optional<drills::Drill> drill_;
  std::unique_ptr<match::Leg> leg_;
  std::array<std::unique_ptr<Driver>, 2> drivers_;
  match::ByTeam<std::string> names_;
  std::optional<drills::Judge> judge_;
  replay::StateTrace trace_;
  bool is_decided_ = false;  // the drill's try
};

}  // namespace mirocup::browser
