// SPDX-License-Identifier: MIT
//
// A batch with buffers and random actions, through the C interface.
#pragma once

#include "core/base/random.hpp"
#include "core/base/state_hash.hpp"
#include "mirocup/training.h"

#include <nlohmann/json.hpp>

#include <bit>
#include <stdexcept>
#include <string>
#include <vector>

namespace mirocup::training {

class BatchOfMatches {
 public:
  // Throws if the configuration is refused.
  explicit BatchOfMatches(const nlohmann::json& configuration) {
    char error[500] = "";
    training_ = mirocup_training_create(configuration.dump().c_str(), error, sizeof error);
    if (training_ == nullptr) throw std::runtime_error(error);
    size = *mirocup_training_get_sizes(training_);
    const auto rows = static_cast<std::size_t>(size.rows);
    actions.resize(rows * static_cast<std::size_t>(size.action));
    observations.resize(rows * static_cast<std::size_t>(size.observation));
    final_observations.resize(observations.size());
    rewards.resize(rows);
    terminations.resize(rows);
    truncations.resize(rows);
    terms.resize(rows * static_cast<std::size_t>(size.terms));
    statistics.resize(rows * static_cast<std::size_t>(size.statistics));
    const mirocup_training_buffers buffers{.size = sizeof buffers,
                                           .actions = actions.data(),
                                           .observations = observations.data(),
                                           .rewards = rewards.data(),
                                           .terminations = terminations.data(),
                                           .truncations = truncations.data(),
                                           .final_observations = final_observations.data(),
                                           .terms = terms.data(),
                                           .statistics = statistics.data()};
    mirocup_training_bind(training_, &buffers);
  }
  BatchOfMatches(const BatchOfMatches&) = delete;
  BatchOfMatches& operator=(const BatchOfMatches&) = delete;
  ~BatchOfMatches() { mirocup_training_destroy(training_); }

  mirocup_training* get() { return training_; }

  // Resets all matches; match i gets the seed first + i.
  int reset(std::uint64_t first) {
    std::vector<std::uint64_t> seeds;
    for (int i = 0; i < size.matches; ++i) seeds.push_back(first + static_cast<std::uint64_t>(i));
    return mirocup_training_reset(training_, nullptr, seeds.data());
  }

  // Plays a step in which the actions of match i are drawn from (first + i, step).
  int step(std::uint64_t first, int step) {
    const std::size_t numbers = actions.size() / static_cast<std::size_t>(size.matches);
    for (int i = 0; i < size.matches; ++i) {
      Random random(mix_seed(first + static_cast<std::uint64_t>(i)) +
                    static_cast<std::uint64_t>(step));
      for (std::size_t k = 0; k < numbers; ++k) {
        actions[static_cast<std::size_t>(i) * numbers + k] =
            static_cast<float>(random.uniform(-1.0, 1.0));
      }
    }
    return mirocup_training_step(training_);
  }

  // A fingerprint of all that the last call wrote about one match.
  std::uint64_t hash(int match) const {
    StateHash hash;
    const auto add = [&](const auto& values) {
      const std::size_t numbers = values.size() / static_cast<std::size_t>(size.matches);
      for (std::size_t k = 0; k < numbers; ++k) {
        hash.add(static_cast<double>(values[static_cast<std::size_t>(match) * numbers + k]));
      }
    };
    add(observations);
    add(final_observations);
    add(rewards);
    add(terminations);
    add(truncations);
    add(terms);
    add(statistics);
    return hash.value();
  }

  std::string save(int match) {
    std::string copy(mirocup_training_save(training_, match, nullptr, 0), '\0');
    mirocup_training_save(training_, match, copy.data(), copy.size());
    return copy;
  }

  mirocup_training_sizes size{};
  std::vector<float> actions, observations, final_observations, rewards, terms, statistics;
  std::vector<std::uint8_t> terminations, truncations;

 private:
  mirocup_training* training_ = nullptr;
};

}  // namespace mirocup::training
