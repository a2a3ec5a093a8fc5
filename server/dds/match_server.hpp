// SPDX-License-Identifier: MIT
//
// A match on the network: publishes its state, seats the teams that come, collects their commands.
//
// One thread uses it. Only the process with the nonce of the accepted Hello plays; what others
// write into a team's partition is not taken for it. This is open mode: it keeps mistakes out, not
// an attacker on the same network.
#pragma once

#include "server/dds/convert.hpp"
#include "server/dds/domain.hpp"

#include <functional>
#include <memory>

namespace mirocup::dds {

class MatchServer;

// How long a team may take; seconds of wall time.
struct Patience {
  double to_join = 60.0;
  double tick = 5.0;  // for one answer
  bool is_late_fatal =
      true;  // no answer in time: in lockstep the leg is lost, in real time the team is late
  int most_late_in_a_row = 60;
  std::function<bool()> interrupted = [] { return false; };  // asked while it waits for the join
};

// A team that plays across the network.
class Seat final : public match::Controller {
 public:
  // Waits for a team called `name`.
  tl::expected<void, match::Answer> wait_until_joined(const std::string& name);

  void post(const match::Observation& observation) override;
  match::Answer collect() override;

 private:
  friend class MatchServer;
  Seat(MatchServer& server, const match::Briefing& briefing, const Patience& patience);

  Result<void> open(const Entity& participant, const std::string& match_id);
  void answer_hellos();
  bool has_left() const;

  MatchServer& server_;
  match::Briefing briefing_;
  Patience patience_;
  std::string name_;
  Entity publisher_, subscriber_, hello_topic_, welcome_topic_, command_topic_;
  Entity hello_reader_, welcome_writer_, command_reader_, condition_, waitset_;
  std::uint64_t nonce_ = 0;  // 0: nobody has joined
  std::uint32_t tick_ = 0;
  int late_in_a_row_ = 0;
};

class MatchServer {
 public:
  static Result<std::unique_ptr<MatchServer>> open(const std::string& match_id,
                                                   const std::string& interface);

  // The seat lives as long as the server.
  Result<Seat*> add_seat(const match::Briefing& briefing, const Patience& patience);

  // Publishes the begin of a tick, and the decisions since the last call.
  void publish(const match::Match& match);

  // Sends the last state again: a team may have missed it.
  void repeat();

  // Tells everybody that the match is over, and waits a moment for the news to arrive.
  void close(const match::Match& match);

 private:
  MatchServer(std::string match_id, Domain domain);
  Result<void> open_topics();
  void publish_decisions(const match::Match& match);

  std::string match_id_;
  Domain domain_;
  Entity publisher_, state_topic_, event_topic_, state_writer_, event_writer_;
  std::vector<std::unique_ptr<Seat>> seats_;
  mirocup_v1_WorldState state_{};
  std::size_t events_ = 0;
};

}  // namespace mirocup::dds
