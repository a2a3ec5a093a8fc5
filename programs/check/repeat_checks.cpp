// SPDX-License-Identifier: MIT
//
// The checks in which the entry plays the same legs again in other surroundings, where a careful
// heap watches its memory.
#include "programs/check/examination.hpp"

#include <algorithm>
#include <utility>

namespace mirocup::app {

namespace {

using plugins::Surroundings;

// The leg that is repeated in other surroundings is played this far at most.
constexpr std::uint32_t max_repeated_ticks = 6000;

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
constexpr std::uint8_t other_fill = 0xC3;  // odd, negative, and no small number in any type
constexpr std::int32_t other_numbers = 4242;
constexpr Surroundings all_other{.clocks = other_clocks,
                                 .fixed_addresses = false,
                                 .memory_fill = other_fill,
                                 .number_offset = other_numbers};

constexpr const char* depends_on_clock =
    "it depends on a clock: take random numbers from setup.seed and the time from now.time, and "
    "end a search after a number of steps";

// Returns the first tick in which the two legs differ; the hashes differ if the team asks for other
// poses at a restart.
std::optional<std::ptrdiff_t> first_difference(const TrialLeg& one, const TrialLeg& other) {
  const auto differs =
      std::mismatch(one.log.begin(), one.log.end(), other.log.begin(), other.log.end(),
                    [](const match::TickLog& a, const match::TickLog& b) {
                      return a.commands == b.commands && a.hash == b.hash;
                    });
  if (differs.first == one.log.end() || differs.second == other.log.end()) return std::nullopt;
  return differs.first - one.log.begin();
}

// A team that differs from itself where nothing has changed draws its own chance. Otherwise one
// thing is changed at a time; the careful heap is kept, because its addresses are others.
Result<std::string> cause_of_difference(Examination& e, const TrialTerms& terms,
                                        const TrialLeg& first) {
  e.plan.look_for_causes();
  const auto leg_in = [&](const Surroundings& surroundings, bool is_careful) {
    TrialTerms one = terms;
    one.max_seconds = e.plan.share_of(1);
    one.surroundings = surroundings;
    one.is_careful = is_careful;
    return play(e, one);
  };
  MIROCUP_TRY(const auto plain, leg_in({}, false));
  Surroundings counting;
  counting.clocks = counting_clocks;
  if (first_difference(first, plain)) {
    MIROCUP_TRY(const auto counted, leg_in(counting, false));
    MIROCUP_TRY(const auto counted_again, leg_in(counting, false));
    if (!first_difference(counted, counted_again)) return std::string(depends_on_clock);
    return std::string(
        e.entry->is_python()
            ? "it has random numbers of its own: take them from the module random, which "
              "setup.seed has seeded, and not from clocks, os.urandom() or default_rng()"
            : "it has random numbers of its own, such as from std::random_device: take them from "
              "setup.seed");
  }

  Surroundings clocks, memory, numbers, addresses;
  clocks.clocks = other_clocks;
  memory.memory_fill = other_fill;
  numbers.number_offset = other_numbers;
  addresses.fixed_addresses = false;
  const std::pair<Surroundings, const char*> changes[] = {
      {clocks, depends_on_clock},
      {memory,
       "it depends on memory that was never written, that was freed, or that is not its own: give "
       "each variable and member a value, look for an index out of bounds, and keep no pointer to "
       "memory that is gone after the call"},
      {numbers,
       "it depends on the number of its process, thread or processor: take random numbers from "
       "setup.seed"},
      {addresses,
       "it depends on addresses, such as the order of pointers in a set: compare numbers instead"}};
  MIROCUP_TRY(const auto careful, leg_in({}, true));
  for (const auto& [surroundings, cause] : changes) {
    if (!e.plan.has_room_for(CheckPlan::shortest, 0)) break;
    MIROCUP_TRY(const auto leg, leg_in(surroundings, true));
    if (leg.fault || first_difference(careful, leg)) return std::string(cause);
  }
  return std::string(
      "take random numbers from setup.seed, and use no clocks, no addresses and no memory that was "
      "never written");
}

// Returns false after a fault or a different answer, which is added.
Result<bool> repeat_leg(Examination& e, const TrialTerms& terms_of_first, const TrialLeg& first) {
  TrialTerms terms = terms_of_first;
  terms.is_careful = true;
  terms.surroundings = all_other;
  MIROCUP_TRY(const auto again, play(e, terms));
  e.requests += again.requests;
  if (again.fault && is_memory_mistake(again.fault->fault)) return judge(e, again, terms, "");
  const auto tick = first_difference(first, again);
  // The last tick of a leg that ended by a fault has no answer.
  if (again.fault && (!tick || *tick + 1 >= std::ssize(again.log))) {
    if (again.ticks() >= first.ticks()) return judge(e, again, terms, "");
    terms.max_ticks = again.ticks() + ticks_after_difference;
    MIROCUP_TRY(const auto cause, cause_of_difference(e, terms, first));
    note_use(e, again, terms);
    return fail_with(e, {.what = again.fault->fault.text + " (" +
                                 std::string(to_string(again.fault->fault.code)) +
                                 "), but not when the same leg was played before",
                         .where = "tick " + std::to_string(again.ticks()),
                         .cure = cause});
  }
  if (!tick) return true;
  terms.max_ticks = static_cast<std::uint32_t>(*tick) + ticks_after_difference;
  MIROCUP_TRY(const auto cause, cause_of_difference(e, terms, first));
  pass(e, "writes only to memory of its own");
  const std::string number = std::to_string(*tick);
  return fail_with(e, {.what = "to the same observations it answers differently in tick " + number,
                       .where = "tick " + number,
                       .cure = cause});
}

}  // namespace

// The knock-out leg, which has every phase of a match, and the leg as blue once more, where nothing
// is as it was but what the team may use.
Result<bool> repeat_elsewhere(Examination& e) {
  TrialTerms terms_of_short_one = knockout_terms(e);
  terms_of_short_one.max_seconds = e.plan.share_of(repeated_legs);
  const auto short_one = repeat_leg(e, terms_of_short_one, e.knockout);
  if (!short_one || !*short_one) return short_one;
  TrialTerms terms = trial(e, Team::blue, *e.striker);
  terms.max_ticks = max_repeated_ticks;
  terms.max_seconds = e.plan.share_of(1);
  const auto long_one = repeat_leg(e, terms, e.blue);
  if (!long_one || !*long_one) return long_one;
  pass(e, e.entry->is_python() ? "plays the same legs again without a fault"
                               : "writes only to memory of its own");
  return pass(
      e,
      "answers the same observations in the same way, also at another time of day, at other "
      "addresses and with other memory");
}

}  // namespace mirocup::app
