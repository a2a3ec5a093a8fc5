// SPDX-License-Identifier: MIT
//
// One leg from the toss to the outcome, tick by tick.
//
// A tick is one control period. Both teams observe the state at its start, and their answers take
// effect in the next tick: a fixed decision delay, like that of a camera and a radio. This class
// knows simulated time only; the caller decides how fast that time passes.
//
// At a restart every body is put in its default place in the tick of the decision. In the next tick
// the team that places first may ask for other places. One tick later the other team, which then
// sees where the first team stands, may ask.
//
// Threads: none of its own; one thread at a time may call it.
#pragma once

#include "core/base/assert.hpp"
#include "core/base/random.hpp"
#include "core/base/state_hash.hpp"
#include "core/match/camera.hpp"
#include "core/match/conditions.hpp"
#include "core/match/controller.hpp"
#include "core/match/disturbances.hpp"
#include "core/match/gain.hpp"
#include "core/match/goal_credit.hpp"
#include "core/match/observation.hpp"
#include "core/match/pitch_spec.hpp"
#include "core/match/put_down.hpp"
#include "core/match/snapshot.hpp"
#include "core/match/start.hpp"
#include "core/simulator/model/tolerances.hpp"
#include "core/simulator/world.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace mirocup::match {

// The control period of the platform whose rules a preset holds, s. SimuroSot asks its teams 60
// times a second, FIRASim every 16 ms; 33 ms are the sample time of MiroSot.
constexpr double control_period_of(referee::Preset preset) {
  switch (preset) {
    case referee::Preset::simurosot:
      return 1.0 / 60.0;
    case referee::Preset::vsss:
      return 0.016;
    case referee::Preset::mirosot:
      break;
  }
  return 0.033;
}

// Everything that a leg depends on besides the teams.
struct Setup {
  RobotLeague league = RobotLeague::small;
  referee::Rules rules;
  referee::Stage stage = referee::Stage::group;
  std::uint64_t seed = 1;
  double control_period = 0.033;      // s
  std::string pitch_name{"mirosot"};  // name of the pitch with the parameters below
  simulator::Parameters parameters;
  simulator::Tolerances tolerances;
  Conditions conditions;
  std::optional<Team> left;  // the team that defends the left end first; empty: a toss decides
  // The state from which the leg starts; if empty, the leg starts with the kick-off. Bodies must
  // not overlap by more than a millimetre, and if the start has a restart, all bodies must stand
  // where the law of that restart allows them. start->left replaces the `left` above.
  std::optional<Start> start;
};

// Gives the setup the name, the parameters and the control period of a pitch. If the pitch has no
// control period, the setup keeps its own.
void set_pitch(Setup& setup, const PitchSpec& pitch);

// The ways in which a leg can end.
enum class OutcomeKind { full_time, golden_goal, shoot_out, forfeit, double_forfeit, mercy, void_ };

// A fault and the team that made it.
struct TeamFault {
  Team team = Team::blue;
  Fault fault;
};

// The outcome of a leg.
struct Outcome {
  ByTeam<int> score{};   // the official score: a forfeit is 0 to forfeit_goals
  ByTeam<int> played{};  // goals scored, those of extra time included
  std::optional<Team> winner;
  std::optional<ByTeam<int>> shoot_out;  // attempts scored (not goals); empty: no shoot-out
  OutcomeKind kind = OutcomeKind::full_time;
  std::vector<TeamFault> faults;  // of a forfeit: one fault, or one of each team
  std::string why_void;           // a sentence, if the leg is void
};

// A decision with its tick, and with colours in place of ends.
struct LoggedDecision {
  std::uint32_t tick = 0;
  referee::Decision decision;
  std::optional<Team> team;
  Team taker = Team::blue;
  ByTeam<referee::RobotSet> robots;  // the robots involved
  Parties parties;
  std::optional<GoalCredit> credit;  // of a goal
  std::optional<ByTeam<int>> score;  // after a goal
};

// The log of one tick.
struct TickLog {
  ByTeam<DrivenCommand>
      commands;            // the answers to this tick's observation, driven in the next tick
  std::uint64_t hash = 0;  // of all ticks up to the end of this one
};

