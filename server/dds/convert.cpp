// SPDX-License-Identifier: MIT
#include "server/dds/convert.hpp"

#include "core/match/call_text.hpp"
#include "core/match/copy_fields.hpp"

#include <algorithm>
#include <cassert>

namespace mirocup::dds {

static_assert(max_robots_per_team == mirocup_v1_MAX_ROBOTS);

// The enumerators of the core and the constants of idl/mirocup.idl are the same numbers. If an enum
// of the core were reordered, or got a member in its middle, the topics would change without an
// error.
template <class E, class Wire>
constexpr bool is_wire_value(E value, Wire number) {
  return static_cast<int>(value) == static_cast<int>(number);
}
static_assert(enum_names<RobotLeague>.size() == 3 &&
              is_wire_value(RobotLeague::small, mirocup_v1_LEAGUE_SMALL) &&
              is_wire_value(RobotLeague::middle, mirocup_v1_LEAGUE_MIDDLE) &&
              is_wire_value(RobotLeague::large, mirocup_v1_LEAGUE_LARGE));
static_assert(enum_names<Team>.size() == 2 && is_wire_value(Team::blue, mirocup_v1_COLOUR_BLUE) &&
              is_wire_value(Team::yellow, mirocup_v1_COLOUR_YELLOW));
static_assert(enum_names<match::State>.size() == 3 &&
              is_wire_value(match::State::READY, mirocup_v1_STATE_READY) &&
              is_wire_value(match::State::PLAY, mirocup_v1_STATE_PLAY) &&
              is_wire_value(match::State::END, mirocup_v1_STATE_END));
static_assert(enum_names<referee::Phase>.size() == 4 &&
              is_wire_value(referee::Phase::FIRST_HALF, mirocup_v1_PHASE_FIRST_HALF) &&
              is_wire_value(referee::Phase::SECOND_HALF, mirocup_v1_PHASE_SECOND_HALF) &&
              is_wire_value(referee::Phase::EXTRA, mirocup_v1_PHASE_EXTRA) &&
              is_wire_value(referee::Phase::SHOOT_OUT, mirocup_v1_PHASE_SHOOT_OUT));
static_assert(enum_names<referee::Restart>.size() == 6 &&
              is_wire_value(referee::Restart::none, mirocup_v1_RESTART_NONE) &&
              is_wire_value(referee::Restart::KICK_OFF, mirocup_v1_RESTART_KICK_OFF) &&
              is_wire_value(referee::Restart::GOAL_KICK, mirocup_v1_RESTART_GOAL_KICK) &&
              is_wire_value(referee::Restart::PENALTY_KICK, mirocup_v1_RESTART_PENALTY_KICK) &&
              is_wire_value(referee::Restart::FREE_BALL, mirocup_v1_RESTART_FREE_BALL) &&
              is_wire_value(referee::Restart::FREE_KICK, mirocup_v1_RESTART_FREE_KICK));
static_assert(is_wire_value(Admission::accepted, mirocup_v1_ADMISSION_ACCEPTED) &&
              is_wire_value(Admission::not_now, mirocup_v1_ADMISSION_NOT_NOW) &&
              is_wire_value(Admission::refused, mirocup_v1_ADMISSION_REFUSED));

namespace {

mirocup_v1_RobotState to_sample(const match::ObservedRobot& r) {
  return {r.position.x(), r.position.y(), r.heading, r.velocity.x(), r.velocity.y(), r.turn};
}

match::ObservedRobot to_robot(const mirocup_v1_RobotState& r) {
  return {.position = {r.x, r.y}, .heading = r.heading, .velocity = {r.vx, r.vy}, .turn = r.turn};
}

std::uint8_t age_octet(int ticks) {
  return static_cast<std::uint8_t>(std::min(ticks, 255));
}

mirocup_v1_LegFacts facts_of(const match::Briefing& briefing) {
  mirocup_v1_LegFacts facts{};
  facts.league = static_cast<std::uint8_t>(briefing.field->league);
  facts.robots = static_cast<std::uint8_t>(briefing.field->robots_per_team);
  facts.control_period = briefing.control_period;
  facts.half_seconds = briefing.rules->half_s;
  match::copy_field(*briefing.field, facts);
  match::copy_bodies(*briefing.parameters, facts);
  const auto add = [&](const char* name, double value) {
    mirocup_v1_NamedNumber& number = facts.numbers[facts.named++];
    copy_text(number.name, name);
    number.value = value;
  };
  match::for_each_physics(*briefing.parameters, add);
  match::for_each_limit(*briefing.rules, add);
  return facts;
}

std::uint8_t colour(Team team) {
  return static_cast<std::uint8_t>(team);
}

Team team_of(std::uint8_t colour) {
  return colour == mirocup_v1_COLOUR_YELLOW ? Team::yellow : Team::blue;
}

}  // namespace

mirocup_v1_WorldState to_sample(const match::Snapshot& scene, int robots, std::uint64_t leg) {
  assert(robots >= 0 && robots <= max_robots_per_team);
  mirocup_v1_WorldState s{};
  s.layout = mirocup_v1_LAYOUT_NUMBER;
  s.leg = leg;
  s.tick = scene.tick;
  s.time = scene.time;
  s.clock = scene.clock;
  s.state = static_cast<std::uint8_t>(scene.state);
  s.phase = static_cast<std::uint8_t>(scene.phase);
  s.restart = static_cast<std::uint8_t>(scene.restart);
  s.taker = colour(scene.taker);
  s.left = colour(scene.left);
  s.placing = scene.placing ? colour(*scene.placing) : mirocup_v1_COLOUR_NEITHER;
  s.robots = static_cast<std::uint8_t>(robots);
  for (int team = 0; team < 2; ++team) {
    s.score[team] = static_cast<std::uint16_t>(scene.score[team]);
  }
  s.ball_x = scene.ball.position.x();
  s.ball_y = scene.ball.position.y();
  s.ball_vx = scene.ball.velocity.x();
  s.ball_vy = scene.ball.velocity.y();
  for (int i = 0; i < robots; ++i) {
    s.blue[i] = to_sample(scene.robots[0][i]);
    s.yellow[i] = to_sample(scene.robots[1][i]);
    s.blue_age[i] = age_octet(scene.robots[0][i].age);
    s.yellow_age[i] = age_octet(scene.robots[1][i].age);
  }
  s.ball_age = age_octet(scene.ball_age);
  s.stalemate_s = scene.stalemate_s;
  s.advantage_s = scene.advantage_s;
  for (int team = 0; team < 2; ++team) match::copy_counts(scene.counts[team], s.counts[team]);
  return s;
}

match::Snapshot to_scene(const mirocup_v1_WorldState& s) {
  match::Snapshot scene;
  scene.tick = s.tick;
  scene.time = s.time;
  scene.clock = s.clock;
  scene.state = static_cast<match::State>(s.state);
  scene.phase = static_cast<referee::Phase>(s.phase);
  scene.restart = static_cast<referee::Restart>(s.restart);
  scene.taker = team_of(s.taker);
  scene.left = team_of(s.left);
  if (s.placing != mirocup_v1_COLOUR_NEITHER) scene.placing = team_of(s.placing);
  scene.score = {s.score[0], s.score[1]};
  scene.ball = {{s.ball_x, s.ball_y}, {s.ball_vx, s.ball_vy}};
  for (int i = 0; i < max_robots_per_team; ++i) {
    scene.robots[0][i] = to_robot(s.blue[i]);
    scene.robots[1][i] = to_robot(s.yellow[i]);
    scene.robots[0][i].age = s.blue_age[i];
    scene.robots[1][i].age = s.yellow_age[i];
  }
  scene.ball_age = s.ball_age;
  scene.stalemate_s = s.stalemate_s;
  scene.advantage_s = s.advantage_s;
  for (int team = 0; team < 2; ++team) match::copy_counts(s.counts[team], scene.counts[team]);
  return scene;
}

mirocup_v1_Welcome to_sample(const match::Briefing& briefing, std::uint64_t leg,
                             std::uint64_t nonce) {
  mirocup_v1_Welcome w{};
  w.layout = mirocup_v1_LAYOUT_NUMBER;
  w.team = colour(briefing.team);
  w.nonce = nonce;
  w.leg = leg;
  w.answer = mirocup_v1_ADMISSION_ACCEPTED;
  w.seed = briefing.seed;
  w.facts = facts_of(briefing);
  return w;
}

mirocup_v1_MatchInfo to_sample(const match::Briefing& briefing, std::uint64_t leg,
                               const match::ByTeam<std::string>& names, double speed) {
  mirocup_v1_MatchInfo info{};
  info.layout = mirocup_v1_LAYOUT_NUMBER;
  info.leg = leg;
  copy_text(info.blue, names[0]);
  copy_text(info.yellow, names[1]);
  info.speed = speed;
  info.facts = facts_of(briefing);
  return info;
}

bool from_sample(const mirocup_v1_Welcome& w, OwnedBriefing& owned) {
  if (w.facts.league > mirocup_v1_LEAGUE_LARGE || w.team > mirocup_v1_COLOUR_YELLOW) return false;
  owned.field = field::make_field(static_cast<RobotLeague>(w.facts.league));
  match::copy_bodies(w.facts, owned.parameters);
  const std::size_t named = std::min<std::size_t>(w.facts.named, mirocup_v1_MAX_NUMBERS);
  const auto read = [&](std::string_view name, auto& member) {
    for (std::size_t i = 0; i < named; ++i) {
      const double value = w.facts.numbers[i].value;
      if (name == w.facts.numbers[i].name)
        member = static_cast<std::decay_t<decltype(member)>>(value);
    }
  };
  match::for_each_physics(owned.parameters, read);
  match::for_each_limit(owned.rules, read);
  owned.rules.half_s = w.facts.half_seconds;
  owned.briefing = {.field = &owned.field,
                    .parameters = &owned.parameters,
                    .rules = &owned.rules,
                    .control_period = w.facts.control_period,
                    .team = static_cast<Team>(w.team),
                    .seed = w.seed};
  return true;
}

mirocup_v1_MatchEvent to_sample(const match::LoggedDecision& d, std::uint64_t leg,
                                std::uint32_t number, const match::ByTeam<int>& score) {
  mirocup_v1_MatchEvent e{};
  e.layout = mirocup_v1_LAYOUT_NUMBER;
  e.leg = leg;
  e.number = number;
  e.tick = d.tick;
  e.clock = d.decision.clock;
  copy_text(e.decision, to_string(d.decision.verdict));
  copy_text(e.law, to_string(d.decision.law));
  copy_text(e.reason, match::call_text(d, {"blue", "yellow"}, score));
  for (int team = 0; team < 2; ++team) e.score[team] = static_cast<std::uint16_t>(score[team]);
  return e;
}

mirocup_v1_TeamCommand to_sample(const match::Command& command, Team team, std::uint32_t tick,
                                 std::uint64_t nonce) {
  mirocup_v1_TeamCommand s{};
  s.team = colour(team);
  s.nonce = nonce;
  s.tick = tick;
  for (int i = 0; i < max_robots_per_team; ++i) {
    s.left[i] = command.wheels[i].left;
    s.right[i] = command.wheels[i].right;
  }
  if (!command.placement) return s;
  s.places = true;
  s.place_ball_x = command.placement->ball_x;
  s.place_ball_y = command.placement->ball_y;
  for (int i = 0; i < max_robots_per_team; ++i) {
    const match::RequestedPose& pose = command.placement->robots[i];
    s.place[i] = {pose.x, pose.y, pose.heading};
  }
  return s;
}

bool is_known(const mirocup_v1_WorldState& s) {
  return s.state <= mirocup_v1_STATE_END && s.phase <= mirocup_v1_PHASE_SHOOT_OUT &&
         s.restart <= mirocup_v1_RESTART_FREE_KICK && s.taker <= mirocup_v1_COLOUR_YELLOW &&
         s.left <= mirocup_v1_COLOUR_YELLOW && s.placing <= mirocup_v1_COLOUR_NEITHER &&
         s.robots <= mirocup_v1_MAX_ROBOTS;
}

match::Command to_command(const mirocup_v1_TeamCommand& s) {
  match::Command command;
  for (int i = 0; i < max_robots_per_team; ++i) command.wheels[i] = {s.left[i], s.right[i]};
  if (!s.places) return command;
  match::PlacementRequest& poses = command.placement.emplace();
  poses.ball_x = s.place_ball_x;
  poses.ball_y = s.place_ball_y;
  for (int i = 0; i < max_robots_per_team; ++i) {
    poses.robots[i] = {s.place[i].x, s.place[i].y, s.place[i].heading};
  }
  return command;
}

std::string layout_mismatch(std::uint32_t theirs) {
  if (theirs == mirocup_v1_LAYOUT_NUMBER) return "";
  return "its topics have layout " + std::to_string(theirs) + ", those here " +
         std::to_string(mirocup_v1_LAYOUT_NUMBER) + ": both need the same version of mirocup";
}

}  // namespace mirocup::dds
