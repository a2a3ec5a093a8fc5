// SPDX-License-Identifier: MIT
#include "server/dds/match_server.hpp"

#include "server/dds/nonce.hpp"

#include <algorithm>
#include <utility>

namespace mirocup::dds {

namespace {

// Seconds until an unanswered state is sent again.
constexpr double resend_interval = 0.01;
constexpr dds_duration_t farewell_timeout = DDS_MSECS(1000);

}  // namespace

MatchServer::MatchServer(std::string match_id, Domain domain)
    : match_id_(std::move(match_id)), domain_(std::move(domain)), leg_(random_nonce()) {}

Result<std::unique_ptr<MatchServer>> MatchServer::open(const std::string& match_id,
                                                       const std::string& interface,
                                                       const std::string& credentials) {
  auto domain = open_server_domain(interface, credentials);
  if (!domain) return tl::unexpected(domain.error());
  std::unique_ptr<MatchServer> server(new MatchServer(match_id, std::move(*domain)));
  if (auto opened = server->open_topics(); !opened) return tl::unexpected(opened.error());
  return server;
}

Result<void> MatchServer::open_topics() {
  return keep(participant_, make_participant(domain_))
      .and_then([&] {
        return keep(publisher_, make_publisher(participant_, match_partition(match_id_)));
      })
      .and_then([&] {
        return keep(state_topic_,
                    make_topic(participant_, mirocup_v2_WorldState_desc, idl::world_state));
      })
      .and_then([&] {
        return keep(event_topic_,
                    make_topic(participant_, mirocup_v2_MatchEvent_desc, idl::match_event));
      })
      .and_then([&] {
        return keep(state_writer_, make_writer(publisher_, state_topic_, idl::world_state));
      })
      .and_then([&] {
        return keep(event_writer_, make_writer(publisher_, event_topic_, idl::match_event));
      })
      .and_then([&] {
        return keep(waitset_, created(dds_create_waitset(participant_.get()), "a waitset"));
      });
}

Result<Seat*> MatchServer::add_seat(const match::Briefing& briefing, const std::string& name,
                                    const JoinTerms& terms) {
  SeatLink link{.leg = leg_,
                .listen = [this](double seconds) { listen(seconds); },
                .last_error = [this] { return last_error(); }};
  auto seat = std::make_unique<Seat>(std::move(link), briefing, name, terms);
  if (auto opened = seat->open(participant_, match_id_, waitset_); !opened) {
    return tl::unexpected(opened.error());
  }
  seats_.push_back(std::move(seat));
  return seats_.back().get();
}

void MatchServer::publish(const match::Leg& match) {
  state_ = to_sample(match.snapshot(), match.field().robots_per_team, leg_);
  send_state();
  publish_decisions(match);
}

void MatchServer::send_state() {
  for (const auto& seat : seats_) state_.heard[index_of(seat->team())] = seat->heard();
  dds_write(state_writer_.get(), &state_);
  sent_ = WallClock::now();
}

void MatchServer::listen(double seconds) {
  const double until_sending = std::max(0.0, resend_interval - seconds_since(sent_));
  const double wait = std::min(seconds, until_sending);
  if (wait > 0.0) {
    dds_waitset_wait(waitset_.get(), nullptr, 0, static_cast<dds_duration_t>(1e9 * wait) + 1);
  }
  for (const auto& seat : seats_) seat->receive();
  if (seconds > 0.0 && seconds_since(sent_) >= resend_interval) send_state();
}

void MatchServer::publish_decisions(const match::Leg& match) {
  const match::ByTeam<int> score{state_.score[0], state_.score[1]};
  for (; events_ < match.decisions().size(); ++events_) {
    const auto event =
        to_sample(match.decisions()[events_], leg_, static_cast<std::uint32_t>(events_), score);
    dds_write(event_writer_.get(), &event);
  }
}

void MatchServer::close(const match::Leg& leg) {
  publish(leg);
  mirocup_v2_MatchEvent last{};
  last.leg = leg_;
  last.number = static_cast<std::uint32_t>(events_);
  last.tick = leg.tick();
  last.ends_match = true;
  copy_text(last.decision, "MATCH_END");
  copy_text(last.reason, to_string(leg.outcome().kind));
  last.score[0] = leg.outcome().score[0];
  last.score[1] = leg.outcome().score[1];
  dds_write(event_writer_.get(), &last);
  dds_wait_for_acks(event_writer_.get(), farewell_timeout);
}

std::string MatchServer::last_error() const {
  return domain_.log->last_error_suffix();
}

}  // namespace mirocup::dds
