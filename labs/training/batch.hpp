// SPDX-License-Identifier: MIT
//
// Matches that take their steps together, on several threads, and write into the caller's buffers.
#pragma once

#include "labs/training/match.hpp"
#include "mirocup/training.h"

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

namespace mirocup::training {

// The threads of a batch. The threads divide numbered pieces of work among themselves. The result
// of a piece must not depend on its thread.
//
// Each thread begins with its own share of the pieces, the same share in every run, so that its
// data stay in its processor's caches. A thread that has finished its share helps the other
// threads.
class Workers {
 public:
  // The calling thread also works, so there are `threads` - 1 other threads.
  explicit Workers(int threads);
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;
  ~Workers();

  int threads() const { return static_cast<int>(others_.size()) + 1; }

  // Does one piece. `thread` is 0 for the calling thread.
  using DoPiece = std::function<void(int piece, int thread)>;

  // Does the pieces 0 .. pieces-1 and returns when all are done. Each thread works with the default
  // floating-point mode, not with the caller's mode. do_piece() must not throw.
  void run(int pieces, const DoPiece& do_piece);

 private:
  // The pieces that a thread begins with: from `next`, which its thread counts up, to `end`. Each
  // share has a separate cache line, because its thread writes it often.
  struct alignas(64) Share {
    std::atomic<int> next{0};
    int end = 0;
  };

  void wait_for_work(int thread);
  void work(const DoPiece& do_piece, int thread);

  std::vector<Share> shares_;  // by thread
  const DoPiece* do_piece_ = nullptr;
  bool is_closing_ = false;
  // Writes before a change of the two members below are visible to threads that saw the change.
  std::atomic<std::uint32_t> runs_{0};  // number of runs begun so far
  std::atomic<int> busy_{0};            // number of other threads that have not finished this run
  std::vector<std::thread> others_;
};

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
