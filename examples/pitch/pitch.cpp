// SPDX-License-Identifier: MIT
//
// A real pitch behind the topics of a match: publishes the pictures of a camera as states and sends
// the answers of the teams to the radio. Usage: pitch [--wait] MATCH SECONDS BLUE [YELLOW], with
// the names of the teams. With --wait time stands until all teams have answered: for stand-ins.
//
// It replaces a match server (server/dds/README.md) for practice: teams may come and go at any
// time, and the referee is a person beside the pitch.
#include "server/dds/convert.hpp"
#include "server/dds/domain.hpp"
#include "server/dds/nonce.hpp"
#include "table.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string_view>
#include <thread>
#include <vector>

namespace pitch {
namespace {

using namespace mirocup;
using WallClock = std::chrono::steady_clock;

constexpr double period = 1.0 / 30.0;  // s between two pictures
// The robots of a team that has not answered for more ticks than this are stopped.
constexpr std::uint32_t max_silence = 4;

// Computes speeds from two pictures. For a noisy camera put a filter here.
match::ObservedRobot robot_state(const Place& now, const Place& before) {
  return {{now.x, now.y},
          match::observed_angle(Heading::from_angle(now.heading)),
          {(now.x - before.x) / period, (now.y - before.y) / period},
          std::remainder(now.heading - before.heading, 2.0 * M_PI) / period};
}

match::Snapshot scene_of(const Picture& now, const Picture& before) {
  match::Snapshot scene;
  scene.ball.position = {now.ball.x, now.ball.y};
  scene.ball.velocity = {(now.ball.x - before.ball.x) / period,
                         (now.ball.y - before.ball.y) / period};
  for (int colour = 0; colour < 2; ++colour) {
    for (int i = 0; i < max_robots_per_team; ++i) {
      scene.robots[colour][i] = robot_state(now.robots[colour][i], before.robots[colour][i]);
    }
  }
  return scene;
}

// The topics of one team and its last answer.
struct Side {
  Team team = Team::blue;
  dds::Entity publisher, subscriber, hello_topic, welcome_topic, command_topic;
  dds::Entity hellos, welcomes, commands;
  std::uint64_t nonce = 0;  // 0: no process has joined
  std::uint64_t heard = 0;
  std::uint32_t answered = 0;
  match::Command wheels;
};

// Returns the value, or ends the example with the error.
template <class T>
T need(Result<T> made) {
  if (made) return std::move(*made);
  std::cerr << "pitch: " << made.error().what << '\n';
  std::_Exit(exit_code(made.error().code));  // Cyclone's threads still run
}

class Pitch {
 public:
  Pitch(const std::string& match_id, const std::vector<std::string>& names, Camera& camera,
        Radio& radio);
  // `waits`: for the answers to each tick, as it does for those to the first one in any case.
  void play(double seconds, bool waits);

 private:
  void hear(Side& side, std::uint32_t tick);
  void show(const Picture& now, const Picture& before, std::uint32_t tick, match::State state);
  bool is_complete(std::uint32_t tick) const;
  void say_that_it_is_over(std::uint32_t tick);

