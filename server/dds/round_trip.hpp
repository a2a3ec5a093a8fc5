// SPDX-License-Identifier: MIT
//
// The time from a state to its answer, measured over the last few ticks. This time decides how soon
// the server repeats a state that has no answer.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace mirocup::dds {

class RoundTrip {
 public:
  // To be called when a tick's state is sent for the first time; `now` in s.
  void sent(std::uint32_t tick, double now) { sent_[tick % sent_.size()] = {tick, now, false}; }

  // To be called when a command to a tick has come. Returns the time from the tick's state to the
  // command, s. Returns nothing if the command is not the first to the tick, or if the tick is too
  // old.
  std::optional<double> answered(std::uint32_t tick, double now) {
    Sent& sent = sent_[tick % sent_.size()];
    if (sent.tick != tick || sent.is_answered) return std::nullopt;
    sent.is_answered = true;
    const double taken = std::max(0.0, now - sent.at);
    last_[count_++ % last_.size()] = taken;
    return taken;
  }

  // Returns the shortest time of the last 32 answers, s; 0 before the first answer. Longer times
  // may come from a state that was lost and sent again.
  double shortest() const {
    const std::size_t known = std::min(count_, last_.size());
    return known == 0 ? 0.0
                      : *std::min_element(last_.begin(),
                                          last_.begin() + static_cast<std::ptrdiff_t>(known));
  }

  // Returns the seconds until an unanswered state is sent again: 1.5 times the shortest time of an
  // answer, within the limits below.
  double resend_after() const {
    return std::clamp(1.5 * shortest(), min_resend_interval, max_resend_interval);
  }

  static constexpr double min_resend_interval = 0.005;  // s
  static constexpr double max_resend_interval = 0.1;    // a team leaves after four such times

 private:
  struct Sent {
    std::uint32_t tick = ~0U;
    double at = 0.0;
    bool is_answered = false;
  };
  std::array<Sent, 64> sent_{};
  std::array<double, 32> last_{};
  std::size_t count_ = 0;
};

}  // namespace mirocup::dds
