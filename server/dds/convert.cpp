// SPDX-License-Identifier: MIT
#include "server/dds/convert.hpp"

#include "core/match/copy_fields.hpp"

#include <cassert>

namespace mirocup::dds {

static_assert(max_robots_per_team == mirocup_v2_MAX_ROBOTS);

// The numbers that idl/mirocup.idl gives to enumerators are on the network. If an enum of the core
// were reordered, or got a member in its middle, the topics would change without an error.
template <class E>
constexpr bool is_wire_value(E value, int number) {
  return static_cast<int>(value) == number;
}
static_assert(enum_names<League>.size() == 3 && is_wire_value(League::small, 0) &&
              is_wire_value(League::middle, 1) && is_wire_value(League::large, 2));
static_assert(enum_names<Team>.size() == 2 && is_wire_value(Team::blue, 0) &&
              is_wire_value(Team::yellow, 1));
static_assert(enum_names<match::State>.size() == 3 && is_wire_value(match::State::READY, 0) &&
              is_wire_value(match::State::PLAY, 1) && is_wire_value(match::State::END, 2));
static_assert(enum_names<referee::Phase>.size() == 4 &&
              is_wire_value(referee::Phase::FIRST_HALF, 0) &&
              is_wire_value(referee::Phase::SECOND_HALF, 1) &&
              is_wire_value(referee::Phase::EXTRA, 2) &&
              is_wire_value(referee::Phase::SHOOT_OUT, 3));
static_assert(enum_names<referee::Restart>.size() == 6 &&
              is_wire_value(referee::Restart::none, 0) &&
              is_wire_value(referee::Restart::KICK_OFF, 1) &&
              is_wire_value(referee::Restart::GOAL_KICK, 2) &&
              is_wire_value(referee::Restart::PENALTY_KICK, 3) &&
              is_wire_value(referee::Restart::FREE_BALL, 4) &&
              is_wire_value(referee::Restart::FREE_KICK, 5));
static_assert(is_wire_value(Admission::accepted, 0) && is_wire_value(Admission::not_now, 1) &&
              is_wire_value(Admission::refused, 2));

namespace {

mirocup_v2_RobotState to_sample(const simulator::BodyState& r) {
  return {r.position.x(),  r.position.y(), r.heading.cos, r.heading.sin,
          r.twist.forward, r.twist.left,   r.twist.omega};
}

simulator::BodyState to_robot(const mirocup_v2_RobotState& r) {
  return {{r.x, r.y}, {r.heading_cos, r.heading_sin}, {r.forward, r.left, r.turn}};
}

template <class E>
std::uint8_t octet(E value) {
  return static_cast<std::uint8_t>(value);
}

constexpr std::uint8_t no_team = 2;  // WorldState.placing while no team places

// Converts a number from the network; one that is out of range becomes the first enumerator.
template <class E>
E enumerator(std::uint8_t value) {
  return value < enum_names<E>.size() ? static_cast<E>(value) : E{};
}

}  // namespace

mirocup_v2_WorldState to_sample(const match::Snapshot& scene, int robots, std::uint64_t leg) {
  assert(robots >= 0 && robots <= max_robots_per_team);
  mirocup_v2_WorldState s{};
  s.leg = leg;
  s.tick = scene.tick;
  s.time = scene.time;
  s.clock = scene.clock;
  s.state = octet(scene.state);
  s.phase = octet(scene.phase);
  s.restart = octet(scene.restart);
  s.taker = octet(scene.taker);
  s.left = octet(scene.left);
  s.placing = scene.placing ? octet(*scene.placing) : no_team;
  s.robots = static_cast<std::uint8_t>(robots);
  s.score[0] = scene.score[0];
  s.score[1] = scene.score[1];
  s.ball_x = scene.ball.position.x();
  s.ball_y = scene.ball.position.y();
  s.ball_vx = scene.ball.velocity.x();
  s.ball_vy = scene.ball.velocity.y();
  for (int i = 0; i < robots; ++i) {
    s.blue[i] = to_sample(scene.robots[0][i]);
    s.yellow[i] = to_sample(scene.robots[1][i]);
  }
  s.stalemate_s = scene.stalemate_s;
  s.advantage_s = scene.advantage_s;
  for (int team = 0; team < 2; ++team) match::copy_counts(scene.counts[team], s.counts[team]);
  return s;
}

match::Snapshot to_scene(const mirocup_v2_WorldState& s) {
  match::Snapshot scene;
  scene.tick = s.tick;
  scene.time = s.time;
  scene.clock = s.clock;
  scene.state = enumerator<match::State>(s.state);
  scene.phase = enumerator<referee::Phase>(s.phase);
  scene.restart = enumerator<referee::Restart>(s.restart);
  scene.taker = enumerator<Team>(s.taker);
  scene.left = enumerator<Team>(s.left);
  if (s.placing < no_team) scene.placing = enumerator<Team>(s.placing);
  scene.score = {s.score[0], s.score[1]};
  scene.ball = {{s.ball_x, s.ball_y}, {s.ball_vx, s.ball_vy}};
  for (int i = 0; i < max_robots_per_team; ++i) {
    scene.robots[0][i] = to_robot(s.blue[i]);
    scene.robots[1][i] = to_robot(s.yellow[i]);
  }
  scene.stalemate_s = s.stalemate_s;
  scene.advantage_s = s.advantage_s;
  for (int team = 0; team < 2; ++team) match::copy_counts(s.counts[team], scene.counts[team]);
  return scene;
}

mirocup_v2_Welcome to_sample(const match::Briefing& briefing, std::uint64_t leg,
                             std::uint64_t nonce) {
  mirocup_v2_Welcome w{};
  w.team = octet(briefing.team);
  w.nonce = nonce;
  w.leg = leg;
  w.answer = octet(Admission::accepted);
  w.league = octet(briefing.field->league);
  w.seed = briefing.seed;
  w.control_period = briefing.control_period;
  w.half_seconds = briefing.rules->half_s;
  match::copy_bodies(*briefing.parameters, w);
  return w;
}

bool from_sample(const mirocup_v2_Welcome& w, OwnedBriefing& owned) {
  if (w.league >= enum_names<League>.size() || w.team >= enum_names<Team>.size()) return false;
  owned.field = field::make_field(static_cast<League>(w.league));
  match::copy_bodies(w, owned.parameters);
  owned.rules.half_s = w.half_seconds;
  owned.briefing = {.field = &owned.field,
                    .parameters = &owned.parameters,
                    .rules = &owned.rules,
                    .control_period = w.control_period,
                    .team = static_cast<Team>(w.team),
                    .seed = w.seed};
  return true;
}

mirocup_v2_MatchEvent to_sample(const match::LoggedDecision& d, std::uint64_t leg,
                                std::uint32_t number, const match::ByTeam<int>& score) {
  mirocup_v2_MatchEvent e{};
  e.leg = leg;
  e.number = number;
  e.tick = d.tick;
  e.clock = d.decision.clock;
  copy_text(e.decision, to_string(d.decision.verdict));
  copy_text(e.law, to_string(d.decision.law));
  copy_text(e.reason, d.decision.reason);
  e.score[0] = score[0];
  e.score[1] = score[1];
  return e;
}

mirocup_v2_TeamCommand to_sample(const match::Command& command, Team team, std::uint32_t tick,
                                 std::uint64_t nonce) {
  mirocup_v2_TeamCommand s{};
  s.team = octet(team);
  s.nonce = nonce;
  s.tick = tick;
  for (int i = 0; i < max_robots_per_team; ++i) {
    s.left[i] = command.wheels[i].left;
    s.right[i] = command.wheels[i].right;
  }
  if (!command.placement) return s;
  s.places = 1;
  s.place_ball_x = command.placement->ball_x;
  s.place_ball_y = command.placement->ball_y;
  for (int i = 0; i < max_robots_per_team; ++i) {
    const match::RequestedPose& pose = command.placement->robots[i];
    s.place[i] = {pose.x, pose.y, pose.heading};
  }
  return s;
}

match::Command to_command(const mirocup_v2_TeamCommand& s) {
  match::Command command;
  for (int i = 0; i < max_robots_per_team; ++i) command.wheels[i] = {s.left[i], s.right[i]};
  if (s.places == 0) return command;
  match::PlacementRequest& poses = command.placement.emplace();
  poses.ball_x = s.place_ball_x;
  poses.ball_y = s.place_ball_y;
  for (int i = 0; i < max_robots_per_team; ++i) {
    poses.robots[i] = {s.place[i].x, s.place[i].y, s.place[i].heading};
  }
  return command;
}

}  // namespace mirocup::dds
