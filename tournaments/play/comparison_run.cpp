// SPDX-License-Identifier: MIT
#include "tournaments/play/comparison_run.hpp"

#include "core/base/random.hpp"
#include "server/record/json_reader.hpp"
#include "system/locations.hpp"
#include "system/process_set.hpp"
#include "tournaments/format/schedule.hpp"
#include "tournaments/league/event.hpp"

#include <map>
#include <sstream>

namespace mirocup::league {

namespace {

class Comparison {
 public:
  Comparison(system::Files& files, const ComparisonRun& run, ProgressReporter& progress)
      : files_(files), run_(run), progress_(progress) {}

  Result<ComparisonResult> play() {
    const std::vector<int> cpus = system::processors();
    const std::size_t jobs = run_.jobs > 0 ? static_cast<std::size_t>(run_.jobs) : cpus.size();
    int next = 0;  // leg
    while (result_.verdict == ComparisonVerdict::undecided && counted_ < run_.max_fixtures) {
      if (processes_.running() < jobs && next < run_.max_fixtures * legs_per_fixture) {
        const int cpu = cpus[static_cast<std::size_t>(next) % cpus.size()];
        if (auto started = start(next++, cpu); !started) return tl::unexpected(started.error());
        continue;
      }
      const auto exit = processes_.wait();
      if (!exit) return fail(Errc::interrupted, "interrupted; nothing can be said");
      if (auto counted = count(*exit); !counted) return tl::unexpected(counted.error());
    }
    return result_;
  }

 private:
  std::string record_of(int leg) const { return run_.folder + "/" + std::to_string(leg) + ".json"; }

  Result<void> start(int leg, int cpu) {
    // The second leg of a fixture has the same seed, with colours swapped.
    const bool swapped = leg % legs_per_fixture == 1;
    const std::uint64_t seed =
        mix_seed(run_.seed ^ mix_seed(static_cast<std::uint64_t>(leg / legs_per_fixture))) >> 11;
    std::vector<std::string> arguments{system::sibling_program("mirocup"),
                                       "match",
                                       "--blue",
                                       run_.teams[swapped ? 1 : 0],
                                       "--yellow",
                                       run_.teams[swapped ? 0 : 1],
                                       "--league",
                                       std::string(to_string(run_.league)),
                                       "--seed",
                                       std::to_string(seed),
                                       "--record",
                                       record_of(leg)};
    if (run_.half_s > 0.0) {
      std::ostringstream half;
      half << run_.half_s;
      arguments.insert(arguments.end(), {"--half", half.str()});
    }
    const auto started = processes_.start(arguments, leg, cpu, record_of(leg) + ".out");
    if (!started) return tl::unexpected(started.error());
    return {};
  }

  // The goals by which the first team is ahead after a leg.
  Result<int> difference(int leg) {
    const auto text = files_.read(record_of(leg), {.max_size = system::size_limit::record});
    if (!text) return tl::unexpected(text.error());
    const auto ahead = record::read_json<int>(
        *text, record_of(leg), Errc::host, [](const record::JsonReader& json) {
          const record::JsonReader score = json.at("result").at("score");
          return score.at("blue").integer(0, max_count) - score.at("yellow").integer(0, max_count);
        });
    if (!ahead) return ahead;
    return leg % legs_per_fixture == 1 ? -*ahead : *ahead;
  }

  Result<void> count(const system::Exit& exit) {
    if (exit.signal != 0 || exit.code != exit_yes) {
      const auto said =
          files_.read(record_of(exit.tag) + ".out",
                      {.max_size = system::size_limit::log, .growth = system::Growth::ignored});
      return fail(exit.code == 2 ? Errc::input : Errc::host,
                  "a leg could not be played: " + (said ? *said : std::string()));
    }
    const auto ahead = difference(exit.tag);
    if (!ahead) return tl::unexpected(ahead.error());
    ahead_[exit.tag] = *ahead;
    // Fixtures are counted in order, each when both of its legs are there.
    while (result_.verdict == ComparisonVerdict::undecided && ahead_.count(2 * counted_) != 0 &&
           ahead_.count(2 * counted_ + 1) != 0) {
      const int sum = ahead_[2 * counted_] + ahead_[2 * counted_ + 1];
      ++counted_;
      ++(sum > 0 ? result_.first_wins : sum < 0 ? result_.second_wins : result_.level);
      result_.verdict = verdict(result_.first_wins, result_.second_wins, run_.test);
      progress_.say("fixture " + std::to_string(counted_) + ": " +
                    std::to_string(result_.first_wins) + " to " +
                    std::to_string(result_.second_wins) + ", " + std::to_string(result_.level) +
                    " level");
    }
    return {};
  }

  system::Files& files_;
  const ComparisonRun& run_;
  ProgressReporter& progress_;
  system::ProcessSet processes_;
  ComparisonResult result_;
  std::map<int, int> ahead_;  // by leg
  int counted_ = 0;           // fixtures
};

}  // namespace

Result<ComparisonResult> run_comparison(system::Files& files, const ComparisonRun& run,
                                        ProgressReporter& progress) {
  return Comparison(files, run, progress).play();
}

}  // namespace mirocup::league
