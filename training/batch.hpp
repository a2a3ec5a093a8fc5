// SPDX-License-Identifier: MIT
//
// Matches that take their steps together, on several threads, and write into the caller's buffers.
#pragma once

#include "mirocup/training.h"
#include "training/match.hpp"
#include "training/workers.hpp"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace mirocup::training {

class Batch {
 public:
  explicit Batch(Config config);
  Batch(const Batch&) = delete;
  Batch& operator=(const Batch&) = delete;

  const mirocup_training_sizes& sizes() const { return sizes_; }
  const std::string& spec() const { return spec_; }

  void bind(const mirocup_training_buffers& buffers) { buffers_ = buffers; }
  Result<void> reset(const std::uint8_t* mask, const std::uint64_t* seeds);
  Result<void> step();
  void set_weights(const Weights& weights) { config_.weights = weights; }

  // Returns match `number`; an error if the match does not exist or was not yet reset.
  Result<Match*> match(int number) const;
  Result<match::Snapshot> snapshot(int number) const;
  Result<void> record(int number, bool last, const std::string& path) const;
  Result<void> restore(int number, std::string_view copy);

 private:
  Rows rows_of(int match) const;
  using Act = std::function<Result<void>(int match, simulator::World& world)>;
  Result<void> on_all(const Act& act);
  std::string make_spec() const;

  Config config_;
  field::Field field_;
  Slots slots_;
  Observer observer_;
  mirocup_training_sizes sizes_{};
  mirocup_training_buffers buffers_{};
  std::vector<std::unique_ptr<Match>> matches_;
  Workers workers_;
  std::vector<std::unique_ptr<simulator::World>> worlds_;  // the world of each thread
  std::string spec_;
};

}  // namespace mirocup::training
