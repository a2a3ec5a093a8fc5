// SPDX-License-Identifier: MIT
//
// The seat of one team in a match on the network: the process that has the seat, and the answers of
// that process.
//
// A seat belongs to the process that was accepted into it. The seat knows that process by the key
// that DDS gives to every participant and by the nonce that the process drew. The seat counts and
// drops commands that other processes write in the team's name. Another process with this team name
// may take the seat only while the first process is away.
//
// A seat is part of a MatchServer. Threads: the server's thread. collect() of any seat settles the
// tick for all seats of the server at once, because the effect of an absence depends on both teams.
#pragma once

#include "record/durations.hpp"
#include "server/dds/convert.hpp"
#include "server/dds/entity.hpp"
#include "server/dds/inbox.hpp"
#include "server/dds/liveliness.hpp"
#include "server/dds/round_trip.hpp"
#include "server/dds/wall_time.hpp"

#include <functional>
#include <string>
#include <utility>

namespace mirocup::dds {

// Prints at most `max` sentences of one kind, which a stranger or a bad network can cause. The last
// sentence says that no more follow.
class FewWords {
 public:
  explicit FewWords(int max = 10) : left_(max) {}

  void say(const std::function<void(const std::string&)>& tell, const std::string& what) {
    if (left_ <= 0) return;
    tell(--left_ > 0 ? what
                     : what + "; further messages of this kind are counted, but not printed");
  }

 private:
  int left_;
};

// The terms on which a team joins a match and stays in it; times are seconds of wall time.
struct JoinTerms {
  // Longest time from the construction of the seat to the team's first answer.
  double to_join = 60.0;
  // The first tick that the team answers; above 0 if a match continues a record.
  std::uint32_t first_tick = 0;
  // The time in which a tick must be answered (real time). If empty, the match waits without a
  // limit (lockstep).
  std::optional<double> tick;
  double notice = 1.0;   // a team that is silent for this long is away
  double away = 10.0;    // limit of the sum of a team's absences in a leg
  double longest = 0.0;  // longest time from the construction of the seat to the end of the leg
  std::function<bool()> interrupted = [] { return false; };  // called in waits; true ends the wait
  std::function<void(const std::string&)> tell = [](auto&) {};  // gets a sentence for the host
};

// Returns the latest end of a leg that begins now, in seconds since 1970 UTC.
std::int64_t latest_end(const JoinTerms& terms);

// The services of a match server that its seats use.
struct SeatLink {
  std::uint64_t leg = 0;  // the number of the server's leg
  // Receives samples for all seats; waits at most `seconds`.
  std::function<void(double seconds)> listen;
  std::function<void()> settle;  // waits until all seats have answered
  // Returns the wall seconds so far that count as no team's absence, because the host is at fault.
  std::function<double()> excused;
  std::function<std::optional<match::HostFailure>()> host_failure;
  // The time until which the team's credentials are valid, s since 1970 UTC; empty: not known.
  std::optional<std::int64_t> credentials_end;
  std::function<std::string()> last_error;  // the last messages of DDS, as the end of a sentence
  // The end of a sentence about a team that did not join: from where teams can reach the server.
  std::string reach;
};

class Seat final : public match::Controller {
 public:
  Seat(SeatLink link, const match::Briefing& briefing, std::string name, const JoinTerms& terms);

  // Makes the seat's topics, readers and writers. `waitset` wakes for samples of these readers.
  Result<void> open(const Entity& participant, const std::string& match_id, const Entity& waitset);

  // Takes the samples that have arrived for this seat.
  void receive();

  // Waits until the team has answered the state that is on the network now. The error is the team's
  // fault or, after an interruption, a failure of the host.
  tl::expected<void, match::Answer> wait_until_ready();

  void post(const match::Observation& observation) override;
  match::Answer collect() override;

  // The server calls these functions while it settles a tick.
  bool has_answered() const { return answer_.has_value(); }
  // Returns the seconds until an answer is late; in lockstep always 1 s, which is longer than any
  // wait.
  double time_left() const { return terms_.tick ? posted_at_ + *terms_.tick - now() : 1.0; }
  bool is_overdue() const { return time_left() <= 0.0; }
  Standing look();  // like standing(), but first notes whether the team is away
  Standing standing() const { return liveliness_.standing(fair_now()); }
  // collect() returns `how` instead of an answer.
  void end(match::Answer how) { end_ = std::move(how); }
  match::Fault disconnected() const;
  const JoinTerms& terms() const { return terms_; }
  double resend_after() const { return round_trip_.resend_after(); }
  // True if a command has come since the last call.
  bool take_heard() { return std::exchange(was_heard_, false); }

  // True if a command of the team's process has come within the last JoinTerms::notice seconds. To
  // be called only before the first tick, while the server sends the state again and again.
  bool is_there() const { return !has_left() && now() - heard_at_ < terms_.notice; }

  Team team() const { return briefing_.team; }
  std::uint64_t heard() const { return inbox_.heard(); }
  const record::CommandCounts& commands() const { return inbox_.counts(); }
  const std::vector<record::Absence>& absences() const { return liveliness_.absences(); }
  // Number of processes that have had the seat.
  int processes() const { return processes_; }
  const record::Durations& answers() const { return answers_; }  // times from state to answer, s

 private:
  void take_hellos();
  void take_commands();
  mirocup_v1_Welcome answer_to(const mirocup_v1_Hello& hello, dds_instance_handle_t writer);
  bool is_ours(const mirocup_v1_TeamCommand& command, dds_instance_handle_t writer);
  std::string why_too_short() const;
  bool may_be_taken() const;
  bool has_left() const;
  void take_late(const mirocup_v1_TeamCommand& command);
  match::Late late();
  double now() const { return seconds_since(begin_); }
  double fair_now() const { return now() - link_.excused(); }
  void tell(FewWords& of_its_kind, const std::string& what) const;

  SeatLink link_;
  match::Briefing briefing_;
  std::string name_;
  JoinTerms terms_;
  WallClock::time_point begin_ = WallClock::now();
  std::int64_t last_end_;  // the latest end of the leg, s since 1970 UTC
  Entity publisher_, subscriber_, hello_topic_, welcome_topic_, command_topic_;
  Entity hello_reader_, welcome_writer_, command_reader_;

  // The process that has the seat.
  std::uint64_t nonce_ = 0;  // 0: the seat is free
  ParticipantKey process_{};
  dds_instance_handle_t hello_writer_ = 0;
  dds_instance_handle_t command_writer_ = 0;  // 0: the process has not written yet
  int processes_ = 0;
  // True: the host has got a sentence about commands of another process.
  bool has_told_of_commands_ = false;

  Inbox inbox_;
  Liveliness liveliness_;
  bool is_ready_ = false;
  std::uint32_t tick_ = 0;
  double posted_at_ = 0.0;
  record::Durations answers_;
  RoundTrip round_trip_;
  std::optional<match::Command> answer_;  // the answer to tick_
  std::optional<match::Command> late_;    // the newest late command, until it is driven
  std::uint32_t late_tick_ = 0;           // the tick that late_ answers
  int late_in_a_row_ = 0;
  bool was_heard_ = false;
  double heard_at_ = 0.0;
  std::optional<match::Answer> end_;

  mutable FewWords of_absences_, of_processes_, of_lateness_{3}, of_strangers_{2};
};

}  // namespace mirocup::dds
