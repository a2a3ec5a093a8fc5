// SPDX-License-Identifier: MIT
#include "server/dds/team_client.hpp"

#include "server/dds/nonce.hpp"

#include <algorithm>
#include <utility>

namespace mirocup::dds {

namespace {

constexpr double hello_interval = 0.25;  // s
constexpr double max_poll_interval = 0.05;

// A server sends states many times a second. After this many seconds without a state the connection
// is broken.
constexpr double max_silence = 3.0;

// The connection is also broken if the server has received none of the last commands, more than
// this many, for this long (s).
constexpr int max_unacknowledged = 30;
constexpr double max_unacknowledged_time = 1.5;

}  // namespace

Result<std::unique_ptr<TeamClient>> TeamClient::open(const JoinRequest& request) {
  auto domain = open_team_domain(request.server, request.credentials);
  if (!domain) return tl::unexpected(domain.error());
  std::unique_ptr<TeamClient> client(new TeamClient(request, std::move(*domain)));
  if (auto connected = client->connect(); !connected) return tl::unexpected(connected.error());
  return client;
}

Result<void> TeamClient::connect() {
  link_ = {};  // leaves the network before it joins it again
  Link link;
  link.nonce = random_nonce();
  connected_at_ = last_heard_at_ = acknowledged_at_ = WallClock::now();
  unacknowledged_ = 0;
  hello_sent_at_ = {};
  return keep(link.participant, make_participant(domain_))
      .and_then([&] { return open_readers_and_writers(link); })
      .map([&] { link_ = std::move(link); });
}

Result<void> TeamClient::open_readers_and_writers(Link& l) const {
  const Entity& p = l.participant;
  const std::string match = match_partition(request_.match_id);
  const std::string own = team_partition(request_.match_id, index_of(request_.team), request_.name);
  const auto topic = [&p](Entity& into, const dds_topic_descriptor_t& type,
                          const idl::TopicQos& row) {
    return keep(into, make_topic(p, type, row));
  };
  const auto reader = [](Entity& into, const Entity& subscriber, const Entity& of,
                         const idl::TopicQos& row) {
    return keep(into, make_reader(subscriber, of, row));
  };
  const auto writer = [&l](Entity& into, const Entity& of, const idl::TopicQos& row) {
    return keep(into, make_writer(l.team_publisher, of, row));
  };
  return keep(l.match_subscriber, make_subscriber(p, match))
      .and_then([&] { return keep(l.team_publisher, make_publisher(p, own)); })
      .and_then([&] { return keep(l.team_subscriber, make_subscriber(p, own)); })
      .and_then([&] { return topic(l.state_topic, mirocup_v2_WorldState_desc, idl::world_state); })
      .and_then([&] { return topic(l.event_topic, mirocup_v2_MatchEvent_desc, idl::match_event); })
      .and_then([&] { return topic(l.hello_topic, mirocup_v2_Hello_desc, idl::hello); })
      .and_then([&] { return topic(l.welcome_topic, mirocup_v2_Welcome_desc, idl::welcome); })
      .and_then(
          [&] { return topic(l.command_topic, mirocup_v2_TeamCommand_desc, idl::team_command); })
      .and_then([&] {
        return reader(l.state_reader, l.match_subscriber, l.state_topic, idl::world_state);
      })
      .and_then([&] {
        return reader(l.event_reader, l.match_subscriber, l.event_topic, idl::match_event);
      })
      .and_then([&] {
        return reader(l.welcome_reader, l.team_subscriber, l.welcome_topic, idl::welcome);
      })
      .and_then([&] { return writer(l.hello_writer, l.hello_topic, idl::hello); })
      .and_then([&] { return writer(l.command_writer, l.command_topic, idl::team_command); })
      .and_then([&] { return keep(l.waitset, created(dds_create_waitset(p.get()), "a waitset")); })
      .and_then([&] { return attach(l.waitset, l.state_reader); })
      .and_then([&] { return attach(l.waitset, l.event_reader); })
      .and_then([&] { return attach(l.waitset, l.welcome_reader); });
}

News TeamClient::wait(double timeout) {
  const auto start = WallClock::now();
  while (true) {
    look_after_connection();
    if (auto news = poll()) return std::move(*news);
    const double left = timeout - seconds_since(start);
    if (left <= 0.0) return Silence{};
    const auto pause = static_cast<dds_duration_t>(1e9 * std::min(left, max_poll_interval)) + 1;
    if (dds_waitset_wait(link_.waitset.get(), nullptr, 0, pause) < 0) dds_sleepfor(pause);
  }
}

std::optional<News> TeamClient::poll() {
  if (auto news = take_welcome()) return news;
  if (auto news = take_event()) return news;
  return take_state();
}

std::optional<News> TeamClient::take_welcome() {
  mirocup_v2_Welcome welcome;
  while (take(link_.welcome_reader, welcome)) {
    if (welcome.nonce != link_.nonce) continue;
    link_.leg = welcome.leg;
    if (welcome.answer == static_cast<std::uint8_t>(Admission::not_now)) {
      wait_reason_ = welcome.reason;
      continue;
    }
    if (welcome.answer != static_cast<std::uint8_t>(Admission::accepted)) {
      return Refused{welcome.reason};
    }
    // A server that was started again receives the old Hello from its history, so its Welcome may
    // come before its first state.
    if (link_.is_seated && welcome.leg == seated_leg_) continue;
    if (!from_sample(welcome, briefing_)) return Refused{"the server's welcome makes no sense"};
    link_.is_seated = true;
    last_heard_at_ = WallClock::now();
    answer_.reset();  // it has the nonce of the former participant
    if (std::exchange(seated_leg_, welcome.leg) != welcome.leg) return Seated{};
  }
  return std::nullopt;
}

std::optional<News> TeamClient::take_event() {
  mirocup_v2_MatchEvent event;
  while (take(link_.event_reader, event)) {
    if (event.leg != link_.leg || !event.ends_match) continue;
    return MatchOver{event.reason, {event.score[0], event.score[1]}};
  }
  return std::nullopt;
}

std::optional<News> TeamClient::take_state() {
  mirocup_v2_WorldState state;
  while (take(link_.state_reader, state)) {
    last_heard_at_ = WallClock::now();
    if (!link_.is_seated) continue;
    const std::uint64_t heard = state.heard[index_of(request_.team)];
    if (heard != acknowledged_commands_) {
      acknowledged_commands_ = heard;
      acknowledged_at_ = last_heard_at_;
      unacknowledged_ = 0;
    }
    if (state.leg != link_.leg) {
      link_.is_seated = false;  // the server was started again
    } else if (!answer_ || state.tick > answer_->tick) {
      return to_scene(state);
    } else if (state.tick == answer_->tick) {
      dds_write(link_.command_writer.get(), &*answer_);
      ++unacknowledged_;
    }
  }
  return std::nullopt;
}

// Hostile packets can make either side drop all packets of the other, in one direction or in both.
bool TeamClient::is_cut_off() const {
  if (unacknowledged_ > max_unacknowledged &&
      seconds_since(acknowledged_at_) > max_unacknowledged_time)
    return true;
  return seconds_since(last_heard_at_) > max_silence && seconds_since(connected_at_) > max_silence;
}

void TeamClient::look_after_connection() {
  if (is_cut_off()) {
    if (!connect()) return;  // the next silence tries again
  }
  if (!link_.is_seated && seconds_since(hello_sent_at_) > hello_interval) send_hello();
}

void TeamClient::send_hello() {
  hello_sent_at_ = WallClock::now();
  mirocup_v2_Hello hello{};
  hello.team = static_cast<std::uint8_t>(index_of(request_.team));
  hello.nonce = link_.nonce;
  copy_text(hello.name, request_.name);
  dds_write(link_.hello_writer.get(), &hello);
}

void TeamClient::send(const match::Command& command, std::uint32_t tick) {
  answer_ = to_sample(command, request_.team, tick, link_.nonce);
  dds_write(link_.command_writer.get(), &*answer_);
  ++unacknowledged_;
}

std::string TeamClient::last_error() const {
  if (!wait_reason_.empty()) return "the match server says: " + wait_reason_;
  dds_subscription_matched_status_t match{};
  dds_get_subscription_matched_status(link_.state_reader.get(), &match);
  if (match.current_count > 0) {
    return "the match is there, but does not expect a team called \"" + request_.name + "\" as " +
           std::string(to_string(request_.team));
  }
  return "no match server answered" + domain_.log->last_error_suffix();
}

}  // namespace mirocup::dds
