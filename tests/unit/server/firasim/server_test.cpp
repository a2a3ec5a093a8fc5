// SPDX-License-Identifier: MIT
#include "server/firasim/server.hpp"

#include <gtest/gtest.h>

#include <arpa/inet.h>
#include <array>
#include <atomic>
#include <bit>
#include <chrono>
#include <netinet/in.h>
#include <sys/socket.h>
#include <thread>

namespace mirocup::firasim {
namespace {

// A socket of this host, as a client has one.
class Peer {
 public:
  explicit Peer(std::uint32_t address = INADDR_LOOPBACK)
      : socket_(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {
    sockaddr_in any = at(0);
    any.sin_addr.s_addr = htonl(address);
    if (bind(socket_.get(), reinterpret_cast<const sockaddr*>(&any), sizeof any) != 0) abort();
  }
  int port() const {
    sockaddr_in own{};
    socklen_t length = sizeof own;
    getsockname(socket_.get(), reinterpret_cast<sockaddr*>(&own), &length);
    return ntohs(own.sin_port);
  }
  void send(const std::string& bytes, int port) const {
    const sockaddr_in to = at(port);
    sendto(socket_.get(), bytes.data(), bytes.size(), 0, reinterpret_cast<const sockaddr*>(&to),
           sizeof to);
  }

 private:
  static sockaddr_in at(int port) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    return address;
  }
  system::Descriptor socket_;
};

void add_real(std::string& bytes, int tag, double value) {
  bytes.push_back(static_cast<char>(tag));
  for (int i = 0; i < 8; ++i) {
    bytes.push_back(static_cast<char>(std::bit_cast<std::uint64_t>(value) >> (8 * i) & 0xff));
  }
}

void add_message(std::string& bytes, int tag, const std::string& inner) {
  bytes.push_back(static_cast<char>(tag));
  bytes.push_back(static_cast<char>(inner.size()));
  bytes += inner;
}

std::string number(int tag, int value) {
  return {static_cast<char>(tag), static_cast<char>(value)};
}

// The same wheels for robots of a team, in one packet without a step.
std::string drive(Team team, const std::vector<int>& robots, double left, double right) {
  std::string commands, packet;
  for (const int i : robots) {
    std::string robot = number(0x08, i) + number(0x10, team == Team::yellow ? 1 : 0);
    add_real(robot, 0x31, left);
    add_real(robot, 0x39, right);
    add_message(commands, 0x0A, robot);
  }
  add_message(packet, 0x0A, commands);
  return packet;
}

std::string drive_all(Team team, double left, double right) {
  return drive(team, {0, 1, 2}, left, right);
}

// Robot 1 at (x, y).
std::string place_one(Team team, double x, double y) {
  std::string robot = number(0x08, 1), placement;
  add_real(robot, 0x11, x);
  add_real(robot, 0x19, y);
  std::string world = number(0x08, team == Team::yellow ? 1 : 0);
  add_message(world, 0x12, robot);
  add_message(placement, 0x0A, world);
  return placement;
}

// A match without a team yet.
class FirasimMatch : public ::testing::Test {
 protected:
  FirasimMatch() {
    match::Setup setup;
    setup.rules = referee::make_rules(referee::Preset::vsss);
    setup.rules.ready_s = 0.33;
    leg_ = std::make_unique<match::Leg>(setup);
    {
      const Peer first, second;  // ports that are free
      commands_ = first.port();
      placements_ = second.port();
    }
    auto server = Server::open({.vision = "127.0.0.1:" + std::to_string(sink_.port()),
                                .referee = "127.0.0.1:" + std::to_string(sink_.port()),
                                .command = std::to_string(commands_),
                                .placement = "127.0.0.1:" + std::to_string(placements_),
                                .interface = this_host});
    if (!server) throw std::runtime_error(server.error().what);
    server_ = std::move(*server);
  }

  match::Observation seen_by(Team team) const {
    return match::observe(leg_->view(), team, leg_->field().robots_per_team);
  }

  // Plays on until `holds` for what blue sees.
  template <class F>
  void play_until(F holds) {
    while (!holds(seen_by(Team::blue))) leg_->advance({match::Command{}, match::Command{}});
  }
  void play_until_the_whistle() {
    play_until([](const auto& now) { return now.state == match::State::PLAY; });
  }

