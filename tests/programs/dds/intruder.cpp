// SPDX-License-Identifier: MIT
//
// A process that does not belong to a match: intruder KIND MATCH NAME. It does to the blue team
// NAME what any program on the network can do, until it is killed.
//   imitate      writes the team's commands with its nonce; joins again when it receives nothing
//   flood        the same, ten thousand a second
//   hellos       asks for the seat all the time, each time as another process
//   wrong_types  writes other types under the names of the topics
//   stuck        reads everything, and then stops
//   layout       asks for the seat with another layout of v1, and prints the answer
//   unreadable   is the team, but answers with another structure under the name of the type
//   look         reads states
//   watch        prints what spectators are told, after the first state of the leg
//   configured   the same, configured by $CYCLONEDDS_URI alone
//   other        writes states of v2, as a server of that version does
#include "server/dds/convert.hpp"
#include "server/dds/domain.hpp"
#include "server/dds/nonce.hpp"
#include "server/dds/wall_time.hpp"

#include <csignal>
#include <cstdlib>
#include <iostream>
#include <utility>

namespace mirocup::dds {
namespace {

// Returns the value, or ends the program with the error. Not by std::exit(), which would destroy
// objects that Cyclone's threads still use.
template <typename T>
T need(Result<T> made) {
  if (made) return std::move(*made);
  std::cerr << made.error().what << '\n';
  std::_Exit(1);
}

constexpr double max_silence = 1.0;  // s

// One participant on the network.
struct Stranger {
  Stranger(const Domain& domain, const std::string& match_id, const std::string& name) {
    participant = need(make_participant(domain));
    all = need(make_subscriber(participant, match_partition(match_id)));
    const std::string own = team_partition(match_id, 0, name);
    team = need(make_subscriber(participant, own));
    publisher = need(make_publisher(participant, own));
    states = need(make_topic(participant, mirocup_v1_WorldState_desc, idl::world_state));
    events = need(make_topic(participant, mirocup_v1_MatchEvent_desc, idl::match_event));
    state_reader = need(make_reader(all, states, idl::world_state));
    event_reader = need(make_reader(all, events, idl::match_event));
  }

  void wait_for_match() {
    while (!take_state()) dds_sleepfor(DDS_MSECS(1));
    std::cerr << "there\n";
  }

  bool take_state() {
    if (!take(state_reader, state)) return false;
    heard = WallClock::now();
    return true;
  }

  // Changed packets, its own or another process's, can cut it off from the match.
  bool is_cut_off() const { return seconds_since(heard) > max_silence; }

