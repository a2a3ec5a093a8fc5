// SPDX-License-Identifier: MIT
#include "server/dds/team_client.hpp"

#include "server/dds/network_interface.hpp"
#include "server/dds/nonce.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace mirocup::dds {

namespace {

constexpr double hello_interval = 0.25;  // s
constexpr double max_poll_interval = 0.02;

// A server sends states many times a second, also while it waits. After `settled_silence` (s)
// without a state, a team that has had states in its seat takes the connection for broken, since a
// router may have taken another port; so does a team whose host has another address now. Before the
// first state it waits for `max_silence`: on a slow wire the connection needs longer to come about.
// With each break the patience doubles, up to `max_silence`, because a busy server pauses, too;
// after `calm` (s) in one connection it begins anew.
constexpr double max_silence = 3.0;
constexpr double settled_silence = 0.4;
constexpr double calm = 20.0;

// The client keeps to the leg in which it has its seat. Only after this many seconds without a
// state of that leg it believes that the server was started again.
constexpr double leg_patience = 0.5;

// The connection is also broken if the server has received none of the last commands, more than
// this many, for this long (s).
constexpr int max_unacknowledged = 30;
constexpr double max_unacknowledged_time = 1.5;

// Between leaving the network and joining it again, s. Cyclone takes a participant down in the
// background, within milliseconds. If the next one is there before that, Cyclone 0.10 takes it for
// one that has already been told of the server's topics, and it never receives anything. A new
// domain, which a host with another address opens, knows nothing of the former one.
constexpr double rejoin_pause = 0.25;

bool is_in_partition(const dds_qos_t* qos, std::string_view partition) {
  std::uint32_t count = 0;
  char** names = nullptr;
  if (qos == nullptr || !dds_qget_partition(qos, &count, &names)) return false;
  bool found = false;
  for (std::uint32_t i = 0; i < count; ++i) {
    found = found || partition == names[i];
    dds_free(names[i]);
  }
  dds_free(names);
  return found;
}

constexpr const char* not_understood = "the match server cannot be understood: ";

}  // namespace

Result<std::unique_ptr<TeamClient>> TeamClient::open(const JoinRequest& request) {
  std::unique_ptr<TeamClient> client(new TeamClient(request));
  MIROCUP_TRY_VOID(client->connect());
  return client;
}

Result<void> TeamClient::connect() {
  if (has_moved()) {
    domain_ = {};  // a process has one at a time
    MIROCUP_TRY(domain_, open_team_domain(request_.server, request_.credentials, request_.domain,
                                          request_.interface));
  }
  Link link;
  link.nonce = connection_nonce();
  connected_at_ = last_heard_at_ = acknowledged_at_ = WallClock::now();
  unacknowledged_ = 0;
  hello_sent_at_ = {};
  MIROCUP_TRY(link.participant, make_participant(domain_));
  MIROCUP_TRY_VOID(open_readers_and_writers(link));
  link_ = std::move(link);
  return {};
}

Result<void> TeamClient::open_readers_and_writers(Link& l) const {
  const Entity& p = l.participant;
  const std::string match = match_partition(request_.match_id);
  const std::string own = team_partition(request_.match_id, index_of(request_.team), request_.name);
  MIROCUP_TRY(l.match_subscriber, make_subscriber(p, match));
  MIROCUP_TRY(l.team_publisher, make_publisher(p, own));
  MIROCUP_TRY(l.team_subscriber, make_subscriber(p, own));
  MIROCUP_TRY(l.state_topic, make_topic(p, mirocup_v1_WorldState_desc, idl::world_state));
  MIROCUP_TRY(l.event_topic, make_topic(p, mirocup_v1_MatchEvent_desc, idl::match_event));
  MIROCUP_TRY(l.hello_topic, make_topic(p, mirocup_v1_Hello_desc, idl::hello));
  MIROCUP_TRY(l.welcome_topic, make_topic(p, mirocup_v1_Welcome_desc, idl::welcome));
  MIROCUP_TRY(l.command_topic, make_topic(p, mirocup_v1_TeamCommand_desc, idl::team_command));
  MIROCUP_TRY(l.state_reader, make_reader(l.match_subscriber, l.state_topic, idl::world_state));
  MIROCUP_TRY(l.event_reader, make_reader(l.match_subscriber, l.event_topic, idl::match_event));
  MIROCUP_TRY(l.welcome_reader, make_reader(l.team_subscriber, l.welcome_topic, idl::welcome));
  MIROCUP_TRY(l.hello_writer, make_writer(l.team_publisher, l.hello_topic, idl::hello));
  MIROCUP_TRY(l.command_writer, make_writer(l.team_publisher, l.command_topic, idl::team_command));
  MIROCUP_TRY(l.waitset, created(dds_create_waitset(p.get()), "a waitset"));
  MIROCUP_TRY_VOID(attach(l.waitset, l.state_reader));
  MIROCUP_TRY_VOID(attach(l.waitset, l.event_reader));
  return attach(l.waitset, l.welcome_reader);
}