  Peer team_, stranger_, sink_;
  int commands_ = 0, placements_ = 0;
  std::unique_ptr<match::Leg> leg_;
  std::unique_ptr<Server> server_;
};

// A match in lock-step with blue at the other end of a wire, and yellow standing still.
class FirasimServer : public FirasimMatch {
 protected:
  explicit FirasimServer(bool has_any_port = false) {
    Terms terms;
    terms.away = 2.0;
    terms.longest = 3.0;
    terms.has_any_port = has_any_port;
    seat_ = server_->add_seat(leg_->briefing(Team::blue), "blue", terms);
    team_.send(drive_all(Team::blue, 1.0, 1.0), commands_);
    if (!server_->wait_until_ready(*seat_, *leg_)) throw std::runtime_error("no team");
  }

  void ask() {
    server_->publish(*leg_);
    seat_->post(seen_by(Team::blue));
  }
  void ask_in_play() {
    play_until_the_whistle();
    ask();
  }
  // The wheels of robot 1 in the answer to what was asked, and what they should be.
  void expect_wheels(double left, double right) {
    const match::Answer answer = seat_->collect();
    const auto* command = std::get_if<match::Command>(&answer);
    ASSERT_NE(command, nullptr) << "nothing came";
    const auto wanted = to_wheels(left, right, leg_->setup().parameters);
    EXPECT_EQ(command->wheels[1].left, wanted.left);
    EXPECT_EQ(command->wheels[1].right, wanted.right);
  }

  Seat* seat_ = nullptr;
};

// Catches one buffer for all senders: a flood then fills it, the team's commands are lost, and when
// it has been silent for long enough the stranger has its seat.
TEST_F(FirasimServer, AFloodCrowdsOutNoTeam) {
  ask_in_play();
  for (int i = 0; i < 20000; ++i) {
    stranger_.send(drive_all(i % 2 == 0 ? Team::blue : Team::yellow, -50.0, 50.0), commands_);
    stranger_.send("noise", placements_);
  }
  team_.send(drive_all(Team::blue, 20.0, 30.0), commands_);
  expect_wheels(20.0, 30.0);
  EXPECT_EQ(seat_->counts().senders, 1);
  EXPECT_EQ(seat_->counts().foreign, 0U);
  EXPECT_GT(server_->strangers().foreign + server_->strangers().malformed, 0U);
}

// Catches a program that loses its placements because they leave its host by another interface than
// its commands, and so come from another address of the same host.
TEST_F(FirasimServer, PlacementsMayComeFromAnotherAddressOfTheHost) {
  const Peer placer(0x7f000002);
  play_until([](const auto& now) { return now.placing; });
  for (const double x : {-0.5, -0.6}) {
    team_.send(drive_all(Team::blue, 0.0, 0.0), commands_);
    ask();
    placer.send(place_one(Team::blue, x, 0.1), placements_);
    team_.send(drive_all(Team::blue, 0.0, 0.0), commands_);
    ASSERT_TRUE(std::holds_alternative<match::Command>(seat_->collect()));
  }
  EXPECT_EQ(seat_->counts().placements, 2U);
  EXPECT_EQ(seat_->counts().foreign, 0U);
}

// Catches a command to an earlier vision that is taken for the answer to the next one, which is how
// a client without a step in its packets falls behind by a tick and stays there.
TEST_F(FirasimServer, StaleCommandsAreDrainedBeforeEachVision) {
  ask_in_play();
  team_.send(drive_all(Team::blue, 10.0, 20.0), commands_);
  team_.send(drive_all(Team::blue, 1.0, 2.0), commands_);  // doubled: the first one counts
  expect_wheels(10.0, 20.0);
  EXPECT_EQ(seat_->counts().stale, 1U);
  team_.send(drive_all(Team::blue, 3.0, 4.0), commands_);  // too late
  ask();
  EXPECT_EQ(seat_->counts().stale, 2U);
  team_.send(drive_all(Team::blue, 30.0, 40.0), commands_);
  expect_wheels(30.0, 40.0);
}

// Catches a colour that one who steers the other colour can steer.
TEST_F(FirasimServer, AColourBelongsToItsSender) {
  ask_in_play();
  team_.send(drive_all(Team::yellow, 50.0, 50.0), commands_);
  stranger_.send(drive_all(Team::blue, 50.0, 50.0), commands_);
  team_.send(drive_all(Team::blue, 5.0, 6.0), commands_);
  expect_wheels(5.0, 6.0);
  EXPECT_EQ(seat_->counts().foreign, 3U);  // one for each robot that is not its own
  EXPECT_EQ(server_->strangers().foreign, 1U);
}

// A client that opens a socket for each datagram: all its commands but the first were a stranger's.
class FirasimSockets : public FirasimServer {
 protected:
  FirasimSockets() : FirasimServer(true) {}
};

TEST_F(FirasimSockets, MayBeNewForEachDatagramWhereNobodyElseIs) {
  play_until_the_whistle();
  for (int i = 0; i < 20; ++i) {
    ask();
    Peer().send(drive_all(Team::blue, i, 6.0), commands_);
    expect_wheels(i, 6.0);
  }
  EXPECT_EQ(server_->strangers().foreign, 0U);
}

// A lock-step leg had no end: each new sender began a new silence.
TEST_F(FirasimServer, EndsWhereEachCommandComesFromANewSocketOrMuchTooLate) {
  play_until_the_whistle();
  const match::Fault* fault = nullptr;
  match::Answer answer;
  for (int i = 0; i < 8 && fault == nullptr; ++i) {
    ask();
    std::thread late([&] {
      std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // more than half of `away`
      Peer().send(drive_all(Team::blue, 5.0, 6.0), commands_);
    });
    answer = seat_->collect();
    late.join();
    fault = std::get_if<match::Fault>(&answer);
  }
  ASSERT_NE(fault, nullptr);
  EXPECT_TRUE(
      fault->text.starts_with("the match has waited 3 s for the team in all, which gave ") &&
      fault->text.ends_with(" answers; without lock-step a match does not wait"))
      << fault->text;
}

// A match that two programs or one may play.
class FirasimSeats : public FirasimMatch {
 protected:
  FirasimSeats() {
    Terms terms;
    terms.to_join = 0.5;
    terms.away = 0.5;
    for (const Team team : both_teams) {
      seats_[index_of(team)] = server_->add_seat(leg_->briefing(team), "it", terms);
    }
  }

