// SPDX-License-Identifier: MIT
#include "programs/coach/search.hpp"

#include <algorithm>

namespace mirocup::coach {

namespace {

constexpr int most_futures = 50;  // of a test

// Logarithms of ratios of likelihoods, in thousandths: ln(0.9 / 0.7) of a future that speaks for
// the likely end of the zone, ln(0.3 / 0.1) of one that speaks against it, ln(0.95 / 0.05) to
// decide.
constexpr int likely = 251;
constexpr int unlikely = 1099;
constexpr int enough = 2944;

}  // namespace

std::optional<bool> answer_of(Question question, const Share& share) {
  const int with = share.futures - share.without;
  const int weight = question == Question::prevention ? likely * share.without - unlikely * with
                                                      : unlikely * share.without - likely * with;
  if (weight >= enough) return true;
  if (weight <= -enough) return false;
  if (share.futures < most_futures) return std::nullopt;
  return share.value() >= limit_of(question);
}

std::optional<std::uint32_t> last_yes(std::uint32_t first, std::uint32_t end, std::uint32_t stride,
                                      const std::function<bool(std::uint32_t)>& ask) {
  if (first >= end) return std::nullopt;
  std::uint32_t no = end;
  std::uint32_t yes = end - 1;
  while (!ask(yes)) {
    if (yes == first) return std::nullopt;
    no = yes;
    yes -= std::min(stride, yes - first);
  }
  while (no - yes > 1) {
    const std::uint32_t middle = yes + (no - yes) / 2;
    (ask(middle) ? yes : no) = middle;
  }
  for (std::uint32_t tick = no + 1; tick < end && tick <= yes + stride; ++tick) {
    if (ask(tick)) yes = tick;
  }
  return yes;
}

}  // namespace mirocup::coach