  mirocup_v1_WorldState state{};
  WallClock::time_point heard = WallClock::now();
  Entity participant, all, team, publisher, states, events, state_reader, event_reader;
};

// Acts for as long as it receives samples of the match.
void imitate(Stranger& s, int copies) {
  const Entity commands =
      need(make_topic(s.participant, mirocup_v1_TeamCommand_desc, idl::team_command));
  const Entity welcomes = need(make_topic(s.participant, mirocup_v1_Welcome_desc, idl::welcome));
  const Entity writer = need(make_writer(s.publisher, commands, idl::team_command));
  const Entity reader = need(make_reader(s.team, welcomes, idl::welcome));
  mirocup_v1_TeamCommand command{};
  for (double& wheel : command.left) wheel = 40.0;
  for (double& wheel : command.right) wheel = -40.0;
  bool is_there = false;
  while (!s.is_cut_off()) {
    mirocup_v1_Welcome welcome;
    while (take(reader, welcome)) command.nonce = welcome.nonce;
    if (s.take_state()) {
      command.tick = s.state.tick;
      if (!std::exchange(is_there, true)) std::cerr << "there\n";
    }
    for (int i = 0; i < copies; ++i) dds_write(writer.get(), &command);
    dds_sleepfor(copies == 1 ? DDS_USECS(50) : DDS_MSECS(1));
  }
}

void say_hellos(Stranger& s, const char* name) {
  const Entity topic = need(make_topic(s.participant, mirocup_v1_Hello_desc, idl::hello));
  const Entity writer = need(make_writer(s.publisher, topic, idl::hello));
  s.wait_for_match();
  mirocup_v1_Hello hello{};
  hello.layout = mirocup_v1_LAYOUT_NUMBER;
  copy_text(hello.name, std::string(name) + " or not");
  while (true) {
    hello.nonce = random_nonce();
    dds_write(writer.get(), &hello);
    dds_sleepfor(DDS_USECS(200));
  }
}

void write_wrong_types(Stranger& s) {
  idl::TopicQos row = idl::team_command;
  const Entity commands = need(make_topic(s.participant, mirocup_v1_Hello_desc, row));
  const Entity writer = need(make_writer(s.publisher, commands, row));
  row = idl::hello;
  const Entity hellos = need(make_topic(s.participant, mirocup_v1_TeamCommand_desc, row));
  const Entity other = need(make_writer(s.publisher, hellos, row));
  s.wait_for_match();
  const mirocup_v1_Hello hello{};
  const mirocup_v1_TeamCommand command{};
  while (true) {
    dds_write(writer.get(), &hello);
    dds_write(other.get(), &command);
    dds_sleepfor(DDS_USECS(200));
  }
}

// Writes the Hello until there is a Welcome, and prints the reason in it.
int ask_with_other_layout(Stranger& s, const char* name) {
  mirocup_v1_Hello hello{};
  hello.layout = mirocup_v1_LAYOUT_NUMBER + 1;
  hello.nonce = random_nonce();
  copy_text(hello.name, name);
  const Entity hellos = need(make_topic(s.participant, mirocup_v1_Hello_desc, idl::hello));
  const Entity welcomes = need(make_topic(s.participant, mirocup_v1_Welcome_desc, idl::welcome));
  const Entity writer = need(make_writer(s.publisher, hellos, idl::hello));
  const Entity reader = need(make_reader(s.team, welcomes, idl::welcome));
  mirocup_v1_Welcome welcome;
  while (!take(reader, welcome) || welcome.nonce != hello.nonce) {
    dds_write(writer.get(), &hello);
    dds_sleepfor(DDS_MSECS(20));
  }
  std::cout << static_cast<int>(welcome.answer) << ' ' << welcome.reason << '\n';
  return 0;
}

int answer_unreadably(Stranger& s, const char* name) {
  dds_topic_descriptor_t type = mirocup_v1_Hello_desc;
  type.m_typename = mirocup_v1_TeamCommand_desc.m_typename;
  const Entity hellos = need(make_topic(s.participant, mirocup_v1_Hello_desc, idl::hello));
  const Entity commands = need(make_topic(s.participant, type, idl::team_command));
  const Entity asks = need(make_writer(s.publisher, hellos, idl::hello));
  const Entity answers = need(make_writer(s.publisher, commands, idl::team_command));
  mirocup_v1_Hello hello{};
  hello.layout = mirocup_v1_LAYOUT_NUMBER;
  hello.nonce = random_nonce();
  copy_text(hello.name, name);
  while (true) {
    dds_write(asks.get(), &hello);
    dds_write(answers.get(), &hello);
    dds_sleepfor(DDS_MSECS(20));
  }
}

int print_info(Stranger& s) {
  const Entity topic = need(make_topic(s.participant, mirocup_v1_MatchInfo_desc, idl::match_info));
  const Entity reader = need(make_reader(s.all, topic, idl::match_info));
  s.wait_for_match();
  mirocup_v1_MatchInfo info;
  while (!take(reader, info)) dds_sleepfor(DDS_MSECS(1));
  std::cout << info.blue << " - " << info.yellow << ", league " << int{info.facts.league} << ", "
            << int{info.facts.robots} << " robots, period " << info.facts.control_period
            << ", speed " << info.speed << ", field " << info.facts.half_length << ", same leg "
            << (info.leg == s.state.leg) << '\n';
  return 0;
}

// The states of v2 are known by their name alone here: any structure will do.
int write_former_states(const char* match_id) {
  const Domain domain = need(open_server_domain("lo", ""));
  const Entity participant = need(make_participant(domain));
  const Entity publisher = need(make_publisher(participant, match_partition(match_id)));
  dds_topic_descriptor_t type = mirocup_v1_WorldState_desc;
  type.m_typename = "mirocup::v2::WorldState";
  const Entity topic = need(make_topic(participant, type, idl::world_state));
  const Entity writer = need(make_writer(publisher, topic, idl::world_state));
  const mirocup_v1_WorldState state{};
  while (dds_write(writer.get(), &state) == DDS_RETCODE_OK) dds_sleepfor(DDS_MSECS(10));
  return 0;
}

int run(const std::string& kind, const char* match_id, const char* name, const char* credentials) {
  if (kind == "other") return write_former_states(match_id);
  const Domain domain =
      kind == "configured"
          ? Domain{.log = std::make_unique<CycloneLog>(), .domain = {}, .credentials = {}}
          : need(open_team_domain("127.0.0.1", credentials));
  while (kind == "imitate" || kind == "flood") {
    Stranger stranger(domain, match_id, name);
    imitate(stranger, kind == "flood" ? 10 : 1);
  }
  Stranger stranger(domain, match_id, name);
  if (kind == "hellos") say_hellos(stranger, name);
  if (kind == "wrong_types") write_wrong_types(stranger);
  if (kind == "unreadable") return answer_unreadably(stranger, name);
  if (kind == "layout") return ask_with_other_layout(stranger, name);
  if (kind == "watch" || kind == "configured") return print_info(stranger);
  while (kind == "look") stranger.wait_for_match();
  if (kind != "stuck") return 2;
  stranger.wait_for_match();
  return raise(SIGSTOP);
}

}  // namespace
}  // namespace mirocup::dds

int main(int argc, char** argv) {
  if (argc < 4) return 2;
  return mirocup::dds::run(argv[1], argv[2], argv[3], argc > 4 ? argv[4] : "");
}
