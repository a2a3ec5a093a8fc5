// SPDX-License-Identifier: MIT
//
// A client of FIRASim in the manner of the teams' own: libprotobuf, blocking multicast sockets, one
// datagram for each robot, no echo of the step. It checks what it receives and plays a simple game.
//
// client blue|yellow INSTANCE [busy]: ends with 0 at HALT; 1 if something received is wrong, or if
// its robots do not stand where it placed them for a kick-off; 2 after 20 s of silence. A busy one
// asks its sockets again and again instead of waiting for them.
#include "vsss.pb.h"

#include <arpa/inet.h>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <netinet/in.h>
#include <poll.h>
#include <string>
#include <sys/socket.h>

namespace {

sockaddr_in address_of(const char* address, int port) {
  sockaddr_in to{};
  to.sin_family = AF_INET;
  to.sin_port = htons(static_cast<std::uint16_t>(port));
  inet_pton(AF_INET, address, &to.sin_addr);
  return to;
}

int listener(const char* group, int port) {
  const int socket = ::socket(AF_INET, SOCK_DGRAM, 0);
  const int on = 1;
  setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
  const sockaddr_in at = address_of(group, port);
  bind(socket, reinterpret_cast<const sockaddr*>(&at), sizeof at);
  ip_mreq request{};
  request.imr_multiaddr = at.sin_addr;
  request.imr_interface.s_addr = htonl(INADDR_LOOPBACK);
  setsockopt(socket, IPPROTO_IP, IP_ADD_MEMBERSHIP, &request, sizeof request);
  return socket;
}

bool receive(int socket, std::string& bytes) {
  char buffer[2048];
  const ssize_t size = recv(socket, buffer, sizeof buffer, MSG_DONTWAIT);
  if (size < 0) return false;
  bytes.assign(buffer, static_cast<std::size_t>(size));
  return true;
}

// Where it places its three robots, for the team on the right.
constexpr double own_x[3] = {0.69, 0.3, 0.3};
constexpr double own_y[3] = {0.0, 0.2, -0.2};

class Client {
 public:
  Client(bool is_yellow, int instance, bool is_busy)
      : is_yellow_(is_yellow),
        is_busy_(is_busy),
        vision_(listener("224.0.0.1", 10002 + instance)),
        referee_(listener("224.5.23.2", (instance == 0 ? 10003 : 40000 + instance))),
        out_(::socket(AF_INET, SOCK_DGRAM, 0)),
        command_(address_of("127.0.0.1", 20011 + instance)),
        placement_(address_of("224.5.23.2", instance == 0 ? 10004 : 50000 + instance)) {
    const in_addr lo{htonl(INADDR_LOOPBACK)};
    setsockopt(out_, IPPROTO_IP, IP_MULTICAST_IF, &lo, sizeof lo);
  }

  int play() {
    while (wait()) {
      std::string bytes;
      while (receive(referee_, bytes)) {
        vsss::RefereeCommand call;
        if (!call.ParseFromString(bytes)) return wrong("a call that protobuf cannot read");
        if (call.foul() == vsss::HALT) return 0;
        if (call.foul() == vsss::KICKOFF) kicks_off_ = true;
        if (call.foul() != vsss::GAME_ON && call.foul() != vsss::STOP) place();
        is_new_ = call.foul() == vsss::GAME_ON;
        is_on_ = call.foul() == vsss::GAME_ON;
      }
      // The newest is answered after the others, so that no call which comes with the answer's
      // own vision is overlooked.
      if (is_new_vision(bytes)) {
        vsss::Environment seen;
        if (!seen.ParseFromString(bytes)) return wrong("a vision that protobuf cannot read");
        if (!is_right(seen)) return wrong(seen.ShortDebugString().c_str());
        if (is_new_ && kicks_off_ && !stands_as_asked(seen)) return wrong("its robots elsewhere");
        if (is_new_) kicks_off_ = is_new_ = false;
        answer(seen);
      }
    }
    return 2;
  }

 private:
  int wrong(const char* what) {
    std::fprintf(stderr, "client: wrong: %s\n", what);
    return 1;
  }

  // Reads all visions that have come; true if there was one, and then `bytes` is the newest.
  bool is_new_vision(std::string& bytes) const {
    bool any = false;
    while (receive(vision_, bytes)) any = true;
    return any;
  }