// A request for places other than those where the team stood: made in the team's turn, or out of
// its turn if that is an offence.
struct LoggedPlacementRequest {
  std::uint32_t tick = 0;
  Team team = Team::blue;
  PlacementRequest request;
};

// What a leg keeps of each tick that it has played.
enum class TickLogs {
  kept,     // a hash and an entry of the log for each tick: what a record needs
  dropped,  // neither; the play is the same and costs less
};

class Leg {
 public:
  // Tosses for ends and kick-off, and places the bodies for the kick-off, unless there is a start.
  explicit Leg(const Setup& setup, TickLogs tick_logs = TickLogs::kept);
  // The same leg, in a world that it shares with other legs. The world outlives the leg and was
  // made for the leg's field, parameters, tolerances and number of robots. The leg has the world
  // until lay_aside(), and again after each take_up(). While it does not have the world, only
  // functions about the referee, the setup and the logs may be called.
  Leg(const Setup& setup, TickLogs tick_logs, simulator::World& shared);
  Leg(const Leg&) = delete;
  Leg& operator=(const Leg&) = delete;

  // Take the bodies out of the shared world, and put them into a shared world again.
  void lay_aside();
  void take_up(simulator::World& shared);

  const Setup& setup() const { return setup_; }
  const field::Field& field() const { return field_; }
  const referee::JudgedField& pitch() const { return pitch_; }  // on which the leg is judged

  // Returns the briefing of the team before the first tick. It points into the leg.
  Briefing briefing(Team team) const;

  std::uint32_t tick() const { return tick_; }
  State state() const { return state_; }
  End end_of(Team team) const { return team == left_ ? End::left : End::right; }
  bool is_over() const { return outcome_.has_value(); }
  const Outcome& outcome() const {
    MIROCUP_ASSERT(is_over());
    return *outcome_;
  }

  // Plays one tick with the answers of two controllers. Not to be called once the leg is over.
  void advance(Controller& blue, Controller& yellow);

  // Plays one tick with answers that are known already, such as recorded ones; nothing is observed.
  void advance(const ByTeam<Answer>& answers);

  // Lets everything that is drawn tick by tick be drawn from another seed from now on: what a robot
  // makes of a command, what the camera sees and the radio loses, and how a hand puts bodies down.
  // The leg is then another future of the same moment, on the same floor with the same robots.
  void redraw(std::uint64_t seed);

  // Ends the leg without a winner, because the machine failed.
  void declare_void(std::string why);

  // Ends the leg because of one or two faults, such as that of a team that did not start. With two
  // faults the leg has no winner.
  void forfeit(std::vector<TeamFault> faults);

  // The true state between two ticks. Pages and records show it.
  Snapshot snapshot() const;
  // The state as teams and programs on the network see it: the true one, unless there is a camera.
  Snapshot view() const { return camera_ ? camera_->view() : snapshot(); }
  // The state of one body; cheaper than a snapshot if nothing else is needed.
  simulator::BodyState robot(Team team, int i) const { return world_->robot(body_of(team, i)); }
  simulator::BallState ball() const { return world_->ball(); }
  const referee::Referee& referee() const { return *referee_; }
  const referee::Decision& restart() const { return restart_; }  // the last restart
  Team taker() const { return team_at(restart_.taker); }         // who takes it
  // The situation that the referee judged in the last tick; nothing if play was stopped then.
  const std::optional<referee::TickFacts>& judged() const { return judged_; }

  // The answers to the observation of the last tick, which are driven in the next one.
  const ByTeam<DrivenCommand>& answers() const { return answers_; }

  // The log up to now: decisions in their order, one entry for each tick, requests in their order.
  const std::vector<LoggedDecision>& decisions() const { return decisions_; }
  const std::vector<TickLog>& log() const { return log_; }
  const std::vector<LoggedPlacementRequest>& placement_requests() const {
    return placement_requests_;
  }

  // The hash of the states of all ticks played; without meaning if the tick logs are dropped.
  std::uint64_t state_hash() const { return hash_.value(); }
  // The last robot to touch the ball in the most recent tick; nothing if none touched it.
  std::optional<Touch> last_touch() const;

