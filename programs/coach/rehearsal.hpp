// SPDX-License-Identifier: MIT
//
// A recorded leg that is brought to a moment together with its teams, and from there played
// otherwise: a substitute decides for one robot, and everything that is drawn is drawn anew.
//
// To the moment, the leg follows its record: the recorded commands are driven, and each team that
// is at hand observes what it observed then, so that it remembers what it remembered. From the
// moment on the teams decide. One future uses a rehearsal up: futures are played in copies of the
// process (process_copy.hpp).
#pragma once

#include "core/match/leg.hpp"
#include "record/match_record.hpp"
#include "server/seats.hpp"
#include "web/track_encoder.hpp"

#include <memory>
#include <optional>

namespace mirocup::coach {

// How long before a goal its study begins, how long a future is at least, and how long after the
// goal it goes on at least, s.
inline constexpr double studied_s = 3.0;
inline constexpr double after_goal_s = 1.0;

// Returns the number of ticks of a leg in a time, s; a part of a tick counts as a tick.
std::uint32_t ticks_of(double seconds, const match::Leg& leg);

// Who decides in the futures of a leg. All play in this process, without protection from them.
struct Cast {
  Team team = Team::blue;  // whose robots get a substitute
  // The teams of the record. A team that is missing, or whose commands in the record were others,
  // drives its recorded commands for 0.3 s at most, and then as `stand_in` decides.
  match::ByTeam<std::optional<server::TeamChoice>> own;
  server::TeamChoice stand_in;
  server::TeamChoice substitute;
  // Decides for the robot in the goal. These two then know the robot in the goal as number 0, as
  // house teams expect. Empty: the substitute decides for every robot, by its own number.
  std::optional<server::TeamChoice> keeper;
};

class Rehearsal {
 public:
  // Brings the teams to the start of the leg. The record outlives the rehearsal. Errc::input names
  // a team that cannot be loaded. Precondition: the record is reproduced (replay::verify()).
  static Result<std::unique_ptr<Rehearsal>> begin(const record::MatchRecord& record,
                                                  const Cast& cast);
  Rehearsal(const Rehearsal&) = delete;
  Rehearsal& operator=(const Rehearsal&) = delete;

  const match::Leg& leg() const { return leg_; }
  // True if the team decides in futures: it is at hand, and gave the recorded commands so far.
  bool decides(Team team) const { return own_[index_of(team)].has_value(); }

  // Follows the record up to the start of a tick, or to its end.
  void follow(std::uint32_t tick);

  // Follows the record to 3 s before a goal, or to where play began after the restart before it.
  void go_before(std::uint32_t goal);

  // Plays a future of a recorded goal from here, with a substitute for this robot of the team;
  // without one if empty. `number` tells the futures of a goal apart. A future lasts 3 s, and at
  // least until 1 s after the goal, because a goal that falls a little later is not prevented; play
  // that stops ends it. Returns true if the team neither concedes a goal nor has a penalty kick
  // given against it. A team that fails in a future prevents nothing.
  bool is_without_goal(std::uint32_t goal, std::optional<int> robot, int number);

  // Adds the frame of the present tick, and of each tick from now on, to a film, which outlives the
  // rehearsal.
  void show_in(web::ColumnEncoder& film);

 private:
  Rehearsal(const record::MatchRecord& record, Team team);

  // Puts what the substitute commands to the robot into the answer of its team; a fault if one of
  // them has failed. `in_goal` is the robot in the goal.
  void substitute(int robot, int in_goal, match::Observation seen, match::Answer& answer);

  void advance(const match::ByTeam<match::Answer>& answers);

  const replay::Recording& recording_;
  Team team_;
  match::Leg leg_;
  match::ByTeam<std::optional<server::TeamSeat>> own_;  // empty once a team has differed
  match::ByTeam<std::optional<server::TeamSeat>> stand_in_;
  std::optional<server::TeamSeat> substitute_;
  std::optional<server::TeamSeat> keeper_;
  web::ColumnEncoder* film_ = nullptr;
};

}  // namespace mirocup::coach
