// SPDX-License-Identifier: MIT
#include "server/dds/match_server.hpp"

#include "server/dds/claim.hpp"
#include "server/dds/credentials.hpp"
#include "server/dds/network_interface.hpp"
#include "server/dds/nonce.hpp"
#include "system/clock.hpp"
#include "system/digest.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace mirocup::dds {

namespace {

constexpr double absence_poll_interval = 0.02;  // s, for teams that have left
constexpr double host_poll_interval = 0.05;     // s, for the state of the host's interface

// A step of the server that lasts longer than this, s, and than two ticks is one in which it stood
// still.
constexpr double usual_step = 1.0;

constexpr dds_duration_t farewell_timeout = DDS_MSECS(1000);

// Claims the match ID on this host: two servers with the same ID would share a partition, and each
// team would get states of both legs. Errc::unavailable: another process has the claim.
Result<system::Descriptor> claim_match(const std::string& match_id, int domain) {
  MIROCUP_TRY(auto claimed, claim("mirocup-" + std::to_string(domain) + "-" +
                                  system::sha256(match_id).substr(0, 32)));
  if (claimed.is_open()) return claimed;
  return fail(Errc::unavailable, "match \"" + match_id +
                                     "\" is already played by another match server on this host: "
                                     "wait for its end, or choose another --match");
}

}  // namespace

MatchServer::MatchServer(std::string match_id, std::string interface, Domain domain)
    : match_id_(std::move(match_id)),
      interface_(std::move(interface)),
      domain_(std::move(domain)),
      leg_(random_nonce()) {}

// To end its threads, Cyclone sends itself a packet and waits for it, without a limit. While the
// interface is down it does not arrive.
MatchServer::~MatchServer() {
  if (was_up_ && !interface_is_up(interface_)) domain_.domain.abandon();
}

Result<std::unique_ptr<MatchServer>> MatchServer::open(const std::string& match_id,
                                                       const std::string& interface,
                                                       const std::string& credentials,
                                                       int domain_number, Reply reply) {
  MIROCUP_TRY(auto claim, claim_match(match_id, domain_number));
  MIROCUP_TRY(auto domain, open_server_domain(interface, credentials, domain_number, reply));
  std::unique_ptr<MatchServer> server(new MatchServer(match_id, interface, std::move(domain)));
  server->claim_ = std::move(claim);
  MIROCUP_TRY_VOID(server->open_topics());
  return server;
}

Result<void> MatchServer::open_topics() {
  MIROCUP_TRY(participant_, make_participant(domain_));
  const Entity& p = participant_;
  MIROCUP_TRY(publisher_, make_publisher(p, match_partition(match_id_)));
  MIROCUP_TRY(state_topic_, make_topic(p, mirocup_v1_WorldState_desc, idl::world_state));
  MIROCUP_TRY(event_topic_, make_topic(p, mirocup_v1_MatchEvent_desc, idl::match_event));
  MIROCUP_TRY(info_topic_, make_topic(p, mirocup_v1_MatchInfo_desc, idl::match_info));
  MIROCUP_TRY(info_writer_, make_writer(publisher_, info_topic_, idl::match_info));
  MIROCUP_TRY(state_writer_, make_writer(publisher_, state_topic_, idl::world_state));
  MIROCUP_TRY(event_writer_, make_writer(publisher_, event_topic_, idl::match_event));
  MIROCUP_TRY(waitset_, created(dds_create_waitset(p.get()), "a waitset"));
  return {};
}

Result<Seat*> MatchServer::add_seat(const match::Briefing& briefing, const std::string& name,
                                    const JoinTerms& terms) {
  SeatLink link{.leg = leg_,
                .listen = [this](double seconds) { listen(seconds); },
                .settle = [this] { settle(); },
                .excused = [this] { return excused_ ? excused_->total() : 0.0; },
                .host_failure = [this] { return host_failure(); },
                .credentials_end = std::nullopt,
                .last_error = [this] { return domain_.log->last_error_suffix(); },
                .reach = reach()};
  if (const std::string& folder = domain_.credentials; !folder.empty()) {
    const std::int64_t last_end = latest_end(terms);
    const auto own_end = credentials_end(folder);
    if (own_end && *own_end < last_end)
      return fail(Errc::input, "the credentials in " + folder + " are valid until " +
                                   system::TimeZone().text(*own_end) +
                                   ", but the leg may last until " +
                                   system::TimeZone().text(last_end) + ": make new ones");
    link.credentials_end = team_credentials_end(folder, name);
  }
  auto seat = std::make_unique<Seat>(std::move(link), briefing, name, terms);
  MIROCUP_TRY_VOID(seat->open(participant_, match_id_, waitset_));
  if (!excused_) excused_.emplace(usual_step + 2.0 * terms.tick.value_or(0.0));
  seats_.push_back(std::move(seat));
  return seats_.back().get();
}

void MatchServer::announce(const match::Briefing& briefing, const match::ByTeam<std::string>& names,
                           double speed) {
  const mirocup_v1_MatchInfo info = to_sample(briefing, leg_, names, speed);
  dds_write(info_writer_.get(), &info);
}

void MatchServer::publish(const match::Leg& match) {
  state_ = to_sample(match.view(), match.field().robots_per_team, leg_);
  is_settled_ = false;
  send_state();
  publish_decisions(match);
}

