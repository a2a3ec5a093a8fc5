// SPDX-License-Identifier: MIT
//
// The search for the last moment at which a goal could be prevented. It knows neither processes nor
// legs: it asks about ticks, and counts futures that somebody else plays.
//
// All sums are of integers and the futures of a moment count in the order of their numbers, so the
// answer is the same on every machine.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

namespace mirocup::coach {

// The futures of one moment.
struct Share {
  int without = 0;  // those without the goal
  int futures = 0;

  void add(bool is_without_goal) {
    ++futures;
    without += is_without_goal ? 1 : 0;
  }
  double value() const { return futures > 0 ? static_cast<double>(without) / futures : 0.0; }
};

// The two questions about a moment: whether the goal can be prevented, in at least 8 of 10 futures,
// and whether there is hope, in more than 2 of 10.
enum class Question { prevention, hope };
constexpr double limit_of(Question question) {
  return question == Question::prevention ? 0.8 : 0.2;
}

// Wald's sequential test of a question: returns the answer, or nothing until enough futures are
// counted. The test tells a chance that is 0.1 above the limit from a chance that is 0.1 below, and
// is wrong about either with a probability of at most 8 %. After 50 futures the share decides.
std::optional<bool> answer_of(Question question, const Share& share);

// Returns the last tick from `first` on and before `end` for which `ask` says yes; nothing if there
// is none. Goes back in steps of `stride` ticks from the end to a yes, halves the step between this
// yes and the no after it, and at last asks about each tick of the stride after the yes, because a
// later yes may follow a no.
std::optional<std::uint32_t> last_yes(std::uint32_t first, std::uint32_t end, std::uint32_t stride,
                                      const std::function<bool(std::uint32_t)>& ask);

}  // namespace mirocup::coach
