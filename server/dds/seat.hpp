// SPDX-License-Identifier: MIT
//
// The seat of one team in a match on the network: the process that has it, and its answers.
//
// A seat belongs to the process that was accepted into it. That process is known by the key that
// DDS gives to every participant and by the nonce that it drew. Commands that other processes write
// in the team's name are counted and thrown away. Another process of the same team name may take
// the seat only while the first one is away.
//
// A seat is part of a MatchServer and is used from its thread.
#pragma once

#include "server/dds/convert.hpp"
#include "server/dds/entity.hpp"
#include "server/dds/inbox.hpp"
#include "server/dds/liveliness.hpp"
#include "server/dds/wall_time.hpp"
#include "server/pace/durations.hpp"

#include <functional>
#include <string>

namespace mirocup::dds {

// The terms on which a team joins and stays in a match; seconds of wall time.
struct JoinTerms {
  double to_join = 60.0;  // from the making of the seat to the team's first answer
  // The time in which a tick must be answered (real time). Nothing: the match waits (lockstep).
  std::optional<double> tick;
  double notice = 1.0;  // a team that is silent for this long is away
  double away = 10.0;   // how long a team may be away in a leg, all absences together
  std::function<bool()> interrupted = [] { return false; };     // called while the seat waits
  std::function<void(const std::string&)> tell = [](auto&) {};  // gets a sentence for the host
};

// The services of a match server that its seats use.
struct SeatLink {
  std::uint64_t leg = 0;                       // the number of the server's leg
  std::function<void(double seconds)> listen;  // receives for all seats; waits at most `seconds`
  std::function<std::string()> last_error;     // the last messages of DDS, as the end of a sentence
};

class Seat final : public match::Controller {
 public:
  Seat(SeatLink link, const match::Briefing& briefing, std::string name, const JoinTerms& terms);

  // Makes the seat's topics, readers and writers; `waitset` wakes for its readers.
  Result<void> open(const Entity& participant, const std::string& match_id, const Entity& waitset);

  // Takes the samples that have arrived for this seat.
  void receive();

  // Waits until the team has answered the state that is on the network now. The error is the team's
  // fault or, after an interruption, a failure of the host.
  tl::expected<void, match::Answer> wait_until_ready();

  void post(const match::Observation& observation) override;
  match::Answer collect() override;

  Team team() const { return briefing_.team; }
  std::uint64_t heard() const { return inbox_.heard(); }
  const CommandCounts& commands() const { return inbox_.counts(); }
  const std::vector<pace::Absence>& absences() const { return liveliness_.absences(); }
  int processes() const { return processes_; }                 // number that have had the seat
  const pace::Durations& answers() const { return answers_; }  // from state to answer, s

 private:
  void take_hellos();
  void take_commands();
  mirocup_v2_Welcome answer_to(const mirocup_v2_Hello& hello, dds_instance_handle_t writer);
  bool is_ours(const mirocup_v2_TeamCommand& command, dds_instance_handle_t writer);
  bool may_be_taken() const;
  bool has_left() const;
  double now() const { return seconds_since(begin_); }
  void tell(const std::string& what) const;

  SeatLink link_;
  match::Briefing briefing_;
  std::string name_;
  JoinTerms terms_;
  WallClock::time_point begin_ = WallClock::now();
  Entity publisher_, subscriber_, hello_topic_, welcome_topic_, command_topic_;
  Entity hello_reader_, welcome_writer_, command_reader_;

  // The process that has the seat.
  std::uint64_t nonce_ = 0;  // 0: the seat is free
  ParticipantKey process_{};
  dds_instance_handle_t hello_writer_ = 0;
  dds_instance_handle_t command_writer_ = 0;  // 0: it has not written yet
  int processes_ = 0;

  Inbox inbox_;
  Liveliness liveliness_;
  bool is_ready_ = false;
  std::uint32_t tick_ = 0;
  double posted_at_ = 0.0;
  pace::Durations answers_;
  std::optional<match::Command> answer_;  // to tick_
};

}  // namespace mirocup::dds
