// SPDX-License-Identifier: MIT
//
// The threads of a batch. The threads divide numbered pieces of work among themselves. The result
// of a piece must not depend on its thread.
//
// Each thread begins with its own share of the pieces, the same share in every run, so that its
// data stay in its processor's caches. A thread that has finished its share helps the other
// threads.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <thread>
#include <vector>

namespace mirocup::training {

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

}  // namespace mirocup::training
