// SPDX-License-Identifier: MIT
//
// The liveliness of a team that plays over the network. The class has only the rule: the caller
// passes each event with its wall time in seconds, so the class needs neither the network nor a
// clock.
//
// An absence begins when the team has been silent for `notice` seconds while a state waited for its
// answer, or when its process has left the network. An absence ends when the team answers again,
// also with a late answer. The absences of a leg are added up.
#pragma once

#include "core/match/snapshot.hpp"
#include "record/traffic.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace mirocup::dds {

// The verdict on a leg from the absences of both teams. The function has only the rule: the caller
// passes the state of the teams and of the host's network at one moment.
//
// A team whose absences together have lasted longer than the limit has lost. But a team that is
// away cannot win: the opponents win with their first sign of life after the loss. If the opponents
// are also away, the leg waits for them until their own limit is over; then neither team has won.
//
// Times are seconds of wall time since a common moment.

// A team at one moment.
struct Standing {
  // The time of the team's last command; nothing while the team is away. A team that does not play
  // over the network is always seen; its controller reports its faults.
  std::optional<double> seen = std::numeric_limits<double>::infinity();
  std::optional<double> lost_at;  // when the team's absences together exceeded the limit
};

struct Verdict {
  bool is_hosts_fault = false;
  match::ByTeam<bool> lost{};  // the teams that have lost
  bool awaits_other = false;  // one team would lose, but no command of the opponents has come since

  bool ends_leg() const { return is_hosts_fault || lost[0] || lost[1]; }
};

// `host_was_down` is the time for which the host's own network was down in this leg. Such time does
// not count as absence of a team. If the network was down for longer than `limit`, the leg is void.
Verdict judge_absences(const match::ByTeam<Standing>& teams, double host_was_down, double limit);

class Liveliness {
 public:
  // `limit`: the longest time of all absences of a leg together, s.
  Liveliness(double notice, double limit) : notice_(notice), limit_(limit) {}

  // To be called when the server begins to wait for the answer to a tick.
  void asked(double now) {
    if (!owes_) silent_since_ = now;
    owes_ = true;
  }

  // To be called when the answer to the present tick, `tick`, has come. Returns true if the team
  // was away.
  bool answered(std::uint32_t tick, double now);

  // To be called in the tick `present` when a late command to `tick` has come. `tick` is newer than
  // the ticks of all earlier commands. Returns true if the team was away.
  bool answered_late(std::uint32_t tick, std::uint32_t present, double now);

  // To be called when the answer to the present tick has come again. A team must answer whenever
  // the server sends the state again.
  void repeated(double now) {
    if (!owes_) silent_since_ = heard_ = now;
  }

  // To be called while no answer to the present tick, `tick`, has come. Returns true if the team is
  // away from this moment on. `has_left`: the team's process has left the network.
  bool silent(std::uint32_t tick, double now, bool has_left);

  bool is_away() const { return away_since_.has_value(); }

  // Returns how long the team has been away in this leg, s, the present absence included.
  double away(double now) const { return away_ + (away_since_ ? now - *away_since_ : 0.0); }

  // Returns whether the team is there at this moment, and whether it has lost by absence.
  Standing standing(double now) const;

  // Returns the first absences of the leg, at most 100.
  const std::vector<record::Absence>& absences() const { return absences_; }

 private:
  bool end_absence(std::uint32_t tick, double now);
  std::optional<double> lost_at(double now) const;

  double notice_;
  double limit_;
  bool owes_ = false;                   // a tick waits for the team's answer
  std::optional<double> silent_since_;  // empty before the first tick
  double heard_ = 0.0;
  std::uint32_t next_tick_ = 0;  // the tick after the last answered tick
  std::optional<double> away_since_;
  record::Absence present_;  // the absence that began at away_since_
  double away_ = 0.0;        // sum of the absences that are over, s
  std::optional<double> lost_at_;
  bool is_listed_ = false;
  std::vector<record::Absence> absences_;
};

// The wall time of a match that does not count as absence of a team, because the host is at fault:
// its network interface was down, or the server itself stood still. The class has only the rule:
// the caller passes the time and its observations.
class ExcusedTime {
 public:
  // `usual_step`: the longest time between two calls of look() by a server at work, s. The part of
  // a step beyond `usual_step` counts as a stall of the server.
  explicit ExcusedTime(double usual_step) : usual_step_(usual_step) {}

  // Notes the state at the moment `now`, s. `is_up`: the host's interface has a carrier and an
  // address. `any_heard`: a command of a team has come since the last look. If commands of one team
  // arrive, the network is not down, even if the interface seems down; a silent team is then away
  // by its own fault.
  void look(double now, bool is_up, bool any_heard) {
    const double step = last_ ? now - *last_ : 0.0;
    last_ = now;
    if (step > usual_step_) total_ += step - usual_step_;
    const double seen = std::min(step, usual_step_);
    if (any_heard) {
      recovering_ = 0.0;
    } else if (!is_up) {
      total_ += seen;
      was_down_ += seen;
      recovering_ = recovery;
    } else if (recovering_ > 0.0) {
      total_ += seen;
      recovering_ -= seen;
    }
  }

  double total() const { return total_; }        // s, of all causes
  double was_down() const { return was_down_; }  // s, while the interface was down

 private:
  // Seconds that the teams have, after the interface is up again, to find the server.
  static constexpr double recovery = 5.0;

  double usual_step_;
  std::optional<double> last_;
  double total_ = 0.0;
  double was_down_ = 0.0;
  double recovering_ = 0.0;
};

}  // namespace mirocup::dds
