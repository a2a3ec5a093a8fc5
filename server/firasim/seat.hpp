// SPDX-License-Identifier: MIT
//
// The seat of one team that speaks FIRASim's protocol: the sender that steers the team, and its
// last commands.
//
// In FIRASim every process may steer both colours. Here a colour belongs to the first address and
// port that sends commands for the colour. This sender may also own the other colour. If the owner
// of a colour has been silent for half of Terms::away, a sender without a colour may take the
// colour over. Placements come from another socket of the sender's host. The first such socket owns
// the placements of the colour, under the same rule.
//
// As in FIRASim, a robot drives its last command until a newer command comes. At a restart all
// robots of the team stop.
#pragma once

#include "core/match/controller.hpp"
#include "record/durations.hpp"
#include "record/traffic.hpp"
#include "server/firasim/convert.hpp"
#include "server/firasim/udp.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace mirocup::firasim {

// The terms on which a team joins and stays; times are seconds of a PatientClock.
struct Terms {
  // Longest time from the opening of the server to the team's first datagram.
  double to_join = 60.0;
  // The time in which a tick must be answered (real time). If empty, the match waits (lock-step).
  std::optional<double> tick;
  // A team that is silent for this long in play has lost. The silence begins with the team's last
  // datagram (real time) or with the vision that the team should answer (lock-step).
  double away = 10.0;
  // The longest time that a lock-step leg waits for this team in all, s.
  double longest = 1e9;
  // True: the team is whoever sends from its address, since some clients open a socket for each
  // datagram. False: others may be at the same address, so the port tells them apart.
  bool has_any_port = false;
  std::function<bool()> interrupted = [] { return false; };
  // If the team can no longer send, returns the reason; otherwise no value. `when` is the end of
  // the reason's sentence: "before it sent anything".
  std::function<std::optional<match::Answer>(const std::string& when)> why_gone = [](auto&) {
    return std::nullopt;
  };
  std::function<void(const std::string&)> tell = [](auto&) {};  // receives a sentence for the host
};

// Counts of datagrams by their fate; the record has these numbers.
struct Counts : record::DatagramCounts {
  std::uint64_t in_time = 0;   // ticks that were answered in time
  std::uint64_t held = 0;      // ticks in which the robots drove older commands
  std::uint64_t repeated = 0;  // commands to a robot that already had a command in this tick
  std::uint64_t foreign = 0;   // datagrams of another sender
  int senders = 0;
};

class Seat final : public match::Controller {
 public:
  Seat(const match::Briefing& briefing, std::string name, const Terms& terms,
       std::function<void()> settle);

  Team team() const { return briefing_.team; }

  void post(const match::Observation& observation) override;
  match::Answer collect() override;

  // For the server, which receives for both seats. `now` is the time of the server's PatientClock,
  // s.
  bool belongs_to(const Endpoint& sender) const { return is_one(sender_, sender); }
  bool has_sender() const { return sender_.has_value(); }
  bool is_placed_by(const Endpoint& sender) const { return is_one(placer_, sender); }
  // True if the sender steers the team, or begins to steer it with this datagram.
  bool let_in(const Endpoint& sender, double now);
  void take(const Packet& packet, double now);
  // False if the sender may not place the team.
  bool take(const TeamPlacement& placement, const Endpoint& sender, double now);
  Counts& counts() { return counts_; }
  const Counts& counts() const { return counts_; }

  // To be called when the vision of this step is sent. `restart`: the referee's call of a restart
  // is sent with the vision, so the team stops.
  void ask(std::uint32_t step, bool restart, double now);
  bool was_heard() const { return heard_at_.has_value(); }
  bool is_satisfied() const { return !awaits_placement() && !awaits_commands(); }
  bool awaits_placement() const;
  // Returns the time at which the server stops waiting for the team's answer to this tick.
  double deadline(double now) const;
  // Ends the wait for the team's answer to this tick.
  void give_up(double now);
  // Returns how long the team has been silent in play, s.
  double silent_for(double now) const;
  bool is_lost(double now) const { return silent_for(now) >= terms_.away; }
  // True if the leg has waited too long for this team in all.
  bool is_too_slow(double now) const { return waited_ + silent_for(now) > terms_.longest; }
  match::Fault too_slow() const;
  void end(match::Answer how) { end_ = end_ ? std::move(end_) : std::move(how); }
  const Terms& terms() const { return terms_; }
  // `commands_at` names the address that receives commands.
  match::Fault disconnected(const std::string& commands_at) const;

  const std::vector<record::Absence>& absences() const { return absences_; }
  const record::Durations& answers() const { return answers_; }

 private:
  bool is_one(const std::optional<Endpoint>& known, const Endpoint& sender) const {
    return known && known->address == sender.address &&
           (terms_.has_any_port || known->port == sender.port);
  }
  bool awaits_commands() const;
  referee::RobotSet commanded() const;  // robots with a command in this tick
  bool leaves_robots_out(double now) const;
  double unheard_for(double now) const;
  bool may_be_replaced(double now) const;
  void heard(double now);
  void note_answer(double now);

  match::Briefing briefing_;
  std::string name_;
  Terms terms_;
  std::function<void()> settle_;

  std::optional<Endpoint> sender_, placer_;
  std::optional<double> heard_at_;
  match::Observation observation_;
  std::uint32_t step_ = 0;
  double asked_at_ = 0.0;
  double waited_ = 0.0;                     // in all ticks before, s
  std::optional<double> first_command_at_;  // time of the first command of this tick
  bool gave_up_ = false;
  bool has_answered_ = false;

  std::array<simulator::WheelSpeeds, max_robots_per_team> wheels_{};
  // Number of commands to each robot in this tick.
  std::array<int, max_robots_per_team> commands_{};
  referee::RobotSet ever_commanded_;
  // True: the team never commands some robots, and ticks wait only for `ever_commanded_`.
  bool only_ever_commanded_ = false;
  int partial_ticks_ = 0;       // ticks whose wait ended with commands for only some robots
  int silent_ready_ticks_ = 0;  // ticks in READY without a command, in a row
  int missing_placements_ = 0;  // in a row
  std::optional<TeamPlacement> placement_;  // the last placement since the last restart was called
  bool may_place_ = false;                  // true: the team may place in this tick

  Counts counts_;
  std::vector<record::Absence> absences_;
  record::Durations answers_;
  std::optional<match::Answer> end_;
};

}  // namespace mirocup::firasim
