// SPDX-License-Identifier: MIT
//
// One match of a batch, with one episode after the other. Learners, and teams that do not learn,
// steer its robots.
#pragma once

#include "core/match/command.hpp"
#include "core/match/disturbances.hpp"
#include "labs/training/config.hpp"
#include "labs/training/episode.hpp"
#include "labs/training/observations.hpp"
#include "labs/training/rewards.hpp"
#include "plugins/host/trusted_controller.hpp"

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace mirocup::training {

// Robots that move at random, like the robots without a learner in rSoccer's VSS environment: the
// speed of each wheel is an Ornstein-Uhlenbeck process, x += theta (0 - x) dt + sigma sqrt(dt) n,
// with theta = 0.17/s and sigma = 0.5/sqrt(s), in shares of the speed limit.

// The random motion of a team. The class is a plain value.
class Noise {
 public:
  Noise() = default;
  // Makes the motion of one team in the episode of `seed`.
  Noise(std::uint64_t seed, Team team);

  // Returns the wheel speeds of all robots for a tick of `period` seconds; `limit` is in rad/s.
  match::Command next(int robots, double period, double limit);

 private:
  Random random_;
  std::array<std::array<double, 2>, max_robots_per_team> share_{};
};

// The learners of a match, in the order of its rows.
struct Slots {
  std::vector<Learner> learners;
  int action = 0;  // numbers in a row of actions: two for each robot of a learner

  explicit Slots(const Config& config);
};

// The statistics of an episode: the values below, then the sum of each term.
inline constexpr std::array<std::string_view, 5> first_statistics{"return", "steps", "seconds",
                                                                  "score", "opponent_score"};
inline constexpr int statistics = static_cast<int>(first_statistics.size()) + terms;

// The rows of one match in the caller's buffers. A pointer is null if the caller gave no buffer for
// it.
struct Rows {
  const float* actions = nullptr;
  float* observations = nullptr;
  float* rewards = nullptr;
  std::uint8_t* terminations = nullptr;
  std::uint8_t* truncations = nullptr;
  float* final_observations = nullptr;
  float* terms = nullptr;
  float* statistics = nullptr;
};

// Returns a world for legs with this setup. The field must outlive the world.
std::unique_ptr<simulator::World> make_world(const match::Setup& setup, const field::Field& field);

class Match {
 public:
  // The arguments must outlive the match. `seed` is the seed of the first episode.
  Match(const Config& config, const Slots& slots, const Observer& observer, std::uint64_t seed);

  // The functions below use a world only while they run, and leave nothing in the world. So matches
  // of one thread share a world from make_world(), and a match needs little memory between steps.

  // Starts an episode: the first episode of a seed or, without a seed, the next episode. The error
  // says why a team does not start.
  Result<void> reset(std::optional<std::uint64_t> seed, const Rows& rows, simulator::World& world);

  // Plays one step, or starts the next episode if one is due. Must not be called before reset().
  Result<void> step(const Rows& rows, const Weights& weights, simulator::World& world);

  bool has_started() const { return leg_.has_value(); }
  // Returns the state of all bodies. Must not be called before reset().
  match::Snapshot snapshot(simulator::World& world);

  const Episode& episode() const { return episode_; }
  const std::optional<Episode>& last_episode() const { return last_; }

  // save() returns the match's state as bytes; restore() sets the match to a state from save(), and
  // writes the observations and ends of this state.
  std::string save() const;
  Result<void> restore(std::string_view copy, const Rows& rows, simulator::World& world);

 private:
  using Commands = match::ByTeam<match::Command>;

  // Counts of an episode.
  struct Counts {
    std::uint64_t steps = 0;
    std::uint64_t play_ticks = 0;
    bool is_terminated = false;
    bool is_truncated = false;
  };
  // Measures of a learner.
  struct Measures {
    RewardMeter meter;
    Terms sums{};
    double total = 0.0;  // sum of the rewards
  };

  Result<void> start_episode(const Rows& rows, simulator::World& world);
  Result<void> play_step(const Rows& rows, const Weights& weights, simulator::World& world);
  Result<void> begin(std::uint64_t seed, simulator::World& world);
  Result<void> start_teams();
  Result<void> expect_known_parameters() const;
  void skip_stop();
  void play_tick(const Commands& commands);
  match::Answer answer_of(Team team, const match::Command& learned,
                          const std::optional<match::Snapshot>& view);
  Commands commands_of(const float* actions) const;
  void observe(float* to) const;
  void write_rewards(const Rows& rows, const Weights& weights, std::uint32_t ticks);
  void write_no_rewards(const Rows& rows) const;
  void write_ends(const Rows& rows) const;
  void write_statistics(float* to) const;
  bool is_too_long() const {
    return counts_.play_ticks >= max_play_ticks_ || counts_.steps >= config_.max_steps;
  }
  bool is_done() const { return counts_.is_terminated || counts_.is_truncated; }
  std::uint64_t next_seed();
  // If each episode draws its pitch, each leg has its own world.
  bool shares_world() const { return config_.pitch.is_null(); }
  void take_up(simulator::World& world);
  void lay_aside();

  const Config& config_;
  const Slots& slots_;
  const Observer& observer_;
  std::uint64_t first_seed_;      // seed of the series of episodes
  std::uint64_t episodes_ = 0;    // number of episodes of the series begun so far
  std::uint64_t max_play_ticks_;  // of an episode
  std::optional<match::Leg> leg_;
  match::ByTeam<std::unique_ptr<plugins::TrustedController>> teams_;  // null: no library plays
  match::ByTeam<Noise> noise_;
  Counts counts_;
  std::vector<Measures> measures_;  // the measures of each learner
  Episode episode_;
  std::optional<Episode> last_;
};

}  // namespace mirocup::training