  std::string reason(Team team) {
    const auto ready = server_->wait_until_ready(*seats_[index_of(team)], *leg_);
    return ready ? "" : std::get<match::Fault>(ready.error()).text;
  }

  match::ByTeam<Seat*> seats_;
};

// Catches a program that steers both colours from one socket, which loses the second one, and a
// stranger that then gets one of them.
TEST_F(FirasimSeats, OneSocketMaySteerBothColours) {
  const auto drives = [&](double wheels) {
    std::string both = drive_all(Team::yellow, wheels, wheels);
    both += drive_all(Team::blue, wheels, wheels);  // messages of protobuf are merged so
    team_.send(both, commands_);
  };
  drives(1.0);
  for (const Team team : both_teams) EXPECT_EQ(reason(team), "");
  play_until_the_whistle();
  server_->publish(*leg_);
  for (const Team team : both_teams) seats_[index_of(team)]->post(seen_by(team));
  stranger_.send(drive_all(Team::yellow, 9.0, 9.0), commands_);
  drives(2.0);
  for (const Team team : both_teams) {
    const match::Answer answer = seats_[index_of(team)]->collect();
    const auto wanted = to_wheels(2.0, 2.0, leg_->setup().parameters);
    EXPECT_EQ(std::get<match::Command>(answer).wheels[2].left, wanted.left);
    EXPECT_EQ(seats_[index_of(team)]->counts().foreign, 0U);
    EXPECT_EQ(seats_[index_of(team)]->counts().senders, 1);
  }
  EXPECT_EQ(server_->strangers().foreign, 1U);
}

// Catches commands to the group of all hosts that FIRASim hears and nobody does here.
TEST_F(FirasimSeats, CommandsMayComeByTheGroup) {
  const auto group = Sender::open({{0xe0000001, static_cast<std::uint16_t>(commands_)}}, this_host);
  ASSERT_TRUE(group);
  group->send(drive_all(Team::blue, 1.0, 1.0));
  EXPECT_EQ(reason(Team::blue), "");
  EXPECT_EQ(seats_[index_of(Team::blue)]->counts().received, 1U);
}

// Catches a forfeit whose reason is not the true one: something came, and was not taken.
TEST_F(FirasimSeats, ARefusalSaysWhatCame) {
  team_.send(drive_all(Team::blue, 1.0, 1.0), commands_);
  EXPECT_EQ(reason(Team::blue), "");
  stranger_.send(drive_all(Team::blue, 1.0, 1.0), commands_);
  EXPECT_NE(reason(Team::yellow)
                .find("127.0.0.1:" + std::to_string(stranger_.port()) +
                      " sent commands for blue, which another socket steers"),
            std::string::npos);
  stranger_.send("noise", commands_);
  EXPECT_NE(reason(Team::yellow).find("not a Packet"), std::string::npos);
  stranger_.send(place_one(Team::yellow, 0.3, 0.0), placements_);
  EXPECT_EQ(reason(Team::yellow), "");
  EXPECT_NE(seats_[index_of(Team::yellow)]->disconnected("port 1").text.find("no command came"),
            std::string::npos);
  EXPECT_TRUE(is_of_this_host({0x7f000102, 1}));
  EXPECT_FALSE(is_of_this_host({0xc0000201, 1}));  // 192.0.2.1 is nobody's
}

// Catches a team that is taken for one which leaves robots out because the machine was slow between
// its datagrams: it would drive in another tick, and the leg would be another one.
TEST_F(FirasimServer, ATeamMayBeSlowBetweenItsDatagrams) {
  ask_in_play();
  team_.send(drive(Team::blue, {0}, 7.0, 8.0), commands_);
  std::thread slow([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(900));
    team_.send(drive(Team::blue, {1, 2}, 7.0, 8.0), commands_);
  });
  expect_wheels(7.0, 8.0);
  slow.join();
  EXPECT_EQ(seat_->counts().held, 0U);
}

// Catches a leg that waits for ever for robots that a team never commands.
TEST_F(FirasimServer, ATeamMayLeaveRobotsOut) {
  ask_in_play();
  const auto answer = [&] { team_.send(drive(Team::blue, {1}, 3.0, 4.0), commands_); };
  for (int i = 0; i < 3; ++i) answer();  // to the vision and to two copies of it
  EXPECT_TRUE(std::holds_alternative<match::Late>(seat_->collect()));
  ask();
  answer();
  expect_wheels(3.0, 4.0);
}

// Catches a team that speaks without answering, and so holds up each tick of the leg.
TEST_F(FirasimServer, ATeamThatAnswersNothingHasLost) {
  ask_in_play();
  std::atomic<bool> is_over = false;
  std::thread talks([&] {
    std::string late = drive_all(Team::blue, 9.0, 9.0);
    late += std::string("\x78\x7f", 2);  // 15: step 127
    while (!is_over) {
      team_.send(late, commands_);
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
  });
  const match::Answer answer = seat_->collect();
  is_over = true;
  talks.join();
  const auto* fault = std::get_if<match::Fault>(&answer);
  ASSERT_NE(fault, nullptr);
  EXPECT_EQ(fault->code, match::FaultCode::disconnected);
}

// Catches patience that runs out while the machine stands still: teams that could not answer were
// then forfeited, or their placements overlooked.
TEST(FirasimPatience, StandsStillWithTheMachine) {
  PatientClock clock;
  const double before = clock.now();
  std::this_thread::sleep_for(std::chrono::milliseconds(700));
  EXPECT_LE(clock.now() - before, PatientClock::most_at_once);
  const double after = clock.now();
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  EXPECT_GE(clock.now() - after, 0.05);
}

// Catches a second match on the same port: half of the commands would go to the wrong one.
TEST_F(FirasimServer, AnAddressIsOneMatchs) {
  const auto second = Server::open({.vision = "127.0.0.1:9",
                                    .referee = "127.0.0.1:9",
                                    .command = std::to_string(commands_),
                                    .placement = "224.5.23.2:50001",
                                    .interface = this_host});
  ASSERT_FALSE(second);
  EXPECT_EQ(second.error().code, Errc::unavailable);
}

}  // namespace
}  // namespace mirocup::firasim
