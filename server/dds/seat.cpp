// SPDX-License-Identifier: MIT
#include "server/dds/seat.hpp"

#include "server/dds/domain.hpp"
#include "server/dds/nonce.hpp"
#include "system/clock.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>

namespace mirocup::dds {

namespace {

using match::Answer;
using match::Fault;
using match::FaultCode;

// Seconds between two checks whether the team is still there.
constexpr double poll_interval = 0.02;

constexpr double longest_leg = 86400.0;  // s; rules can have no limit at all

// So many late commands in a row are told to the host.
constexpr int late_commands_to_tell = 10;

// The upper bits of a nonce are the same for all connections of one process (nonce.hpp).
bool is_same_process(std::uint64_t one, std::uint64_t other) {
  return process_of_nonce(one) == process_of_nonce(other);
}

std::string seconds_text(double seconds) {
  return std::to_string(static_cast<int>(seconds)) + " s";
}

}  // namespace

std::int64_t latest_end(const JoinTerms& terms) {
  return std::time(nullptr) +
         static_cast<std::int64_t>(std::ceil(std::min(terms.longest, longest_leg)));
}

Seat::Seat(SeatLink link, const match::Briefing& briefing, std::string name, const JoinTerms& terms)
    : link_(std::move(link)),
      briefing_(briefing),
      name_(std::move(name)),
      terms_(terms),
      last_end_(latest_end(terms)),
      liveliness_(terms.notice, terms.away),
      tick_(terms.first_tick) {
  inbox_.expect(tick_);  // the first answer comes before the first post()
}

Result<void> Seat::open(const Entity& participant, const std::string& match_id,
                        const Entity& waitset) {
  const std::string partition = team_partition(match_id, index_of(briefing_.team), name_);
  const Entity& p = participant;
  MIROCUP_TRY(publisher_, make_publisher(p, partition));
  MIROCUP_TRY(subscriber_, make_subscriber(p, partition));
  MIROCUP_TRY(hello_topic_, make_topic(p, mirocup_v1_Hello_desc, idl::hello));
  MIROCUP_TRY(welcome_topic_, make_topic(p, mirocup_v1_Welcome_desc, idl::welcome));
  MIROCUP_TRY(command_topic_, make_topic(p, mirocup_v1_TeamCommand_desc, idl::team_command));
  MIROCUP_TRY(hello_reader_, make_reader(subscriber_, hello_topic_, idl::hello));
  MIROCUP_TRY(welcome_writer_, make_writer(publisher_, welcome_topic_, idl::welcome));
  MIROCUP_TRY(command_reader_, make_reader(subscriber_, command_topic_, idl::team_command));
  MIROCUP_TRY_VOID(attach(waitset, hello_reader_));
  return attach(waitset, command_reader_);
}

void Seat::tell(FewWords& of_its_kind, const std::string& what) const {
  of_its_kind.say(terms_.tell, std::string(to_string(briefing_.team)) + " (" + name_ + "), tick " +
                                   std::to_string(tick_) + ": " + what);
}

void Seat::receive() {
  take_hellos();
  take_commands();
}

void Seat::take_hellos() {
  mirocup_v1_Hello hello;
  dds_instance_handle_t writer = 0;
  while (take(hello_reader_, hello, &writer)) {
    const mirocup_v1_Welcome welcome = answer_to(hello, writer);
    dds_write(welcome_writer_.get(), &welcome);
  }
}

mirocup_v1_Welcome Seat::answer_to(const mirocup_v1_Hello& hello, dds_instance_handle_t writer) {
  mirocup_v1_Welcome welcome = to_sample(briefing_, link_.leg, hello.nonce);
  const auto answer = [&welcome](Admission admission, const std::string& reason) {
    welcome.answer = static_cast<std::uint8_t>(admission);
    copy_text(welcome.reason, reason);
    return welcome;
  };
  const auto process = participant_of(hello_reader_, writer);
  if (!process) return answer(Admission::not_now, "the match server does not see your process yet");
  if (const std::string why = layout_mismatch(hello.layout); !why.empty()) {
    return answer(Admission::refused, "the team cannot be understood: " + why);
  }
  if (hello.nonce == 0 || static_cast<int>(hello.team) != index_of(briefing_.team) ||
      name_ != hello.name) {
    return answer(Admission::refused, "this seat is kept for \"" + name_ + "\"");
  }
  if (const std::string why = why_too_short(); !why.empty()) {
    tell(of_strangers_, why);
    return answer(Admission::refused, why);
  }
  if (hello.nonce == nonce_ && *process == process_) return welcome;
  if (!may_be_taken()) return answer(Admission::not_now, "another process of the team is playing");
  const bool is_same = nonce_ != 0 && is_same_process(nonce_, hello.nonce);
  nonce_ = hello.nonce;
  process_ = *process;
  hello_writer_ = writer;
  command_writer_ = 0;
  late_.reset();
  if (is_same) {
    tell(of_processes_, "the team's process has joined the network anew");
  } else if (processes_++ > 0) {
    tell(of_processes_, "another process of the team takes the team's seat");
  }
  return welcome;
}

// Catches credentials that expire in the middle of the leg, where nobody would learn why the team
// has gone. Returns the reason for the team; "" if they last.
std::string Seat::why_too_short() const {
  if (!link_.credentials_end || *link_.credentials_end >= last_end_) return "";
  return "the team's credentials are valid until " +
         system::TimeZone().text(*link_.credentials_end) + ", but the leg may last until " +
         system::TimeZone().text(last_end_) + ": it needs new ones";
}

// A process that still loads its team is silent, so before the first tick the seat becomes free
// only when its process has left the network.
bool Seat::may_be_taken() const {
  return nonce_ == 0 || has_left() || (is_ready_ && liveliness_.is_away());
}

bool Seat::has_left() const {
  return nonce_ != 0 && !participant_of(hello_reader_, hello_writer_);
}

bool Seat::is_ours(const mirocup_v1_TeamCommand& command, dds_instance_handle_t writer) {
  if (nonce_ == 0 || command.nonce != nonce_ ||
      static_cast<int>(command.team) != index_of(briefing_.team)) {
    return false;
  }
  if (command_writer_ == 0 && participant_of(command_reader_, writer) == process_) {
    command_writer_ = writer;
  }
  return writer == command_writer_;
}

void Seat::take_commands() {
  mirocup_v1_TeamCommand command;
  dds_instance_handle_t writer = 0;
  while (take(command_reader_, command, &writer)) {
    if (!is_ours(command, writer)) {
      // While a process joins anew, its commands may be here before its request.
      if (!has_told_of_commands_ && !is_same_process(nonce_, command.nonce)) {
        has_told_of_commands_ = true;
        tell(of_strangers_, "commands from another process are ignored");
      }
      inbox_.count_foreign();
      continue;
    }
    was_heard_ = true;
    heard_at_ = now();
    const std::optional<double> taken = round_trip_.answered(command.tick, now());
    switch (inbox_.sort(command.tick)) {
      case Arrival::in_step:
        answer_ = to_command(command);
        late_.reset();
        late_in_a_row_ = 0;
        if (is_ready_) {
          if (taken) answers_.add(*taken);
          if (liveliness_.answered(tick_, fair_now())) tell(of_absences_, "the team is back");
        }
        break;
      case Arrival::late:
        if (terms_.tick) take_late(command);
        if (terms_.tick && taken && ++late_in_a_row_ == late_commands_to_tell) {
          tell(of_lateness_, "answers come " +
                                 std::to_string(std::lround(1e3 * (*taken - *terms_.tick))) +
                                 " ms too late; the robots drive the last command that came");
        }
        break;
      case Arrival::repeated:
        if (answer_ && is_ready_) liveliness_.repeated(fair_now());
        break;
      case Arrival::old:
      case Arrival::ahead:
        break;
    }
  }
}

// In real time a late command shows that the team is there. In lockstep it has no effect: the match
// waits for the answer to the present tick.
void Seat::take_late(const mirocup_v1_TeamCommand& command) {
  late_ = to_command(command);
  late_tick_ = command.tick;
  if (liveliness_.answered_late(command.tick, tick_, fair_now())) {
    tell(of_absences_, "the team is back");
  }
}

tl::expected<void, Answer> Seat::wait_until_ready() {
  while (!answer_) {
    if (auto failure = link_.host_failure()) return tl::unexpected<Answer>(*failure);
    if (fair_now() > terms_.to_join) {
      const std::string limit = seconds_text(terms_.to_join);
      return tl::unexpected<Answer>(
          Fault{FaultCode::start_timeout,
                (nonce_ == 0 ? "the team did not join within " + limit + link_.reach
                             : "the team joined but did not answer within " + limit) +
                    link_.last_error()});
    }
    if (terms_.interrupted()) {
      return tl::unexpected<Answer>(match::HostFailure{"interrupted while a team was awaited"});
    }
    link_.listen(poll_interval);
  }
  return {};
}

void Seat::post(const match::Observation& observation) {
  posted_at_ = now();
  is_ready_ = true;
  // The first state was answered already, before wait_until_ready() returned.
  const bool is_answered = answer_ && observation.tick == tick_;
  if (!is_answered) answer_.reset();
  tick_ = observation.tick;
  inbox_.expect(tick_);
  round_trip_.sent(tick_, posted_at_);
  liveliness_.asked(fair_now());
  if (is_answered) liveliness_.answered(tick_, fair_now());
}

Standing Seat::look() {
  const double time = fair_now();
  const bool is_gone = has_left();
  if (liveliness_.silent(tick_, time, is_gone)) {
    tell(of_absences_, is_gone ? "the team has left the network" : "the team is silent");
  }
  return liveliness_.standing(time);
}

Fault Seat::disconnected() const {
  return {FaultCode::disconnected, "the team was away for " + seconds_text(terms_.away)};
}

Answer Seat::collect() {
  link_.settle();
  if (end_) return *end_;
  if (answer_) return *answer_;
  return late();
}

// The tick's time is over without its answer.
match::Late Seat::late() {
  match::Late late;
  if (late_ && inbox_.may_be_driven(late_tick_)) {
    late.older = *late_;
    inbox_.count_late_driven();
  }
  late_.reset();
  inbox_.end_tick();
  return late;
}

}  // namespace mirocup::dds
