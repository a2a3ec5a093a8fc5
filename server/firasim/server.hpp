// SPDX-License-Identifier: MIT
//
// The interface of a match to teams of FIRASim and VSSReferee: the server sends vision and the
// referee's calls, and receives commands and placements.
//
// Threads: one. The server guards against mistakes and against any content of a datagram, but not
// against an attacker who forges the addresses of datagrams on the same network.
#pragma once

#include "server/firasim/seat.hpp"

#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>

namespace mirocup::firasim {

// Addresses and ports, by default those of FIRASim and VSSReferee.
struct Addresses {
  std::string vision = "224.0.0.1:10002";  // the addresses to send to, separated by commas
  std::string referee = "224.5.23.2:10003";
  std::string command;                         // PORT or ADDRESS:PORT; "": 20011
  std::string placement = "224.5.23.2:10004";  // a multicast group or an address of this host
  std::string interface = this_host;
};

// Returns the addresses of an instance: instance 0 has the ports of Addresses, and instance k > 0
// has the ports 10002 + k for vision, 20011 + k for commands, 40000 + k for the referee and 50000 +
// k for placements, as some clients expect. Addresses in `changes` that are not "" replace
// addresses of the instance.
Result<Addresses> addresses_of(int instance, const Addresses& changes);

// A clock for waiting for a team. The clock stops while the machine is stopped, or is so busy that
// this process does not run, because then the team cannot answer either.
class PatientClock {
 public:
  // Returns seconds since an arbitrary moment. Between two calls the clock advances by at most
  // `most_at_once`, so a caller that waits for a team must call at least that often.
  double now() {
    const Clock::time_point seen = Clock::now();
    const double step = std::chrono::duration<double>(seen - seen_).count();
    seen_ = seen;
    now_ += std::min(step, most_at_once);
    return now_;
  }

  static constexpr double most_at_once = 0.2;  // s

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point seen_ = Clock::now();
  double now_ = 0.0;
};

class Server {
 public:
  static Result<std::unique_ptr<Server>> open(const Addresses& addresses);

  // Adds a seat, which the server owns.
  Seat* add_seat(const match::Briefing& briefing, const std::string& name, const Terms& terms);

  // Sends the leg's first state again and again until the teams of all seats have sent a datagram.
  // The error says why a team can never send.
  tl::expected<void, match::Answer> wait_until_ready(const Seat& seat, const match::Leg& leg);

  // Drops datagrams that have arrived, then sends the vision of the tick that begins and the
  // referee's calls since the last tick.
  void publish(const match::Leg& leg);

  // Sends the referee's call HALT.
  void close(const match::Leg& leg);

  // Counts of datagrams that belong to no seat.
  const Counts& strangers() const { return strangers_; }

 private:
  Server(Sender vision, Sender referee, Receiver commands, Receiver placements);
  // A seat, with separate receivers for the seat's own senders.
  struct Place {
    std::unique_ptr<Seat> seat;
    std::optional<Receiver> commands, placements;
  };

  void settle();
  void end_the_lost(double now);
  void resend();
  bool receive(double now);
  void let_in(const Endpoint& sender, Team team, double now);
  bool has_seat(const Endpoint& sender) const;
  void refuse(const Endpoint& from, const std::string& why);
  bool take_packet(const Receiver::Datagram& datagram, double now);
  bool take_placement(const Receiver::Datagram& datagram, double now);
  bool has_own_line(const Endpoint& placer) const;
  void drain();
  void wait(double seconds) const;
  void call(const match::Leg& leg);
  void send_call(const RefereeCommand& command);
  Place* place_of(Team team);

  PatientClock clock_;
  Sender vision_, referee_;
  Receiver commands_, placements_;
  std::vector<Place> places_;
  std::string sent_vision_, sent_call_;
  std::optional<Foul> called_;
  std::size_t decisions_ = 0;  // number of decisions already sent
  std::uint32_t called_at_ = 0;
  bool is_new_call_ = false;
  bool is_settled_ = true;
  bool was_sent_again_ = false;  // the vision was sent again, so two answers to it may come
  Counts strangers_;
  bool is_only_for_this_host_ = true;  // only this host may send commands
  std::string commands_at_;            // the address that receives commands, for messages
  std::string refused_;                // the sender of the last refused datagram, and the reason
};

}  // namespace mirocup::firasim