  // Returns false after 20 s without a datagram.
  bool wait() const {
    using Clock = std::chrono::steady_clock;
    pollfd sockets[2] = {{vision_, POLLIN, 0}, {referee_, POLLIN, 0}};
    if (!is_busy_) return poll(sockets, 2, 20000) > 0;
    for (const auto begun = Clock::now(); Clock::now() - begun < std::chrono::seconds(20);) {
      if (poll(sockets, 2, 0) > 0) return true;
    }
    return false;
  }

  // Hands that put robots down miss by a few millimetres.
  bool stands_as_asked(const vsss::Environment& seen) const {
    const auto& own = is_yellow_ ? seen.frame().robots_yellow() : seen.frame().robots_blue();
    for (int i = 0; i < 3; ++i) {
      const double x = (is_yellow_ ? 1.0 : -1.0) * own_x[i];
      if (std::hypot(own.Get(i).x() - x, own.Get(i).y() - own_y[i]) > 0.02) return false;
    }
    return true;
  }

  // All robots in order, inside the walls, with a field around them.
  bool is_right(const vsss::Environment& seen) const {
    const auto& field = seen.field();
    if (field.length() < 1.0 || field.width() < 1.0 || field.goal_width() <= 0.0) return false;
    if (std::abs(seen.frame().ball().x()) > field.length()) return false;
    if (seen.frame().robots_blue_size() != seen.frame().robots_yellow_size()) return false;
    for (const auto* robots : {&seen.frame().robots_blue(), &seen.frame().robots_yellow()}) {
      for (int i = 0; i < robots->size(); ++i) {
        const vsss::Robot& robot = robots->Get(i);
        if (static_cast<int>(robot.robot_id()) != i) return false;
        if (std::abs(robot.x()) > field.length() || std::abs(robot.orientation()) > 3.1416) {
          return false;
        }
      }
    }
    return true;
  }

  void place() {
    vsss::Placement placement;
    auto* world = placement.mutable_world();
    world->set_teamcolor(is_yellow_ ? vsss::YELLOW : vsss::BLUE);
    const double side = is_yellow_ ? 1.0 : -1.0;  // of the own goal
    for (int i = 0; i < 3; ++i) {
      auto* robot = world->add_robots();
      robot->set_robot_id(static_cast<std::uint32_t>(i));
      robot->set_x(side * own_x[i]);
      robot->set_y(own_y[i]);
      robot->set_orientation(is_yellow_ ? 180.0 : 0.0);
    }
    send(placement.SerializeAsString(), placement_);
  }

  void answer(const vsss::Environment& seen) {
    const auto& own = is_yellow_ ? seen.frame().robots_yellow() : seen.frame().robots_blue();
    for (const vsss::Robot& robot : own) {
      vsss::Packet packet;
      auto* command = packet.mutable_cmd()->add_robot_commands();
      command->set_id(robot.robot_id());
      command->set_yellowteam(is_yellow_);
      if (is_on_ && robot.robot_id() != 0) {
        const double dx = seen.frame().ball().x() - robot.x();
        const double dy = seen.frame().ball().y() - robot.y();
        double error = std::atan2(dy, dx) - robot.orientation();
        error = std::atan2(std::sin(error), std::cos(error));
        const double speed = 40.0 * std::cos(error);
        const double turn = 15.0 * (std::cos(error) > 0.0 ? error : -error);
        command->set_wheel_left(speed - turn);
        command->set_wheel_right(speed + turn);
      }
      send(packet.SerializeAsString(), command_);
    }
  }

  void send(const std::string& bytes, const sockaddr_in& to) const {
    sendto(out_, bytes.data(), bytes.size(), 0, reinterpret_cast<const sockaddr*>(&to), sizeof to);
  }

  bool is_yellow_, is_busy_, is_on_ = false;
  bool kicks_off_ = false, is_new_ = false;  // the last call but GAME_ON; since the last vision
  int vision_, referee_, out_;
  sockaddr_in command_, placement_;
};

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) return 2;
  const bool is_busy = argc > 3 && std::strcmp(argv[3], "busy") == 0;
  return Client(std::strcmp(argv[1], "yellow") == 0, std::atoi(argv[2]), is_busy).play();
}
