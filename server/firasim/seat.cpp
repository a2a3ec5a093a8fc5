// SPDX-License-Identifier: MIT
#include "server/firasim/seat.hpp"

#include <algorithm>
#include <cmath>

namespace mirocup::firasim {

namespace {

// In lock-step a team leaves robots out if it has commanded another one three times, to copies of
// the vision, for at least the first time (s), or not at all within the second; after so many ticks
// of that kind it is waited for no longer than the third.
constexpr int copies_to_tell = 3;
constexpr double partial_patience = 0.5;
constexpr double longest_partial_patience = 5.0;
constexpr int partial_ticks_to_tell = 10;
constexpr double short_partial_patience = 0.02;

// In lock-step, how long a team that stands still before the whistle is waited for, s; and how
// often in a row in vain, before it is waited for no longer.
constexpr double ready_patience = 3.0;
constexpr int ready_tries = 2;

// How long a placement is waited for, in real time and in lock-step, s; and how often in vain.
constexpr double placement_patience = 0.25;
constexpr double lockstep_placement_patience = 3.0;
constexpr int placement_tries = 2;

// A team whose sender has changed so often sends each command from another socket.
constexpr int most_senders = 10;

// The record lists no more.
constexpr std::size_t max_absences = 100;
// Silence that counts as an absence, s.
constexpr double absence = 1.0;

}  // namespace

Seat::Seat(const match::Briefing& briefing, std::string name, const Terms& terms,
           std::function<void()> settle)
    : briefing_(briefing), name_(std::move(name)), terms_(terms), settle_(std::move(settle)) {}

// In lock-step a team that has answered, or has not been asked, owes nothing.
double Seat::unheard_for(double now) const {
  if (!heard_at_) return 0.0;
  if (terms_.tick) return now - *heard_at_;
  return has_answered_ || first_command_at_ ? 0.0 : now - asked_at_;
}

bool Seat::may_be_replaced(double now) const {
  return heard_at_ && unheard_for(now) >= terms_.away / 2.0;
}

bool Seat::let_in(const Endpoint& sender, double now) {
  if (belongs_to(sender)) return true;
  if (sender_ && !may_be_replaced(now)) return false;
  terms_.tell(std::string(to_string(team())) + " \"" + name_ + "\" is steered from " +
              to_text(sender));
  sender_ = sender;
  if (++counts_.senders > most_senders) {
    end(match::Fault{match::FaultCode::disconnected,
                     "the team sends its commands from ever new sockets, which cannot be told from "
                     "those of others here: let it keep one socket"});
  }
  return true;
}

void Seat::heard(double now) {
  heard_at_ = now;
  if (absences_.empty() || absences_.back().back) return;
  absences_.back().back = observation_.tick;
}

void Seat::take(const Packet& packet, double now) {
  heard(now);
  // In lock-step the first whole answer counts. What follows it is a copy, or comes too late.
  const bool is_stale = (packet.step && *packet.step != step_) || (!terms_.tick && has_answered_);
  if (is_stale) ++counts_.stale;
  for (const WheelCommand& command : packet.commands) {
    const auto robots = static_cast<std::uint32_t>(briefing_.field->robots_per_team);
    if (command.team != team()) {
      ++counts_.foreign;
    } else if (command.id >= robots) {
      ++counts_.unknown_robots;
    } else if (!std::isfinite(command.left) || !std::isfinite(command.right)) {
      ++counts_.not_finite;
    } else {
      ever_commanded_.set(command.id);
      if (is_stale) continue;
      if (commands_[command.id]++ > 0) ++counts_.repeated;
      wheels_[command.id] = to_wheels(command.left, command.right, *briefing_.parameters);
      if (!first_command_at_) first_command_at_ = now;
    }
  }
  if (!awaits_commands()) note_answer(now);
}

void Seat::note_answer(double now) {
  if (has_answered_) return;
  has_answered_ = true;
  if (observation_.state == match::State::READY) silent_ready_ticks_ = 0;
  if (asked_at_ <= 0.0) return;
  answers_.add(now - asked_at_);
  waited_ += now - asked_at_;
}

bool Seat::take(const TeamPlacement& placement, const Endpoint& sender, double now) {
  // A program's commands and placements may leave its host by interfaces with different addresses.
  const bool is_of_another_host = sender_ && sender_->address != sender.address &&
                                  !(is_of_this_host(*sender_) && is_of_this_host(sender));
  const bool is_another = placer_ && !is_placed_by(sender) && !may_be_replaced(now);
  if (is_of_another_host || is_another) {
    ++counts_.foreign;
    return false;
  }
  placer_ = sender;
  ++counts_.placements;
  missing_placements_ = 0;
  placement_ = placement;  // the last one counts
  heard(now);
  return true;
}

void Seat::ask(std::uint32_t step, bool restart, double now) {
  step_ = step;
  asked_at_ = now;
  first_command_at_.reset();
  commands_ = {};
  gave_up_ = false;
  has_answered_ = false;
  may_place_ = false;
  if (!restart) return;
  placement_.reset();
  wheels_ = {};
}

void Seat::post(const match::Observation& observation) {
  observation_ = observation;
  may_place_ = observation.placing;
}

bool Seat::awaits_commands() const {
  if (gave_up_ || end_) return false;
  const bool is_ready = observation_.state == match::State::READY;
  if (is_ready && !terms_.tick && silent_ready_ticks_ >= ready_tries) return false;
  referee::RobotSet all;
  for (int i = 0; i < briefing_.field->robots_per_team; ++i) all.set(i);
  const referee::RobotSet awaited = only_ever_commanded_ ? ever_commanded_ : all;
  return (awaited & ~commanded()).any();
}

referee::RobotSet Seat::commanded() const {
  referee::RobotSet robots;
  for (std::size_t i = 0; i < commands_.size(); ++i) robots[i] = commands_[i] > 0;
  return robots;
}

bool Seat::leaves_robots_out(double now) const {
  const double waited = now - *first_command_at_;
  const int most = *std::max_element(commands_.begin(), commands_.end());
  return waited >= partial_patience && most >= copies_to_tell;
}

bool Seat::awaits_placement() const {
  return may_place_ && !placement_ && !gave_up_ && !end_ && missing_placements_ < placement_tries;
}

double Seat::deadline(double now) const {
  double wait = 0.0;
  if (awaits_placement()) {
    wait = terms_.tick ? std::max(*terms_.tick, placement_patience) : lockstep_placement_patience;
  }
  if (!awaits_commands()) return asked_at_ + wait;
  if (terms_.tick) return asked_at_ + std::max(wait, *terms_.tick);
  if (first_command_at_) {
    const bool is_habit = partial_ticks_ >= partial_ticks_to_tell;
    const double patience = is_habit                 ? short_partial_patience
                            : leaves_robots_out(now) ? 0.0
                                                     : longest_partial_patience;
    return std::max(*first_command_at_ + patience, asked_at_ + wait);
  }
  const bool is_ready = observation_.state == match::State::READY;
  return asked_at_ + std::max(wait, is_ready ? ready_patience : terms_.away);
}

void Seat::give_up(double now) {
  if (gave_up_) return;
  if (awaits_placement()) ++missing_placements_;
  if (awaits_commands()) {
    if (!terms_.tick && first_command_at_) {
      only_ever_commanded_ = true;
      ever_commanded_ = commanded();
      ++partial_ticks_;
    }
    if (observation_.state == match::State::READY && !first_command_at_) ++silent_ready_ticks_;
  }
  const double silence = silent_for(now);
  gave_up_ = true;
  const bool is_new = absences_.empty() || absences_.back().back;
  if (silence < absence || !is_new || absences_.size() == max_absences) return;
  absences_.push_back({.tick = observation_.tick,
                       .noticed = observation_.tick,
                       .back = std::nullopt,
                       .has_left = false});
}

// Before the whistle a team may well say nothing, and after its answer it has nothing to say.
double Seat::silent_for(double now) const {
  if (!awaits_commands() || observation_.state == match::State::READY) return 0.0;
  return unheard_for(now);
}

match::Fault Seat::disconnected(const std::string& commands_at) const {
  std::string why = terms_.tick ? "the team sent nothing" : "the team answered nothing";
  if (!sender_) why = "the team placed its robots, but no command came to " + commands_at;
  why += " for " + std::to_string(static_cast<int>(terms_.away)) + " s";
  return {match::FaultCode::disconnected, why};
}

match::Fault Seat::too_slow() const {
  return {match::FaultCode::disconnected,
          "the match has waited " + std::to_string(static_cast<int>(terms_.longest)) +
              " s for the team in all, which gave " + std::to_string(counts_.in_time) +
              " answers; without lock-step a match does not wait"};
}

match::Answer Seat::collect() {
  settle_();
  if (end_) return *end_;
  match::Command command;
  command.wheels = wheels_;
  if (may_place_ && placement_) command.placement = to_request(*placement_, observation_);
  if (has_answered_) {
    ++counts_.in_time;
    return command;
  }
  ++counts_.held;
  // A team that is not waited for before the whistle is not late.
  if (observation_.state == match::State::READY) return command;
  return match::Late{.older = command};
}

}  // namespace mirocup::firasim
