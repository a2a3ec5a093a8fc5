// SPDX-License-Identifier: MIT
#include "server/dds/team_client.hpp"

#include <algorithm>
#include <chrono>
#include <sys/random.h>
#include <utility>

namespace mirocup::dds {

namespace {

using std::chrono::duration;
using std::chrono::steady_clock;

constexpr dds_duration_t slice = DDS_MSECS(20);
constexpr double hello_again = 0.5;  // s

double seconds_since(steady_clock::time_point begin) {
  return duration<double>(steady_clock::now() - begin).count();
}

// Tells this process from all others that may claim to be the team; never zero.
std::uint64_t draw_nonce() {
  std::uint64_t nonce = 0;
  while (nonce == 0) {
    if (getrandom(&nonce, sizeof nonce, 0) != sizeof nonce) {
      nonce = static_cast<std::uint64_t>(steady_clock::now().time_since_epoch().count());
    }
  }
  return nonce;
}

}  // namespace

Result<std::unique_ptr<TeamClient>> TeamClient::join(const std::string& server,
                                                     const std::string& match_id, Team team,
                                                     const std::string& name, double patience,
                                                     const std::function<bool()>& interrupted) {
  auto domain = open_team_domain(server);
  if (!domain) return tl::unexpected(domain.error());
  std::unique_ptr<TeamClient> client(new TeamClient(team, std::move(*domain)));
  if (auto opened = client->open(match_id); !opened) return tl::unexpected(opened.error());
  if (auto joined = client->shake_hands(name, patience, interrupted); !joined) {
    return tl::unexpected(joined.error());
  }
  return client;
}

Result<void> TeamClient::open(const std::string& match_id) {
  const Entity& p = domain_.participant;
  const std::string match = match_partition(match_id);
  const std::string own = team_partition(match_id, index_of(team_));
  const auto topic = [&p](Entity& into, const dds_topic_descriptor_t& type,
                          const idl::TopicQos& qos) {
    return keep(into, make_topic(p, type, qos));
  };
  return keep(match_subscriber_, make_subscriber(p, match))
      .and_then([&] { return keep(team_publisher_, make_publisher(p, own)); })
      .and_then([&] { return keep(team_subscriber_, make_subscriber(p, own)); })
      .and_then([&] { return topic(state_topic_, mirocup_v1_WorldState_desc, idl::world_state); })
      .and_then([&] { return topic(event_topic_, mirocup_v1_MatchEvent_desc, idl::match_event); })
      .and_then([&] { return topic(hello_topic_, mirocup_v1_Hello_desc, idl::hello); })
      .and_then([&] { return topic(welcome_topic_, mirocup_v1_Welcome_desc, idl::welcome); })
      .and_then(
          [&] { return topic(command_topic_, mirocup_v1_TeamCommand_desc, idl::team_command); })
      .and_then([&] {
        return keep(state_reader_, make_reader(match_subscriber_, state_topic_, idl::world_state));
      })
      .and_then([&] {
        return keep(event_reader_, make_reader(match_subscriber_, event_topic_, idl::match_event));
      })
      .and_then([&] {
        return keep(hello_writer_, make_writer(team_publisher_, hello_topic_, idl::hello));
      })
      .and_then([&] {
        return keep(welcome_reader_, make_reader(team_subscriber_, welcome_topic_, idl::welcome));
      })
      .and_then([&] {
        return keep(command_writer_,
                    make_writer(team_publisher_, command_topic_, idl::team_command));
      })
      .and_then([&] { return keep(waitset_, created(dds_create_waitset(p.get()), "a waitset")); })
      .and_then([&] {
        return keep(state_condition_,
                    created(dds_create_readcondition(state_reader_.get(), DDS_ANY_STATE),
                            "a read condition"));
      })
      .and_then([&] {
        return keep(event_condition_,
                    created(dds_create_readcondition(event_reader_.get(), DDS_ANY_STATE),
                            "a read condition"));
      })
      .and_then([&]() -> Result<void> {
        dds_waitset_attach(waitset_.get(), state_condition_.get(), 0);
        dds_waitset_attach(waitset_.get(), event_condition_.get(), 0);
        return {};
      });
}

Result<void> TeamClient::shake_hands(const std::string& name, double patience,
                                     const std::function<bool()>& interrupted) {
  nonce_ = draw_nonce();
  mirocup_v1_Hello hello{};
  hello.team = static_cast<std::uint8_t>(index_of(team_));
  hello.nonce = nonce_;
  put_text(hello.name, name);

  const auto begin = steady_clock::now();
  double said = -hello_again;
  while (seconds_since(begin) < patience) {
    if (interrupted()) return fail(Errc::interrupted, "interrupted");
    // Only the last Hello of anyone is kept for the server, so another may have taken its place.
    if (seconds_since(begin) - said >= hello_again) {
      said = seconds_since(begin);
      dds_write(hello_writer_.get(), &hello);
    }
    mirocup_v1_Welcome welcome;
    while (take(welcome_reader_, welcome)) {
      if (welcome.nonce != nonce_) continue;
      if (!welcome.accepted) {
        return fail(Errc::unavailable,
                    std::string("the match server refuses the team: ") + welcome.reason);
      }
      if (!from_sample(welcome, told_)) {
        return fail(Errc::damaged, "the match server's welcome makes no sense");
      }
      return {};
    }
    dds_sleepfor(slice);
  }
  return fail(Errc::unavailable, "no match server answered within " +
                                     std::to_string(static_cast<int>(patience)) + " s");
}

News TeamClient::wait(double patience) {
  const auto begin = steady_clock::now();
  while (true) {
    mirocup_v1_MatchEvent event;
    while (take(event_reader_, event)) {
      if (event.ends_match) return MatchOver{event.reason, {event.score[0], event.score[1]}};
    }
    mirocup_v1_WorldState state;
    if (take(state_reader_, state)) return to_scene(state);
    const double left = patience - seconds_since(begin);
    if (left <= 0.0) return Silence{};
    dds_waitset_wait(
        waitset_.get(), nullptr, 0,
        std::min<dds_duration_t>(DDS_MSECS(500), static_cast<dds_duration_t>(1e9 * left) + 1));
  }
}

void TeamClient::send(const match::Command& command, std::uint32_t tick) {
  const auto sample = to_sample(command, team_, tick, nonce_);
  dds_write(command_writer_.get(), &sample);
}

}  // namespace mirocup::dds
