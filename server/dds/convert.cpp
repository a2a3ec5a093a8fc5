// SPDX-License-Identifier: MIT
#include "server/dds/convert.hpp"

#include "core/match/copy_fields.hpp"

namespace mirocup::dds {

static_assert(max_robots_per_team == mirocup_v2_MAX_ROBOTS);

namespace {

mirocup_v2_RobotState to_sample(const simulator::BodyState& r) {
  return {r.position.x(),  r.position.y(), r.heading.cos, r.heading.sin,
          r.twist.forward, r.twist.left,   r.twist.turn};
}

simulator::BodyState to_robot(const mirocup_v2_RobotState& r) {
  return {{r.x, r.y}, {r.heading_cos, r.heading_sin}, {r.forward, r.left, r.turn}};
}

template <class E>
std::uint8_t octet(E value) {
  return static_cast<std::uint8_t>(value);
}

constexpr std::uint8_t nobody = 2;  // as a colour

// Numbers from the network: what is out of range counts as 0.
template <class E>
E enumerator(std::uint8_t value) {
  return value < enum_names<E>.size() ? static_cast<E>(value) : E{};
}

}  // namespace

mirocup_v2_WorldState to_sample(const match::Snapshot& scene, int robots, std::uint64_t leg) {
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
  s.placing = scene.placing ? octet(*scene.placing) : nobody;
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
  if (s.placing < nobody) scene.placing = enumerator<Team>(s.placing);
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

bool from_sample(const mirocup_v2_Welcome& w, Told& told) {
  if (w.league >= enum_names<League>.size() || w.team >= enum_names<Team>.size()) return false;
  told.field = field::make_field(static_cast<League>(w.league));
  match::copy_bodies(w, told.parameters);
  told.rules.half_s = w.half_seconds;
  told.briefing = {.field = &told.field,
                   .parameters = &told.parameters,
                   .rules = &told.rules,
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
  put_text(e.decision, to_string(d.decision.verdict));
  put_text(e.law, to_string(d.decision.law));
  put_text(e.reason, d.decision.reason);
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