News TeamClient::wait(double timeout) {
  const auto start = WallClock::now();
  while (true) {
    // First, because while the team was thinking or loading, nobody looked at what has come.
    if (auto news = poll()) return std::move(*news);
    look_after_connection();
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
  mirocup_v1_Welcome welcome;
  while (take(link_.welcome_reader, welcome)) {
    if (const std::string why = layout_mismatch(welcome.layout); !why.empty()) {
      return Refused{not_understood + why};
    }
    if (welcome.nonce != link_.nonce || is_of_another_leg(welcome.leg)) continue;
    link_.leg = welcome.leg;
    if (welcome.answer == mirocup_v1_ADMISSION_NOT_NOW) {
      wait_reason_ = welcome.reason;
      continue;
    }
    if (welcome.answer != mirocup_v1_ADMISSION_ACCEPTED) {
      return Refused{welcome.reason};
    }
    // A server that was started again receives the old Hello from its history, so its Welcome may
    // come before its first state.
    if (link_.is_seated && welcome.leg == seated_leg_) continue;
    if (!from_sample(welcome, briefing_)) return Refused{"the server's welcome makes no sense"};
    link_.is_seated = true;
    last_heard_at_ = WallClock::now();
    if (std::exchange(seated_leg_, welcome.leg) != welcome.leg) {
      answer_.reset();
      return Seated{};
    }
    // The server may have missed the answer. Its tick must not come a second time.
    if (answer_) answer_->nonce = link_.nonce;
  }
  return std::nullopt;
}

// Two servers with one match ID would otherwise tear the team apart between their legs.
bool TeamClient::is_of_another_leg(std::uint64_t leg) const {
  return link_.is_seated && leg != link_.leg && seconds_since(last_heard_at_) < leg_patience;
}

std::optional<News> TeamClient::take_event() {
  mirocup_v1_MatchEvent event;
  while (take(link_.event_reader, event)) {
    if (event.leg != link_.leg || !event.ends_match) continue;
    return MatchOver{event.reason, {event.score[0], event.score[1]}};
  }
  return std::nullopt;
}

std::optional<News> TeamClient::take_state() {
  mirocup_v1_WorldState state;
  while (take(link_.state_reader, state)) {
    if (is_of_another_leg(state.leg)) continue;
    if (const std::string why = layout_mismatch(state.layout); !why.empty()) {
      return Refused{not_understood + why};
    }
    if (!is_known(state)) continue;
    last_heard_at_ = WallClock::now();
    if (seconds_since(connected_at_) > calm) breaks_ = 0;
    if (!link_.is_seated) continue;
    link_.is_settled = true;
    const std::uint32_t heard = state.heard[index_of(request_.team)];
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
  const double silence = seconds_since(std::max(last_heard_at_, connected_at_));
  if (silence > max_silence) return true;
  if (silence <= settled_silence) return false;
  return has_moved() || (link_.is_settled && silence > std::ldexp(settled_silence, breaks_));
}

// The sockets of a domain keep the address that this host had when they were opened.
bool TeamClient::has_moved() const {
  if (domain_.domain.get() == 0) return true;
  const std::string own = own_address_towards(domain_.server, request_.interface);
  return !own.empty() && own != domain_.own_address;
}

void TeamClient::look_after_connection() {
  if (!left_at_ && is_cut_off()) {
    breaks_ += link_.is_settled ? 1 : 0;
    link_ = {};
    left_at_ = WallClock::now();
  }
  if (left_at_) {
    if (seconds_since(*left_at_) < rejoin_pause && !has_moved()) return;
    left_at_.reset();
    if (!connect()) return;  // the next silence tries again
  }
  if (!link_.is_seated && seconds_since(hello_sent_at_) > hello_interval) send_hello();
}

void TeamClient::send_hello() {
  hello_sent_at_ = WallClock::now();
  mirocup_v1_Hello hello{};
  hello.layout = mirocup_v1_LAYOUT_NUMBER;
  hello.team = static_cast<std::uint8_t>(request_.team);
  hello.nonce = link_.nonce;
  copy_text(hello.name, request_.name);
  dds_write(link_.hello_writer.get(), &hello);
}

void TeamClient::send(const match::Command& command, std::uint32_t tick) {
  answer_ = to_sample(command, request_.team, tick, link_.nonce);
  dds_write(link_.command_writer.get(), &*answer_);
  ++unacknowledged_;
}

// Returns the type of the states that are written in this match and that this program cannot read;
// "" if there are none.
std::string TeamClient::type_of_server() const {
  const Entity reader(dds_create_reader(link_.participant.get(), DDS_BUILTIN_TOPIC_DCPSPUBLICATION,
                                        nullptr, nullptr));
  const std::string match = match_partition(request_.match_id);
  std::string found;
  void* sample = nullptr;  // on loan from the reader
  dds_sample_info_t info;
  while (found.empty() && dds_take(reader.get(), &sample, &info, 1, 1) == 1) {
    const auto& writer = *static_cast<const dds_builtintopic_endpoint_t*>(sample);
    if (info.valid_data && std::string_view(writer.topic_name) == idl::world_state.name &&
        is_in_partition(writer.qos, match)) {
      found = writer.type_name;
    }
    dds_return_loan(reader.get(), &sample, 1);
    sample = nullptr;
  }
  return found;
}

std::string TeamClient::last_error() const {
  if (!wait_reason_.empty()) return "the match server says: " + wait_reason_;
  dds_subscription_matched_status_t match{};
  dds_get_subscription_matched_status(link_.state_reader.get(), &match);
  if (match.current_count > 0)
    return "the match is there, but does not expect a team called \"" + request_.name + "\" as " +
           std::string(to_string(request_.team));
  const std::string reasons =
      request_.credentials.empty()
          ? "does it run, under this ID, and can it be reached by UDP? If the match uses "
            "credentials, its server answers only teams with credentials"
          : "does it run, under this ID, and can it be reached by UDP? The match must be played "
            "with credentials of the same league, and yours must be neither revoked nor expired";
  if (const std::string type = type_of_server(); !type.empty())
    return "the match is there, but its server sends " + type + ", and this program needs " +
           mirocup_v1_WorldState_desc.m_typename + ": both need the same version of mirocup";
  return "no match server answered (" + reasons + ")" +
         (domain_.log ? domain_.log->last_error_suffix() : "");
}

}  // namespace mirocup::dds
