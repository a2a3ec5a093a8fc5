// SPDX-License-Identifier: MIT
//
// The match server's side of the network: publishes the state of a match, gives seats to the teams
// that join, and receives their commands.
//
// Used from one thread. In open mode it guards against mistakes, not against an attacker on the
// same network; with credentials every process on the network must show a certificate.
#pragma once

#include "server/dds/domain.hpp"
#include "server/dds/seat.hpp"

#include <memory>

namespace mirocup::dds {

class MatchServer {
 public:
  // `interface` as for open_server_domain(). `credentials` is the folder of the server's
  // credentials; "" is open mode.
  static Result<std::unique_ptr<MatchServer>> open(const std::string& match_id,
                                                   const std::string& interface,
                                                   const std::string& credentials);

  // Adds a seat for the team that calls itself `name`. The server owns the seat.
  Result<Seat*> add_seat(const match::Briefing& briefing, const std::string& name,
                         const JoinTerms& terms);

  // Publishes the state at the start of a tick and the decisions since the last call.
  void publish(const match::Leg& match);

  // Receives the samples that have arrived for all seats. Waits at most `seconds` if there is none.
  // Sends the state again every 10 ms while it waits, because a team may have missed it.
  void listen(double seconds);

  // Publishes the end of the match and waits, at most 1 s, until all readers have it.
  void close(const match::Leg& match);

  // Returns the last messages of DDS as the end of a sentence; "" if there was none.
  std::string last_error() const;

 private:
  MatchServer(std::string match_id, Domain domain);
  Result<void> open_topics();
  void send_state();
  void publish_decisions(const match::Leg& match);

  std::string match_id_;
  Domain domain_;
  std::uint64_t leg_;
  Entity participant_;
  Entity publisher_, state_topic_, event_topic_, state_writer_, event_writer_, waitset_;
  std::vector<std::unique_ptr<Seat>> seats_;
  mirocup_v2_WorldState state_{};
  WallClock::time_point sent_;  // when the state was sent last
  std::size_t events_ = 0;      // number of events already published
};

}  // namespace mirocup::dds
