// SPDX-License-Identifier: MIT
//
// The wall time of a match that does not count as absence of a team, because the host is at fault:
// its network interface was down, or the server itself stood still. The class has only the rule:
// the caller passes the time and its observations.
#pragma once

#include <algorithm>
#include <optional>

namespace mirocup::dds {

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
