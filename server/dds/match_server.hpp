// SPDX-License-Identifier: MIT
//
// The match server's side of the network: publishes the state of a match, gives seats to the teams
// that join, and receives their commands.
//
// Threads: one. In open mode the server guards against mistakes, not against an attacker on the
// same network. With credentials every process on the network must show a certificate.
#pragma once

#include "server/dds/domain.hpp"
#include "server/dds/liveliness.hpp"
#include "server/dds/seat.hpp"
#include "system/descriptor.hpp"

#include <memory>

namespace mirocup::dds {

class MatchServer {
 public:
  // `interface`, `domain` and `reply` are the arguments of open_server_domain(). `credentials` is
  // the folder of the server's credentials; "" is open mode. Errors are those of
  // open_server_domain(), and Errc::unavailable if another server of this host plays `match_id`.
  static Result<std::unique_ptr<MatchServer>> open(const std::string& match_id,
                                                   const std::string& interface,
                                                   const std::string& credentials,
                                                   int domain = default_domain,
                                                   Reply reply = Reply::to_listed);

  // Announces the match to spectators: team names, the common facts of both briefings, and the
  // factor of real time (0 for lockstep).
  void announce(const match::Briefing& briefing, const match::ByTeam<std::string>& names,
                double speed);

  ~MatchServer();

  // Adds a seat for the team that calls itself `name`. The server owns the seat. Errc::input if the
  // server's own credentials expire before the leg's latest end.
  Result<Seat*> add_seat(const match::Briefing& briefing, const std::string& name,
                         const JoinTerms& terms);

  // Publishes the state at the start of a tick and the decisions since the last call.
  void publish(const match::Leg& match);

  // Receives the samples that have arrived for all seats. If no sample has arrived, waits at most
  // `seconds`. While it waits, sends the state again every 5 ms, or less often if answers take
  // longer, because a team may have missed the state.
  void listen(double seconds);

  // Waits until all seats have answered the tick, or the time of the tick is over, or the absences
  // of the teams end the leg. After this call each seat's collect() returns at once.
  void settle();

  // Returns why the leg must be void, if the host's own network was down for too long.
  std::optional<match::HostFailure> host_failure();

  // Publishes the end of the match and waits, at most 1 s, until all readers have received it.
  void close(const match::Leg& match);

  std::string reach() const;  // as in SeatLink::reach

 private:
  MatchServer(std::string match_id, std::string interface, Domain domain);
  Result<void> open_topics();
  void send_state();
  void look_after_host();
  double resend_after() const;
  Verdict judge_teams(bool all_have_answered);
  void publish_decisions(const match::Leg& match);

  std::string match_id_;
  std::string interface_;
  system::Descriptor claim_;  // of the match ID on this host
  Domain domain_;
  std::uint64_t leg_;
  Entity participant_;
  Entity publisher_, state_topic_, event_topic_, info_topic_;
  Entity state_writer_, event_writer_, info_writer_, waitset_;
  std::vector<std::unique_ptr<Seat>> seats_;
  mirocup_v1_WorldState state_{};
  WallClock::time_point sent_;  // when the state was sent last
  std::size_t events_ = 0;      // number of events already published
  bool is_settled_ = true;      // true: the wait for the present tick is over
  std::optional<ExcusedTime> excused_;
  WallClock::time_point began_ = WallClock::now();
  WallClock::time_point looked_;  // when the server last looked at the host's interface
  bool is_up_ = true;             // true: the host's interface is up
  bool was_up_ = false;           // true: the interface has been up; only then can it be down
  FewWords of_host_{4};
};

}  // namespace mirocup::dds
