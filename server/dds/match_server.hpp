// SPDX-License-Identifier: MIT
//
// A match on the network: publishes its state, seats the teams that come, collects their commands.
//
// One thread uses it. In open mode it keeps mistakes out, not an attacker on the same network; with
// credentials everybody on the network must show a certificate.
#pragma once

#include "server/dds/domain.hpp"
#include "server/dds/seat.hpp"

#include <memory>

namespace mirocup::dds {

class MatchServer {
 public:
  // `credentials`: the folder of the server's, "": open mode.
  static Result<std::unique_ptr<MatchServer>> open(const std::string& match_id,
                                                   const std::string& interface,
                                                   const std::string& credentials);

  // For the team that calls itself `name`. The seat lives as long as the server.
  Result<Seat*> add_seat(const match::Briefing& briefing, const std::string& name,
                         const Patience& patience);

  // Publishes the begin of a tick, and the decisions since the last call.
  void publish(const match::Leg& match);

  // Takes in what has arrived for all seats, after at most `seconds` if there is nothing yet. Sends
  // the state again from time to time: a team may have missed it.
  void listen(double seconds);

  // Tells everybody that the match is over, and waits a moment for the news to arrive.
  void close(const match::Leg& match);

  std::uint64_t leg() const { return leg_; }

  // What DDS complained about last, as the end of a sentence; "" if it did not.
  std::string last_words() const;

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
  Clock::time_point sent_;  // the state, last
  std::size_t events_ = 0;
};

}  // namespace mirocup::dds