  Camera& camera_;
  Radio& radio_;
  field::Field field_ = field::make_field(RobotLeague::small);
  simulator::Parameters robots_;  // measure yours, and put their numbers here
  referee::Rules rules_;
  std::uint64_t leg_ = dds::random_nonce();
  dds::Domain domain_ = need(dds::open_server_domain("lo", ""));
  dds::Entity participant_ = need(dds::make_participant(domain_));
  dds::Entity publisher_, state_topic_, event_topic_, info_topic_, states_, events_, infos_;
  std::vector<Side> sides_;
};

Pitch::Pitch(const std::string& match_id, const std::vector<std::string>& names, Camera& camera,
             Radio& radio)
    : camera_(camera), radio_(radio) {
  const dds::Entity& p = participant_;
  publisher_ = need(dds::make_publisher(p, dds::match_partition(match_id)));
  state_topic_ = need(dds::make_topic(p, mirocup_v1_WorldState_desc, idl::world_state));
  event_topic_ = need(dds::make_topic(p, mirocup_v1_MatchEvent_desc, idl::match_event));
  states_ = need(dds::make_writer(publisher_, state_topic_, idl::world_state));
  events_ = need(dds::make_writer(publisher_, event_topic_, idl::match_event));
  info_topic_ = need(dds::make_topic(p, mirocup_v1_MatchInfo_desc, idl::match_info));
  infos_ = need(dds::make_writer(publisher_, info_topic_, idl::match_info));
  const match::Briefing facts{&field_, &robots_, &rules_, period, Team::blue, 1};
  const mirocup_v1_MatchInfo info =
      dds::to_sample(facts, leg_, {names[0], names.size() > 1 ? names[1] : std::string()}, 1.0);
  dds_write(infos_.get(), &info);
  for (std::size_t i = 0; i < names.size(); ++i) {
    Side side;
    side.team = both_teams[i];
    const std::string own = dds::team_partition(match_id, static_cast<int>(i), names[i]);
    side.publisher = need(dds::make_publisher(p, own));
    side.subscriber = need(dds::make_subscriber(p, own));
    side.hello_topic = need(dds::make_topic(p, mirocup_v1_Hello_desc, idl::hello));
    side.welcome_topic = need(dds::make_topic(p, mirocup_v1_Welcome_desc, idl::welcome));
    side.command_topic = need(dds::make_topic(p, mirocup_v1_TeamCommand_desc, idl::team_command));
    side.hellos = need(dds::make_reader(side.subscriber, side.hello_topic, idl::hello));
    side.welcomes = need(dds::make_writer(side.publisher, side.welcome_topic, idl::welcome));
    side.commands = need(dds::make_reader(side.subscriber, side.command_topic, idl::team_command));
    sides_.push_back(std::move(side));
  }
}

void Pitch::hear(Side& side, std::uint32_t tick) {
  mirocup_v1_Hello hello;
  while (dds::take(side.hellos, hello)) {
    side.nonce = hello.nonce;
    const match::Briefing briefing{&field_, &robots_, &rules_, period, side.team, 1};
    const mirocup_v1_Welcome welcome = dds::to_sample(briefing, leg_, hello.nonce);
    dds_write(side.welcomes.get(), &welcome);
  }
  mirocup_v1_TeamCommand command;
  while (dds::take(side.commands, command)) {
    if (side.nonce == 0 || command.nonce != side.nonce || command.tick >= tick) continue;
    ++side.heard;
    side.answered = command.tick;
    side.wheels = dds::to_command(command);
  }
  const std::uint32_t silence = tick - side.answered;
  radio_.send(index_of(side.team), silence > max_silence ? match::Command{} : side.wheels);
}

// True if all teams have answered that tick.
bool Pitch::is_complete(std::uint32_t tick) const {
  for (const Side& side : sides_) {
    if (side.heard == 0 || side.answered < tick) return false;
  }
  return true;
}

void Pitch::show(const Picture& now, const Picture& before, std::uint32_t tick,
                 match::State state) {
  match::Snapshot scene = scene_of(now, before);
  scene.tick = tick;
  scene.time = scene.clock = tick * period;
  scene.state = state;
  mirocup_v1_WorldState sample = dds::to_sample(scene, field_.robots_per_team, leg_);
  for (const Side& side : sides_) {
    sample.heard[index_of(side.team)] = static_cast<std::uint32_t>(side.heard);
  }
  dds_write(states_.get(), &sample);
}

// As on a match server, the answers to one tick are driven in the next. Time stands at tick 0 until
// all teams have answered.
void Pitch::play(double seconds, bool waits) {
  Picture before = camera_.next_picture();
  Picture now = before;
  bool stands = false;
  const auto step =
      std::chrono::duration_cast<WallClock::duration>(std::chrono::duration<double>(period));
  auto due = WallClock::now();
  std::uint32_t tick = 0;
  while (tick * period < seconds) {
    if (!stands || !waits) {
      before = now;
      now = camera_.next_picture();
    }
    show(now, before, tick, tick == 0 ? match::State::READY : match::State::PLAY);
    due = std::max(due + step, WallClock::now());
    std::this_thread::sleep_until(due);
    for (Side& side : sides_) hear(side, tick + 1);
    stands = !is_complete(waits ? tick : 0);
    if (!stands) ++tick;
  }
  for (const Side& side : sides_) radio_.send(index_of(side.team), {});
  show(now, now, tick, match::State::END);
  say_that_it_is_over(tick);
  std::cout << "the ball is at " << now.ball.x << ", " << now.ball.y << '\n';
}

void Pitch::say_that_it_is_over(std::uint32_t tick) {
  mirocup_v1_MatchEvent event{};
  event.layout = mirocup_v1_LAYOUT_NUMBER;
  event.leg = leg_;
  event.tick = tick;
  event.ends_match = true;
  dds::copy_text(event.decision, "MATCH_END");
  dds::copy_text(event.reason, to_string(match::OutcomeKind::full_time));
  dds_write(events_.get(), &event);
  dds_wait_for_acks(events_.get(), DDS_SECS(1));
}

}  // namespace
}  // namespace pitch

int main(int argc, char** argv) {
  const bool waits = argc > 1 && std::string_view(argv[1]) == "--wait";
  if (waits) {
    --argc;
    ++argv;
  }
  if (argc < 4 || argc > 5) {
    std::cerr << "usage: pitch [--wait] MATCH SECONDS BLUE [YELLOW]\n";
    return 2;
  }
  pitch::Table table(mirocup::field::make_field(mirocup::RobotLeague::small), {}, pitch::period);
  pitch::Pitch pitch(argv[1], {argv + 3, argv + argc}, table, table);
  pitch.play(std::atof(argv[2]), waits);
  return 0;
}
