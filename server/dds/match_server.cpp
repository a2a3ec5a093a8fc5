// SPDX-License-Identifier: MIT
#include "server/dds/match_server.hpp"

#include <chrono>
#include <utility>

namespace mirocup::dds {

namespace {

using match::Answer;
using match::Fault;
using match::FaultCode;
using std::chrono::duration;
using std::chrono::steady_clock;

// A wait is cut into slices, after each of which a lost sample is sent again.
constexpr dds_duration_t slice = DDS_MSECS(20);
constexpr dds_duration_t farewell = DDS_MSECS(1000);

double seconds_since(steady_clock::time_point begin) {
  return duration<double>(steady_clock::now() - begin).count();
}

std::string seconds_text(double seconds) {
  return std::to_string(static_cast<int>(seconds)) + " s";
}

// The rest of a Result<Entity> chain: puts the entity into `into`, or says what went wrong.
}  // namespace

Seat::Seat(MatchServer& server, const match::Briefing& briefing, const Patience& patience)
    : server_(server), briefing_(briefing), patience_(patience) {}

Result<void> Seat::open(const Entity& participant, const std::string& match_id) {
  const std::string partition = team_partition(match_id, index_of(briefing_.team));
  return keep(publisher_, make_publisher(participant, partition))
      .and_then([&] { return keep(subscriber_, make_subscriber(participant, partition)); })
      .and_then([&] {
        return keep(hello_topic_, make_topic(participant, mirocup_v1_Hello_desc, idl::hello));
      })
      .and_then([&] {
        return keep(welcome_topic_, make_topic(participant, mirocup_v1_Welcome_desc, idl::welcome));
      })
      .and_then([&] {
        return keep(command_topic_,
                    make_topic(participant, mirocup_v1_TeamCommand_desc, idl::team_command));
      })
      .and_then(
          [&] { return keep(hello_reader_, make_reader(subscriber_, hello_topic_, idl::hello)); })
      .and_then([&] {
        return keep(welcome_writer_, make_writer(publisher_, welcome_topic_, idl::welcome));
      })
      .and_then([&] {
        return keep(command_reader_, make_reader(subscriber_, command_topic_, idl::team_command));
      })
      .and_then([&] {
        return keep(waitset_, created(dds_create_waitset(participant.get()), "a waitset"));
      })
      .and_then([&] {
        return keep(condition_,
                    created(dds_create_readcondition(command_reader_.get(), DDS_ANY_STATE),
                            "a read condition"));
      })
      .and_then([&]() -> Result<void> {
        dds_waitset_attach(waitset_.get(), condition_.get(), 0);
        return {};
      });
}

void Seat::answer_hellos() {
  mirocup_v1_Hello hello;
  while (take(hello_reader_, hello)) {
    mirocup_v1_Welcome welcome = to_sample(briefing_, hello.nonce);
    if (name_ != hello.name) {
      welcome.accepted = false;
      put_text(welcome.reason, "this seat is kept for \"" + name_ + "\"");
    } else if (nonce_ != 0 && nonce_ != hello.nonce) {
      welcome.accepted = false;
      put_text(welcome.reason, "the team has joined already");
    } else {
      nonce_ = hello.nonce;
    }
    dds_write(welcome_writer_.get(), &welcome);
  }
}

tl::expected<void, Answer> Seat::wait_until_joined(const std::string& name) {
  name_ = name;
  const auto begin = steady_clock::now();
  while (nonce_ == 0) {
    answer_hellos();
    if (nonce_ != 0) break;
    if (seconds_since(begin) > patience_.to_join) {
      return tl::unexpected<Answer>(
          Fault{FaultCode::start_timeout,
                "the team did not join within " + seconds_text(patience_.to_join)});
    }
    if (patience_.interrupted()) {
      return tl::unexpected<Answer>(match::HostFailure{"interrupted while a team was awaited"});
    }
    dds_sleepfor(slice);
  }
  return {};
}

bool Seat::has_left() const {
  dds_subscription_matched_status_t status;
  return dds_get_subscription_matched_status(command_reader_.get(), &status) == DDS_RETCODE_OK &&
         status.current_count == 0;
}

void Seat::post(const match::Observation& observation) {
  tick_ = observation.tick;
}

Answer Seat::collect() {
  // A team that is not there is given a moment at the begin, where its endpoints may still be on
  // their way.
  constexpr double grace = 3.0;
  const auto begin = steady_clock::now();
  double waited = 0.0;
  while (true) {
    mirocup_v1_TeamCommand sample;
    while (take(command_reader_, sample)) {
      if (sample.nonce != nonce_ || sample.team != index_of(briefing_.team) ||
          sample.tick != tick_) {
        continue;  // somebody else's, or an answer to another tick
      }
      late_in_a_row_ = 0;
      return to_command(sample);
    }
    waited = seconds_since(begin);
    if (waited >= patience_.tick) break;
    if (waited > grace && has_left()) {
      return Fault{FaultCode::disconnected, "the team has left the network"};
    }
    const double left = patience_.tick - waited;
    const auto until = std::min<dds_duration_t>(slice, static_cast<dds_duration_t>(1e9 * left));
    if (dds_waitset_wait(waitset_.get(), nullptr, 0, until) == 0) {
      answer_hellos();
      server_.repeat();
    }
  }
  ++late_in_a_row_;
  if (patience_.is_late_fatal) {
    return Fault{FaultCode::disconnected, "the team did not answer for " + seconds_text(waited)};
  }
  if (late_in_a_row_ >= patience_.most_late_in_a_row) {
    return Fault{FaultCode::disconnected,
                 "the team did not answer for " + std::to_string(late_in_a_row_) + " ticks"};
  }
  return match::Late{};
}

MatchServer::MatchServer(std::string match_id, Domain domain)
    : match_id_(std::move(match_id)), domain_(std::move(domain)) {}

Result<std::unique_ptr<MatchServer>> MatchServer::open(const std::string& match_id,
                                                       const std::string& interface) {
  auto domain = open_server_domain(interface);
  if (!domain) return tl::unexpected(domain.error());
  std::unique_ptr<MatchServer> server(new MatchServer(match_id, std::move(*domain)));
  if (auto opened = server->open_topics(); !opened) return tl::unexpected(opened.error());
  return server;
}

Result<void> MatchServer::open_topics() {
  const Entity& participant = domain_.participant;
  return keep(publisher_, make_publisher(participant, match_partition(match_id_)))
      .and_then([&] {
        return keep(state_topic_,
                    make_topic(participant, mirocup_v1_WorldState_desc, idl::world_state));
      })
      .and_then([&] {
        return keep(event_topic_,
                    make_topic(participant, mirocup_v1_MatchEvent_desc, idl::match_event));
      })
      .and_then([&] {
        return keep(state_writer_, make_writer(publisher_, state_topic_, idl::world_state));
      })
      .and_then([&] {
        return keep(event_writer_, make_writer(publisher_, event_topic_, idl::match_event));
      });
}

Result<Seat*> MatchServer::add_seat(const match::Briefing& briefing, const Patience& patience) {
  std::unique_ptr<Seat> seat(new Seat(*this, briefing, patience));
  if (auto opened = seat->open(domain_.participant, match_id_); !opened) {
    return tl::unexpected(opened.error());
  }
  seats_.push_back(std::move(seat));
  return seats_.back().get();
}

void MatchServer::publish(const match::Match& match) {
  state_ = to_sample(match.scene(), match.field().robots_per_team);
  repeat();
  publish_decisions(match);
}

void MatchServer::repeat() {
  dds_write(state_writer_.get(), &state_);
}

void MatchServer::publish_decisions(const match::Match& match) {
  const match::ByTeam<int> score{state_.score[0], state_.score[1]};
  for (; events_ < match.decisions().size(); ++events_) {
    const auto event =
        to_sample(match.decisions()[events_], static_cast<std::uint32_t>(events_), score);
    dds_write(event_writer_.get(), &event);
  }
}

void MatchServer::close(const match::Match& match) {
  publish(match);
  mirocup_v1_MatchEvent last{};
  last.number = static_cast<std::uint32_t>(events_);
  last.tick = match.tick();
  last.ends_match = true;
  put_text(last.decision, "MATCH_END");
  put_text(last.reason, to_string(match.result().end));
  last.score[0] = match.result().score[0];
  last.score[1] = match.result().score[1];
  dds_write(event_writer_.get(), &last);
  dds_wait_for_acks(event_writer_.get(), farewell);
}

}  // namespace mirocup::dds
