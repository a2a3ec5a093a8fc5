// SPDX-License-Identifier: MIT
#include "server/dds/seat.hpp"

#include "server/dds/domain.hpp"

#include <utility>

namespace mirocup::dds {

namespace {

using match::Answer;
using match::Fault;
using match::FaultCode;

// Seconds between two checks whether the team is still there.
constexpr double poll_interval = 0.02;

std::string seconds_text(double seconds) {
  return std::to_string(static_cast<int>(seconds)) + " s";
}

}  // namespace

Seat::Seat(SeatLink link, const match::Briefing& briefing, std::string name, const JoinTerms& terms)
    : link_(std::move(link)),
      briefing_(briefing),
      name_(std::move(name)),
      terms_(terms),
      liveliness_(terms.notice) {}

Result<void> Seat::open(const Entity& participant, const std::string& match_id,
                        const Entity& waitset) {
  const std::string partition = team_partition(match_id, index_of(briefing_.team), name_);
  return keep(publisher_, make_publisher(participant, partition))
      .and_then([&] { return keep(subscriber_, make_subscriber(participant, partition)); })
      .and_then([&] {
        return keep(hello_topic_, make_topic(participant, mirocup_v2_Hello_desc, idl::hello));
      })
      .and_then([&] {
        return keep(welcome_topic_, make_topic(participant, mirocup_v2_Welcome_desc, idl::welcome));
      })
      .and_then([&] {
        return keep(command_topic_,
                    make_topic(participant, mirocup_v2_TeamCommand_desc, idl::team_command));
      })
      .and_then(
          [&] { return keep(hello_reader_, make_reader(subscriber_, hello_topic_, idl::hello)); })
      .and_then([&] {
        return keep(welcome_writer_, make_writer(publisher_, welcome_topic_, idl::welcome));
      })
      .and_then([&] {
        return keep(command_reader_, make_reader(subscriber_, command_topic_, idl::team_command));
      })
      .and_then([&] { return attach(waitset, hello_reader_); })
      .and_then([&] { return attach(waitset, command_reader_); });
}

void Seat::tell(const std::string& what) const {
  terms_.tell(std::string(to_string(briefing_.team)) + " (" + name_ + "), tick " +
              std::to_string(tick_) + ": " + what);
}

void Seat::receive() {
  take_hellos();
  take_commands();
}

void Seat::take_hellos() {
  mirocup_v2_Hello hello;
  dds_instance_handle_t writer = 0;
  while (take(hello_reader_, hello, &writer)) {
    const mirocup_v2_Welcome welcome = answer_to(hello, writer);
    dds_write(welcome_writer_.get(), &welcome);
  }
}

mirocup_v2_Welcome Seat::answer_to(const mirocup_v2_Hello& hello, dds_instance_handle_t writer) {
  mirocup_v2_Welcome welcome = to_sample(briefing_, link_.leg, hello.nonce);
  const auto answer = [&welcome](Admission admission, const std::string& reason) {
    welcome.answer = static_cast<std::uint8_t>(admission);
    copy_text(welcome.reason, reason);
    return welcome;
  };
  const auto process = participant_of(hello_reader_, writer);
  if (!process) return answer(Admission::not_now, "your process cannot be seen yet");
  if (hello.nonce == 0 || hello.team != index_of(briefing_.team) || name_ != hello.name) {
    return answer(Admission::refused, "this seat is kept for \"" + name_ + "\"");
  }
  if (hello.nonce == nonce_ && *process == process_) return welcome;
  if (!may_be_taken()) {
    return answer(Admission::not_now, "another process of the team is playing");
  }
  nonce_ = hello.nonce;
  process_ = *process;
  hello_writer_ = writer;
  command_writer_ = 0;
  if (processes_++ > 0) tell("another process of the team takes its seat");
  return welcome;
}

// A process that still loads its team is silent, so before the first tick the seat becomes free
// only when its process has left the network.
bool Seat::may_be_taken() const {
  return nonce_ == 0 || has_left() || (is_ready_ && liveliness_.is_away());
}

bool Seat::has_left() const {
  return nonce_ != 0 && !participant_of(hello_reader_, hello_writer_);
}

bool Seat::is_ours(const mirocup_v2_TeamCommand& command, dds_instance_handle_t writer) {
  if (nonce_ == 0 || command.nonce != nonce_ || command.team != index_of(briefing_.team)) {
    return false;
  }
  if (command_writer_ == 0 && participant_of(command_reader_, writer) == process_) {
    command_writer_ = writer;
  }
  return writer == command_writer_;
}

void Seat::take_commands() {
  mirocup_v2_TeamCommand command;
  dds_instance_handle_t writer = 0;
  while (take(command_reader_, command, &writer)) {
    if (!is_ours(command, writer)) {
      if (inbox_.counts().foreign == 0) tell("commands from another process are ignored");
      inbox_.count_foreign();
    } else if (inbox_.accept(command.tick)) {
      answer_ = to_command(command);
      if (is_ready_) answers_.add(now() - posted_at_);
    }
  }
}

tl::expected<void, Answer> Seat::wait_until_ready() {
  while (!answer_) {
    if (now() > terms_.to_join) {
      const char* what = nonce_ == 0 ? "the team did not join within "
                                     : "the team joined but did not answer within ";
      return tl::unexpected<Answer>(Fault{
          FaultCode::start_timeout, what + seconds_text(terms_.to_join) + link_.last_error()});
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
  liveliness_.asked(posted_at_);
  is_ready_ = true;
  // The first state was answered already, before wait_until_ready() returned.
  if (observation.tick != tick_) answer_.reset();
  tick_ = observation.tick;
  inbox_.expect(tick_);
}

Answer Seat::collect() {
  link_.listen(0.0);
  while (!answer_) {
    const double time = now();
    if (liveliness_.silent(tick_, time, has_left())) {
      tell(liveliness_.absences().back().has_left ? "the team has left the network"
                                                  : "the team is silent");
    }
    if (liveliness_.away(time) > terms_.away) {
      return Fault{FaultCode::disconnected, "the team was away for " + seconds_text(terms_.away)};
    }
    double left = poll_interval;
    if (terms_.tick) {
      left = std::min(left, posted_at_ + *terms_.tick - time);
      if (left <= 0.0) return match::Late{};
    } else if (terms_.interrupted()) {
      return match::HostFailure{"interrupted while a team was awaited"};
    }
    link_.listen(left);
  }
  if (liveliness_.answered(tick_, now())) tell("the team is back");
  return *answer_;
}

}  // namespace mirocup::dds
