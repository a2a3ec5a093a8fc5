// SPDX-License-Identifier: MIT
//
// The checks in which the entry plays the same legs again in other surroundings, where a careful
// heap watches its memory.
#include "programs/check/examination.hpp"

#include <algorithm>
#include <utility>

namespace mirocup::app {

namespace {

// The leg that is repeated in other surroundings is played this far at most.
constexpr std::uint32_t max_repeated_ticks = 5000;

// The search for a cause goes on for this many ticks after the first difference, because two draws
// of a coarse number are often equal in one tick.
constexpr std::uint32_t ticks_after_difference = 100;

// Other surroundings. The time of day has other remainders than the one that every other leg begins
// with, whatever it is divided by.
// They go as in real time, which a wait of some seconds needs to be over; so far they are behind
// that they do not overtake the machine's.
constexpr plugins::ClockReadings other_clocks{
    .time_of_day = 1'234'567'891, .uptime_behind = 217, .between_calls = 33'000'000};
// A clock that counts how often it was read.
constexpr plugins::ClockReadings counting_clocks{.each_reading = 1000};
// The bytes with which unwritten memory is filled: zeros, ones, an even pattern, and a pattern that
// is odd, negative, and no small number in any type. Some mistakes show with one fill only: a bool
// is false with zeros alone. The knock-out leg, which is short, is played with the first three.
constexpr std::uint8_t fills_of_short_legs[] = {0x00, 0xFF, 0x5A};
constexpr std::uint8_t other_fill = 0xC3;
constexpr std::int32_t other_numbers = 4242;
constexpr plugins::Surroundings all_other{
    .clocks = other_clocks, .fixed_addresses = false, .number_offset = other_numbers};

// Returns the first tick in which the two legs differ; the hashes differ if the team asks for other
// poses at a restart.
std::optional<std::uint32_t> first_difference(const TrialLeg& one, const TrialLeg& other) {
  for (std::uint32_t i = 0; i < std::min(one.ticks(), other.ticks()); ++i)
    if (one.log[i].commands != other.log[i].commands || one.log[i].hash != other.log[i].hash)
      return i;
  return std::nullopt;
}

// A team that differs from itself where nothing has changed draws its own chance. Otherwise one
// thing is changed at a time; the careful heap is kept, because its addresses are others.
Result<std::string> cause_of_difference(Examination& e, const TrialTerms& terms,
                                        const TrialLeg& first) {
  e.plan.look_for_causes();
  const auto leg_in = [&](const plugins::Surroundings& surroundings, bool is_careful) {
    TrialTerms one = terms;
    one.max_seconds = e.plan.share_of(1);
    one.surroundings = surroundings;
    one.is_careful = is_careful;
    return play(e, one);
  };
  MIROCUP_TRY(const auto plain, leg_in({}, false));
  if (first_difference(first, plain)) {
    MIROCUP_TRY(const auto counted, leg_in({.clocks = counting_clocks}, false));
    MIROCUP_TRY(const auto counted_again, leg_in({.clocks = counting_clocks}, false));
    const char* const chance = e.entry->is_python() ? "depends python_chance" : "depends chance";
    return sentence(first_difference(counted, counted_again) ? chance : "depends clocks");
  }

  const std::pair<plugins::Surroundings, const char*> changes[] = {
      {{.clocks = other_clocks}, "depends clocks"},
      {{.memory_fill = other_fill}, "depends memory"},
      {{.number_offset = other_numbers}, "depends numbers"},
      {{.fixed_addresses = false}, "depends addresses"}};
  MIROCUP_TRY(const auto careful, leg_in({}, true));
  for (const auto& [surroundings, cause] : changes) {
    if (!e.plan.has_room_for(CheckPlan::shortest, 0, 1e-3 * e.report.mean_tick_ms)) break;
    MIROCUP_TRY(const auto leg, leg_in(surroundings, true));
    if (leg.fault || first_difference(careful, leg)) return sentence(cause);
  }
  return sentence("depends");
}

// Fails after a fault. A different answer is kept for the next check.
Result<Check> repeat_leg(Examination& e, TrialTerms terms, std::uint8_t fill,
                         const TrialLeg& first) {
  terms.is_careful = true;
  terms.surroundings = all_other;
  terms.surroundings.memory_fill = fill;
  MIROCUP_TRY(const auto again, play(e, terms));
  const Check right = passed(e.entry->is_python() ? "plays the same legs again without a fault"
                                                  : "writes only to memory of its own");
  if (is_memory_mistake(again)) return judge(e, again, terms, "");
  const auto tick = first_difference(first, again);
  // The last tick of a leg that ended by a fault has no answer.
  const bool is_fault = again.fault && (!tick || *tick + 1 >= again.ticks());
  if (is_fault && again.ticks() >= first.ticks()) return judge(e, again, terms, "");
  if (!is_fault && !tick) return right;
  const std::uint32_t at = is_fault ? again.ticks() : *tick;
  terms.max_ticks = at + ticks_after_difference;
  MIROCUP_TRY(const auto cause, cause_of_difference(e, terms, first));
  const std::string where = "tick " + std::to_string(at);
  if (is_fault) {
    note_use(e, again, terms);
    return failed(described(*again.fault) + ", but not when the same leg was played before", cause,
                  where);
  }
  e.difference =
      failed("to the same observations it answers differently in " + where, cause, where);
  return right;
}

// The knock-out leg, which has every phase of a match, and the leg as blue once more, where nothing
// is as it was but what the team may use.
Result<Check> repeat_elsewhere(Examination& e) {
  for (const std::uint8_t fill : fills_of_short_legs) {
    // The further fills are left out for a team that loads too slowly.
    const double tick = 1e-3 * e.report.mean_tick_ms;
    if (fill != fills_of_short_legs[0] && !e.plan.has_room_for(0.0, 1, tick)) continue;
    MIROCUP_TRY(const Check check,
                repeat_leg(e, knockout_terms(e, repeated_legs), fill, e.knockout));
    if (check.passed == false || e.difference) return check;
  }
  const double share = e.plan.share_of(1);
  return repeat_leg(e, {e.setup, &*e.striker, Team::blue, max_repeated_ticks, share}, other_fill,
                    e.whole[0]);
}

Result<Check> judge_repetition(Examination& e) {
  return e.difference ? *e.difference : passed(sentence("repeatable"));
}

}  // namespace

const std::vector<Step> repeat_checks{{"memory", repeat_elsewhere},
                                      {"repeatable", judge_repetition}};

}  // namespace mirocup::app
