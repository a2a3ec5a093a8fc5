// SPDX-License-Identifier: MIT
#include "server/firasim/server.hpp"

#include <cmath>
#include <poll.h>

namespace mirocup::firasim {

namespace {

// A flood must not keep the server from its tick: so many datagrams of a team are read at once, and
// so many of all others.
constexpr int most_of_a_team = 4096;
constexpr int most_of_others = 512;

// A vision that nobody has answered is sent again after this, s: it may be lost.
constexpr double resend_after = 0.25;
constexpr double resend_before_play = 0.1;

// Old answers have arrived when nothing has come for this, s; a client that sends without end is
// not waited for longer than the second number.
constexpr double quiet = 0.03;
constexpr double longest_drain = 0.5;

constexpr double interrupt_poll = 0.1;  // s
static_assert(interrupt_poll < PatientClock::most_at_once);

// A team that has been silent for this long is looked after, s.
constexpr double looked_after = 1.0;

std::string port_of(int instance, int first) {
  return ":" + std::to_string(first + instance);
}

}  // namespace

Result<Addresses> addresses_of(int instance, const Addresses& changes) {
  if (instance < 0 || instance > 9999)
    return fail(Errc::input, "--firasim-instance " + std::to_string(instance) +
                                 ": a number from 0 to 9999 is expected");
  Addresses all{.vision = "224.0.0.1" + port_of(instance, 10002),
                .referee = "224.5.23.2" + (instance == 0 ? ":10003" : port_of(instance, 40000)),
                .command = port_of(instance, 20011).substr(1),
                .placement = "224.5.23.2" + (instance == 0 ? ":10004" : port_of(instance, 50000)),
                .interface = changes.interface};
  if (!changes.vision.empty()) all.vision = changes.vision;
  if (!changes.referee.empty()) all.referee = changes.referee;
  if (!changes.command.empty()) all.command = changes.command;
  if (!changes.placement.empty()) all.placement = changes.placement;
  return all;
}

Result<std::unique_ptr<Server>> Server::open(const Addresses& a) {
  MIROCUP_TRY(const auto vision_to, parse_endpoints(a.vision, "--firasim-vision"));
  MIROCUP_TRY(const auto referee_to, parse_endpoints(a.referee, "--firasim-referee"));
  const bool has_address = a.command.find(':') != std::string::npos;
  MIROCUP_TRY(
      const auto commands_at,
      parse_endpoint(has_address ? a.command : "0.0.0.0:" + a.command, "--firasim-command"));
  MIROCUP_TRY(const auto placements_at, parse_endpoint(a.placement, "--firasim-placement"));

  MIROCUP_TRY(auto vision, Sender::open(vision_to, a.interface));
  MIROCUP_TRY(auto referee, Sender::open(referee_to, a.interface));
  MIROCUP_TRY(auto commands, Receiver::open(commands_at, a.interface, "--firasim-command"));
  MIROCUP_TRY(auto placements, Receiver::open(placements_at, a.interface, "--firasim-placement"));
  std::unique_ptr<Server> server(new Server(std::move(vision), std::move(referee),
                                            std::move(commands), std::move(placements)));
  server->is_only_for_this_host_ = !has_address && a.interface == this_host;
  server->commands_at_ = "port " + std::to_string(commands_at.port);
  return server;
}

Server::Server(Sender vision, Sender referee, Receiver commands, Receiver placements)
    : vision_(std::move(vision)),
      referee_(std::move(referee)),
      commands_(std::move(commands)),
      placements_(std::move(placements)) {}

Seat* Server::add_seat(const match::Briefing& briefing, const std::string& name,
                       const Terms& terms) {
  auto seat = std::make_unique<Seat>(briefing, name, terms, [this] { settle(); });
  places_.push_back({.seat = std::move(seat), .commands = {}, .placements = {}});
  return places_.back().seat.get();
}

Server::Place* Server::place_of(Team team) {
  for (Place& place : places_) {
    if (place.seat->team() == team) return &place;
  }
  return nullptr;
}

tl::expected<void, match::Answer> Server::wait_until_ready(const Seat& seat,
                                                           const match::Leg& leg) {
  const double begun = clock_.now();
  double sent = 0.0;
  const Terms& terms = seat.terms();
  while (!seat.was_heard()) {
    const double now = clock_.now();
    if (terms.interrupted())
      return tl::unexpected<match::Answer>(
          match::HostFailure{"interrupted while a team was awaited"});
    if (auto why = terms.why_gone("before it sent anything"))
      return tl::unexpected(std::move(*why));
    if (now - begun > terms.to_join) {
      return tl::unexpected<match::Answer>(
          match::Fault{match::FaultCode::start_timeout,
                       "the team sent no command and no placement within " +
                           std::to_string(static_cast<int>(std::ceil(terms.to_join))) + " s" +
                           (refused_.empty() ? "" : "; not taken: " + refused_)});
    }
    if (now - sent >= resend_before_play) {
      if (!called_) call(leg);
      sent_vision_ = encode(to_vision(leg));
      vision_.send(sent_vision_);
      if (!sent_call_.empty()) referee_.send(sent_call_);
      sent = now;
    }
    wait(resend_before_play);
    receive(clock_.now());
  }
  was_sent_again_ = true;  // so the first tick starts when all answers to this have come
  return {};
}

void Server::publish(const match::Leg& leg) {
  drain();
  const double now = clock_.now();
  call(leg);
  const Vision vision = to_vision(leg);
  for (const Place& place : places_) place.seat->ask(vision.step, is_new_call_, now);
  is_new_call_ = false;
  sent_vision_ = encode(vision);
  vision_.send(sent_vision_);
  is_settled_ = false;
}

// The referee speaks once for each change: a call, STOP when the teams have placed their robots,
// GAME_ON when play begins.
void Server::call(const match::Leg& leg) {
  const match::LoggedDecision* restart = nullptr;
  for (; decisions_ < leg.decisions().size(); ++decisions_) {
    const match::LoggedDecision& decision = leg.decisions()[decisions_];
    if (decision.decision.restart != referee::Restart::none) restart = &decision;
  }
  if (restart != nullptr) {
    is_new_call_ = true;
    called_at_ = leg.tick();
    send_call(to_command(leg, *restart));
    return;
  }
  const match::Snapshot now = leg.view();
  if (now.state == match::State::PLAY) {
    if (called_ != Foul::GAME_ON) send_call(to_command(leg, Foul::GAME_ON));
    return;
  }
  const double since = (leg.tick() - called_at_) * leg.setup().control_period;
  const bool is_half_time = since >= leg.setup().rules.ready_s / 2.0;
  if (called_ != Foul::STOP && !now.placing && is_half_time) send_call(to_command(leg, Foul::STOP));
}

void Server::send_call(const RefereeCommand& command) {
  called_ = command.foul;
  sent_call_ = encode(command);
  referee_.send(sent_call_);
}

void Server::close(const match::Leg& leg) {
  vision_.send(encode(to_vision(leg)));
  send_call(to_command(leg, Foul::HALT));
}

void Server::wait(double seconds) const {
  std::vector<pollfd> sockets{{commands_.descriptor(), POLLIN, 0},
                              {placements_.descriptor(), POLLIN, 0}};
  for (const Place& place : places_) {
    for (const auto& line : {&place.commands, &place.placements}) {
      if (*line) sockets.push_back({(*line)->descriptor(), POLLIN, 0});
    }
  }
  timespec limit{};
  limit.tv_sec = static_cast<time_t>(std::max(0.0, seconds));
  limit.tv_nsec =
      static_cast<long>(1e9 * (std::max(0.0, seconds) - static_cast<double>(limit.tv_sec)));
  ppoll(sockets.data(), sockets.size(), &limit, nullptr);
}

// Returns true if a team has sent anything.
bool Server::receive(double now) {
  bool any = false;
  Receiver::Datagram datagram;
  for (Place& place : places_) {
    // The line is looked at anew each time: another sender may have taken the seat.
    for (int i = 0; i < most_of_a_team && place.placements; ++i) {
      if (!place.placements->receive(datagram)) break;
      any = take_placement(datagram, now) || any;
    }
    for (int i = 0; i < most_of_a_team && place.commands; ++i) {
      if (!place.commands->receive(datagram)) break;
      any = take_packet(datagram, now) || any;
    }
  }
  for (int i = 0; i < most_of_others && placements_.receive(datagram); ++i) {
    if (!has_own_line(datagram.from)) any = take_placement(datagram, now) || any;
  }
  for (int i = 0; i < most_of_others && commands_.receive(datagram); ++i) {
    if (is_only_for_this_host_ && !is_of_this_host(datagram.from)) {
      ++strangers_.foreign;
      refuse(datagram.from, "is another host; --interface lets other hosts take part");
      continue;
    }
    any = take_packet(datagram, now) || any;
  }
  return any;
}

void Server::refuse(const Endpoint& from, const std::string& why) {
  const bool is_first = refused_.empty();
  refused_ = to_text(from) + " " + why;
  if (is_first && !places_.empty()) {
    places_.front().seat->terms().tell("a datagram is not taken: " + refused_);
  }
}

// What is sent to a group arrives at all sockets.
bool Server::has_own_line(const Endpoint& placer) const {
  return std::any_of(places_.begin(), places_.end(), [&](const Place& place) {
    return place.placements && place.seat->is_placed_by(placer);
  });
}

// Seats the sender of commands for a colour that is free, also if it has the other one: FIRASim's
// programs may steer both from one socket.
void Server::let_in(const Endpoint& sender, Team team, double now) {
  Place* wanted = place_of(team);
  const std::string colour(to_string(team));
  if (wanted == nullptr) {
    refuse(sender, "sent commands for " + colour + ", which no program plays here");
  } else if (!wanted->seat->belongs_to(sender)) {
    const bool has_other = has_seat(sender);
    if ((has_other && wanted->seat->has_sender()) || !wanted->seat->let_in(sender, now)) {
      refuse(sender, "sent commands for " + colour + ", which another socket steers");
      return;
    }
    wanted->commands.reset();
    if (has_other) return;  // the one line brings both
    if (wanted->seat->terms().has_any_port) return;
    if (auto line = commands_.only_from(sender)) wanted->commands = std::move(*line);
  }
}

bool Server::has_seat(const Endpoint& sender) const {
  return std::any_of(places_.begin(), places_.end(),
                     [&](const Place& place) { return place.seat->belongs_to(sender); });
}

// Counts the datagram for the seats of its sender, or for strangers if the sender has none. Returns
// true if the sender has a seat.
bool Server::take_packet(const Receiver::Datagram& datagram, double now) {
  auto packet = decode_packet(datagram.bytes);
  if (packet) {
    for (const Team team : both_teams) {
      const auto is_of = [team](const WheelCommand& c) { return c.team == team; };
      if (std::any_of(packet->commands.begin(), packet->commands.end(), is_of)) {
        let_in(datagram.from, team, now);
      }
    }
  }
  bool any = false;
  for (const Place& place : places_) {
    if (!place.seat->belongs_to(datagram.from)) continue;
    any = true;
    Counts& counts = place.seat->counts();
    if (!packet) {
      ++counts.malformed;
      continue;
    }
    if (packet->has_replacement) ++counts.replacements;
    ++counts.received;
    const Team other = opponent_of(place.seat->team());
    const Place* both = place_of(other);
    Packet own = *packet;
    if (both != nullptr && both->seat->belongs_to(datagram.from)) {
      std::erase_if(own.commands, [other](const WheelCommand& c) { return c.team == other; });
    }
    if (!own.commands.empty()) place.seat->take(own, now);
  }
  if (any) return true;
  if (!packet) {
    ++strangers_.malformed;
    refuse(datagram.from, "sent a datagram that is not a Packet of FIRASim");
    return false;
  }
  if (packet->has_replacement) ++strangers_.replacements;
  ++strangers_.foreign;
  return false;
}

bool Server::take_placement(const Receiver::Datagram& datagram, double now) {
  const auto placement = decode_placement(datagram.bytes);
  if (!placement) {
    ++strangers_.malformed;
    return false;
  }
  Place* place = place_of(placement->team);
  if (place == nullptr) {
    ++strangers_.foreign;
    return false;
  }
  const bool is_known = place->seat->is_placed_by(datagram.from);
  if (!place->seat->take(*placement, datagram.from, now)) {
    refuse(datagram.from, "sent a placement of " + std::string(to_string(placement->team)) +
                              ", whose placements come from another sender");
    return false;
  }
  if (!is_known) place->placements.reset();
  if (has_own_line(datagram.from) || place->seat->terms().has_any_port) return true;
  if (auto line = placements_.only_from(datagram.from)) place->placements = std::move(*line);
  return true;
}

// Commands that came too late for the last vision would be taken for answers to the next one. In
// real time they are the newest that the team has said, and count until the next ones come.
void Server::drain() {
  const double begun = clock_.now();
  receive(begun);
  if (!std::exchange(was_sent_again_, false)) return;
  double heard = begun;
  for (double now = begun; now - begun < longest_drain && now - heard < quiet; now = clock_.now()) {
    wait(heard + quiet - now);
    if (receive(clock_.now())) heard = clock_.now();
  }
}

// A team that is waited for may not have got the vision, or the call that its placement answers.
void Server::resend() {
  vision_.send(sent_vision_);
  was_sent_again_ = true;
  const bool places = std::any_of(places_.begin(), places_.end(), [](const Place& place) {
    return place.seat->awaits_placement();
  });
  if (places) referee_.send(sent_call_);
}

void Server::settle() {
  if (std::exchange(is_settled_, true)) return;
  double sent = clock_.now();
  while (true) {
    const double now = clock_.now();
    receive(now);
    end_the_lost(now);
    double until = now + interrupt_poll;
    bool all = true;
    for (const Place& place : places_) {
      Seat& seat = *place.seat;
      if (!seat.is_satisfied() && now >= seat.deadline(now)) seat.give_up(now);
      if (seat.is_satisfied()) continue;
      all = false;
      until = std::min(until, seat.deadline(now));
    }
    if (all) return;
    const Terms& terms = places_.front().seat->terms();
    if (terms.interrupted()) {
      for (const Place& place : places_) {
        place.seat->end(match::HostFailure{"interrupted while a team was awaited"});
      }
      return;
    }
    if (!terms.tick && now - sent >= resend_after) {
      resend();
      sent = now;
    }
    wait(until - now);
  }
}

// A team is lost when its program has ended, or when it has been silent for too long in play.
// Nobody wins who is not there either: in real time, the other one is lost with it if it has been
// silent for half as long. In lock-step both are asked at one moment, so both are silent alike.
void Server::end_the_lost(double now) {
  for (const Place& place : places_) {
    Seat& seat = *place.seat;
    if (!seat.terms().tick && seat.is_too_slow(now)) seat.end(seat.too_slow());
    if (seat.silent_for(now) < looked_after) continue;
    if (auto why = seat.terms().why_gone("before the leg was over")) seat.end(std::move(*why));
  }
  const bool any = std::any_of(places_.begin(), places_.end(),
                               [&](const Place& place) { return place.seat->is_lost(now); });
  if (!any) return;
  for (const Place& place : places_) {
    Seat& seat = *place.seat;
    const double share = seat.terms().tick ? 0.5 : 1.0;
    if (seat.silent_for(now) >= share * seat.terms().away)
      seat.end(seat.disconnected(commands_at_));
  }
}

}  // namespace mirocup::firasim
