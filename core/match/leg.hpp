// SPDX-License-Identifier: MIT
//
// One leg from the toss to the result, tick by tick.
//
// A tick is one control period. Both teams get the observation of its begin; their answers take
// effect in the next tick: a fixed decision delay, like camera and radio. Simulated time is the
// only time there is; how fast it passes is the caller's business.
//
// At a restart everybody is put in the default places in the tick of the decision. In the next tick
// the team that places first may ask for others, in the one after it the other team, which sees
// where the first stands.
#pragma once

#include "core/base/assert.hpp"
#include "core/base/random.hpp"
#include "core/base/state_hash.hpp"
#include "core/match/controller.hpp"
#include "core/match/observation.hpp"
#include "core/match/snapshot.hpp"
#include "core/simulator/model/tolerances.hpp"
#include "core/simulator/world.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace mirocup::match {

// Everything that a leg depends on besides the teams.
struct Setup {
  League league = League::small;
  referee::Rules rules;
  referee::Stage stage = referee::Stage::group;
  std::uint64_t seed = 1;
  double control_period = 0.033;  // s
  simulator::Parameters parameters;
  simulator::Tolerances tolerances;
};

enum class OutcomeKind { full_time, golden_goal, shoot_out, forfeit, double_forfeit, mercy, void_ };

struct TeamFault {
  Team team = Team::blue;
  Fault fault;
};

struct Outcome {
  ByTeam<int> score{};   // the official one: a forfeit is 0 to forfeit_goals
  ByTeam<int> played{};  // goals until the end, those of extra time with them
  std::optional<Team> winner;
  std::optional<ByTeam<int>> shoot_out;  // attempts scored, if there was one; not goals
  OutcomeKind kind = OutcomeKind::full_time;
  std::vector<TeamFault> faults;
  std::string why_void;
};

// A decision with the tick that it was made in, and colours in place of ends.
struct LoggedDecision {
  std::uint32_t tick = 0;
  referee::Decision decision;
  std::optional<Team> team;
  Team taker = Team::blue;
  ByTeam<referee::RobotSet> robots;  // who had a part in it
};

// A robot that touched the ball.
struct Touch {
  Team team = Team::blue;
  int robot = 0;
};

// What the match writes down of each tick.
struct TickLog {
  ByTeam<DrivenCommand> commands;  // the answers to this tick's observation, driven in the next
  std::uint64_t hash = 0;          // of all ticks up to the end of this one
};

// Where a team asked to stand, other than where it stood, in the tick that was its turn; or out of
// its turn, where that is an offence.
struct LoggedPlacementRequest {
  std::uint32_t tick = 0;
  Team team = Team::blue;
  PlacementRequest request;
};

class Leg {
 public:
  // Makes the toss and places the first kick-off.
  explicit Leg(const Setup& setup);
  Leg(const Leg&) = delete;
  Leg& operator=(const Leg&) = delete;

  const Setup& setup() const { return setup_; }
  const field::Field& field() const { return field_; }
  const referee::Pitch& pitch() const { return pitch_; }  // what the leg is judged on
  Briefing briefing(Team team) const;

  std::uint32_t tick() const { return tick_; }
  bool is_over() const { return outcome_.has_value(); }
  const Outcome& outcome() const {
    MIROCUP_ASSERT(is_over());
    return *outcome_;
  }

  // Plays one tick. The controllers steer blue and yellow; not to be called once over.
  void advance(Controller& blue, Controller& yellow);

  // The same with answers that are known already: nobody has to see anything.
  void advance(const ByTeam<Answer>& answers);

  // Ends the leg without a result: the machine failed.
  void declare_void(std::string why);

  // Ends the leg because of what teams did before the first tick.
  void forfeit(std::vector<TeamFault> faults);

  Snapshot snapshot() const;
  // What it holds of one body: cheaper than the scene where nothing else is asked for.
  simulator::BodyState robot(Team team, int i) const { return world_->robot(body_of(team, i)); }
  simulator::BallState ball() const { return world_->ball(); }
  const referee::Referee& referee() const { return *referee_; }
  const referee::Decision& restart() const { return restart_; }  // the last one
  // What the referee was shown in the last tick, or nothing while play stood.
  const std::optional<referee::Situation>& judged() const { return judged_; }
  const std::vector<LoggedDecision>& decisions() const { return decisions_; }
  const std::vector<TickLog>& log() const { return log_; }
  const std::vector<LoggedPlacementRequest>& placement_requests() const {
    return placement_requests_;
  }
  std::uint64_t state_hash() const { return hash_.value(); }
  // Who touched the ball last in the tick that was played, if anybody did.
  std::optional<Touch> last_touch() const;
  const ByTeam<int>& bad_values() const { return bad_values_; }
  const ByTeam<int>& late_ticks() const { return late_ticks_; }

 private:
  bool accept_answers(const ByTeam<Answer>& given);
  void simulate();
  void judge();
  void apply(const referee::Decision& decision);
  void start_phase(referee::Phase phase);
  bool is_active(Team team, int robot) const;
  void on_placement_request(Team team, const PlacementRequest& poses);
  void place();
  void grant_placement();
  void place_bodies(const referee::Placement& placement);
  void record();
  void end(OutcomeKind kind);
  void end(const referee::Decision& decision);
  void log_decision(const referee::Decision& decision);

  End end_of(Team team) const { return team == left_ ? End::left : End::right; }
  Team team_at(End end) const { return end == End::left ? left_ : opponent_of(left_); }
  int body_of(Team team, int robot) const {
    return index_of(team) * field_.robots_per_team + robot;
  }
  referee::Situation situation() const;
  void add_touches(const simulator::TickEvents& events, referee::Situation& s) const;

  Setup setup_;
  field::Field field_;
  referee::Pitch pitch_;
  Random rng_;  // of every toss and lot
  Team left_ = Team::blue;
  std::unique_ptr<simulator::World> world_;
  std::unique_ptr<referee::Referee> referee_;

  std::uint32_t tick_ = 0;
  State state_ = State::READY;
  int ready_ticks_left_ = 0;
  referee::Decision restart_;  // the last one
  bool placement_is_due_ = false;
  std::optional<Team> placing_;  // whose turn it is
  std::optional<PlacementRequest>
      requested_;  // what it asked for in this tick, and the same in the field's frame
  referee::Placement requested_placement_;
  referee::ByEnd<bool> hands_{};  // who asked out of its turn in this tick
  std::vector<LoggedPlacementRequest> placement_requests_;
  Vec2 ball_before_{0.0, 0.0};
  ByTeam<std::array<Vec2, max_robots_per_team>> velocity_before_;  // in the field's frame
  const simulator::TickEvents* events_ = nullptr;
  std::optional<referee::Situation> judged_;

  ByTeam<DrivenCommand> pending_;  // answers of the last tick, driven in this one
  ByTeam<DrivenCommand> answers_;  // of this tick
  ByTeam<int> late_in_a_row_{};
  ByTeam<int> late_ticks_{};
  ByTeam<int> bad_values_{};

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