  // Counted for each team: commands with a value that was zeroed or clamped, and late answers.
  const ByTeam<int>& bad_values() const { return bad_values_; }
  const ByTeam<int>& late_ticks() const { return late_ticks_; }

 private:
  Leg(const Setup& setup, TickLogs tick_logs, simulator::World* shared);
  bool accept_answers(const ByTeam<Answer>& given);
  void drive(Team team, const Command& command);
  void simulate();
  void judge();
  void apply(const referee::Decision& decision);
  void begin_at(const Start& start);
  void set_in_motion(const Start& start);
  void wait_for_whistle(Team first_to_place);
  void start_phase(referee::Phase phase);
  bool is_active(Team team, int robot) const;
  void on_placement_request(Team team, const PlacementRequest& poses);
  referee::Placement standing() const;  // where all bodies are
  void place();
  void grant_placement();
  void place_bodies(const referee::Placement& placement);
  referee::Placement by_hand(const referee::Placement& wanted, const Moved& moved);
  referee::Roles roles() const;
  simulator::WheelSpeeds driven_speeds(Team team, int robot);
  void look();
  void record();
  void end_tick();
  void end(OutcomeKind kind);
  void end(const referee::Decision& decision);
  void log_decision(const referee::Decision& decision);
  void note_ball_contacts(const simulator::BallState& before);
  void give_credit(LoggedDecision& goal) const;

  Team team_at(End end) const { return end == End::left ? left_ : opponent_of(left_); }
  int body_of(Team team, int robot) const {
    return index_of(team) * field_.robots_per_team + robot;
  }
  referee::TickFacts situation() const;
  void add_touches(const simulator::TickEvents& events, referee::TickFacts& s) const;

  Setup setup_;
  field::Field field_;
  referee::JudgedField pitch_;
  Random rng_;  // decides every toss and lot
  Team left_ = Team::blue;
  std::optional<Disturbances> disturbances_;     // nothing under exact conditions
  std::optional<Camera> camera_;                 // nothing unless the conditions have one
  bool were_placed_ = false;                     // bodies were placed since the camera last looked
  std::unique_ptr<simulator::World> own_world_;  // null if the leg shares a world
  simulator::World* world_ = nullptr;
  simulator::World::State laid_aside_;  // the bodies, while the leg is laid aside
  std::unique_ptr<referee::Referee> referee_;

  std::uint32_t tick_ = 0;
  State state_ = State::READY;
  int ready_ticks_left_ = 0;
  referee::Decision restart_;  // the last restart
  bool placement_is_due_ = false;
  std::optional<Team> placing_;  // the team whose turn it is to place
  // The placement that `placing_` requested in this tick, in its own frame and in the field's.
  std::optional<PlacementRequest> requested_;
  referee::Placement requested_placement_;
  referee::ByEnd<bool> hands_{};  // true for a team that asked out of its turn in this tick
  std::vector<LoggedPlacementRequest> placement_requests_;
  Vec2 ball_before_{0.0, 0.0};
  ByTeam<std::array<Vec2, max_robots_per_team>> velocity_before_;  // field's frame, m/s
  const simulator::TickEvents* events_ = nullptr;
  BallContacts ball_contacts_;
  std::optional<referee::TickFacts> judged_;

  ByTeam<DrivenCommand> pending_;  // the answers of the last tick, driven in this one
  ByTeam<DrivenCommand> answers_;  // the answers of this tick
  ByTeam<int> late_in_a_row_{};
  ByTeam<int> late_ticks_{};
  ByTeam<int> bad_values_{};

  TickLogs tick_logs_;
  StateHash hash_;
  std::vector<TickLog> log_;
  std::vector<LoggedDecision> decisions_;
  std::optional<Outcome> outcome_;
};

}  // namespace mirocup::match

namespace mirocup {

template <>
inline constexpr std::array<std::string_view, 7> enum_names<match::OutcomeKind>{
    "full_time", "golden_goal", "shoot_out", "forfeit", "double_forfeit", "mercy", "void"};

}  // namespace mirocup
