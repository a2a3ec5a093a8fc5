// SPDX-License-Identifier: MIT
//
// Judges one try of a drill: follows the leg tick by tick, says when the try is over, and gives its
// marks.
//
// Definitions:
//   foul      a call with which the tested team gives the opponents something
//   contact   a touch of one robot in consecutive ticks
//   pass      a contact of one robot of the team after a contact of another, with no opponent's
//             contact between them, when the ball has rolled for at least 0.15 m
//   save      a contact of the tested team with a ball that would have gone into its goal, after
//             which no goal falls for half a second, or until play is stopped
#pragma once

#include "record/drills/drill.hpp"

namespace mirocup::drills {

// The result of one try.
struct TryResult {
  bool passed = false;   // true: all events of the drill came out as required
  double marks = 0.0;    // 0 to 1
  double seconds = 0.0;  // s of play until the try was over
  std::string why;       // the first missing event: "goal"; "" if the try passed
};

class Judge {
 public:
  // Drill and leg must outlive the judge. To be made before the leg's first tick.
  Judge(const Drill& drill, const match::Leg& leg);

  // Judges the tick that the leg has just played. Returns false when the try is decided, or the leg
  // is over. After that this function must not be called again.
  bool follow();

  // Returns the result of the try so far.
  TryResult result() const;

 private:
  struct State {
    int count = 0;
    double held = 0.0;         // s: how long a pose or a place has been kept without a break
    std::optional<double> at;  // s since the start: when the event came true
  };
  struct Contact {
    match::Touch who;
    std::uint32_t tick = 0;  // the last tick of the contact
    Vec2 ball{0.0, 0.0};     // place of the ball in the contact's last tick
  };

  void see_decisions();
  void see_touch();
  void see_save();
  void end_save();
  void see_places();
  void count(EventKind kind, const match::Touch* touch = nullptr);
  void hold(const Event& event, State& state, bool is_there);
  bool is_in_pose(const Event& event) const;
  bool is_in_area(const Event& event) const;
  bool is_true(const Event& event, const State& state) const;
  bool is_decided() const;
  double now() const;  // s of play since the start

  const Drill& drill_;
  const match::Leg& leg_;
  std::vector<State> states_;  // of the drill's events
  double begin_ = 0.0;         // the leg's clock at the start, s
  double last_clock_ = 0.0;
  std::size_t decisions_ = 0;  // number of decisions judged so far
  bool was_stopped_ = false;   // true: play was stopped since the start
  bool touched_by_opponent_ = false;
  int conceded_ = 0;
  int fouls_ = 0;
  std::optional<Contact> contact_;  // the last contact
  std::optional<double> saved_at_;  // time of a save that may still fail, s
  simulator::BallState ball_before_;
};

}  // namespace mirocup::drills