void MatchServer::send_state() {
  for (const auto& seat : seats_) {
    state_.heard[index_of(seat->team())] = static_cast<std::uint32_t>(seat->heard());
  }
  dds_write(state_writer_.get(), &state_);
  sent_ = WallClock::now();
}

void MatchServer::listen(double seconds) {
  const double interval = resend_after();
  const double until_sending = std::max(0.0, interval - seconds_since(sent_));
  const double wait = std::min(seconds, until_sending);
  if (wait > 0.0) {
    dds_waitset_wait(waitset_.get(), nullptr, 0, static_cast<dds_duration_t>(1e9 * wait) + 1);
  }
  for (const auto& seat : seats_) seat->receive();
  if (seconds_since(looked_) >= host_poll_interval) look_after_host();
  if (seconds > 0.0 && seconds_since(sent_) >= interval) send_state();
}

// All teams read the same state. It is sent again as soon as one of those that have not answered
// may have missed it.
double MatchServer::resend_after() const {
  double shortest = RoundTrip::max_resend_interval;
  const bool all_answered = std::ranges::all_of(seats_, [](auto& s) { return s->has_answered(); });
  for (const auto& seat : seats_) {
    if (all_answered || !seat->has_answered()) shortest = std::min(shortest, seat->resend_after());
  }
  return shortest;
}

void MatchServer::look_after_host() {
  looked_ = WallClock::now();
  if (!excused_) return;
  bool any_heard = false;
  for (const auto& seat : seats_) any_heard = seat->take_heard() || any_heard;
  const bool has_carrier = interface_is_up(interface_);
  was_up_ = was_up_ || has_carrier;
  const bool is_up = has_carrier || !was_up_;
  excused_->look(seconds_since(began_), is_up, any_heard);
  if (is_up != std::exchange(is_up_, is_up)) {
    of_host_.say(
        seats_.front()->terms().tell,
        "this host's network interface " + interface_ +
            (is_up ? " is up again" : " is down; this time does not count as absence of a team"));
  }
}

std::optional<match::HostFailure> MatchServer::host_failure() {
  if (!excused_ || excused_->was_down() <= seats_.front()->terms().away) return std::nullopt;
  return match::HostFailure{"this host's network interface " + interface_ +
                            " was down for more than " +
                            std::to_string(static_cast<int>(seats_.front()->terms().away)) + " s"};
}

void MatchServer::settle() {
  if (std::exchange(is_settled_, true)) return;
  listen(0.0);
  while (true) {
    const bool all_answered =
        std::ranges::all_of(seats_, [](auto& s) { return s->has_answered(); });
    const Verdict verdict = judge_teams(all_answered);
    if (verdict.ends_leg()) return;
    const bool awaits_other = verdict.awaits_other;
    const JoinTerms& terms = seats_.front()->terms();
    if (!awaits_other) {
      const bool is_over =
          std::ranges::all_of(seats_, [](auto& s) { return s->has_answered() || s->is_overdue(); });
      if (is_over) return;
    }
    if ((awaits_other || !terms.tick) && terms.interrupted()) {
      for (const auto& seat : seats_) {
        seat->end(match::HostFailure{"interrupted while a team was awaited"});
      }
      return;
    }
    double left = absence_poll_interval;
    for (const auto& seat : seats_) {
      if (!awaits_other && !seat->has_answered()) left = std::min(left, seat->time_left());
    }
    listen(left);
  }
}

// Looks at both teams at once, so that the order of the seats decides nothing, and ends the seats
// if the leg ends.
Verdict MatchServer::judge_teams(bool all_have_answered) {
  match::ByTeam<Standing> teams{};
  for (const auto& seat : seats_) {
    teams[index_of(seat->team())] = all_have_answered ? seat->standing() : seat->look();
  }
  const Verdict verdict = judge_absences(teams, excused_->was_down(), seats_.front()->terms().away);
  for (const auto& seat : seats_) {
    if (verdict.is_hosts_fault) seat->end(*host_failure());
    if (verdict.lost[index_of(seat->team())]) seat->end(seat->disconnected());
  }
  return verdict;
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
  mirocup_v1_MatchEvent last{};
  last.layout = mirocup_v1_LAYOUT_NUMBER;
  last.leg = leg_;
  last.number = static_cast<std::uint32_t>(events_);
  last.tick = leg.tick();
  last.ends_match = true;
  copy_text(last.decision, "MATCH_END");
  copy_text(last.reason, to_string(leg.outcome().kind));
  for (const Team team : both_teams) {
    const int i = index_of(team);
    last.score[i] = static_cast<std::uint16_t>(leg.outcome().score[i]);
  }
  dds_write(event_writer_.get(), &last);
  dds_wait_for_acks(event_writer_.get(), farewell_timeout);
}

std::string MatchServer::reach() const {
  if (interface_ == "lo") return "; with --interface lo, the team must run on this computer";
  const int first = port_of(domain_.number, 0);
  const int last = port_of(domain_.number, server_ports - 1) + 1;
  const std::string here = "; this host's firewalls must let in UDP to ports " +
                           std::to_string(first) + "-" + std::to_string(last) + " of " + interface_;
  if (domain_.reply == Reply::to_source)
    return here + ", and a participant must receive at the port from which it sends";
  return here +
         ", and the team's firewalls must let in UDP from this host; no NAT may be between them "
         "without --nat";
}

}  // namespace mirocup::dds
