// SPDX-License-Identifier: MIT
//
// The threads of a batch. They divide numbered pieces of work among themselves; which thread does
// which piece must not matter.
#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace mirocup::training {

class Workers {
 public:
  // The calling thread works, too: there are `threads` - 1 others.
  explicit Workers(int threads);
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;
  ~Workers();

  int threads() const { return static_cast<int>(others_.size()) + 1; }

  // What is done: a piece, by one of the threads, numbered from 0 (the calling one).
  using DoPiece = std::function<void(int piece, int thread)>;

  // Does the pieces 0 .. pieces-1 and returns when all are done. Each thread works with the default
  // floating-point mode, whatever the caller's is. do_piece() throws nothing.
  void run(int pieces, const DoPiece& do_piece);

 private:
  void wait_for_work(int thread);
  void work(const DoPiece& do_piece, int pieces, int thread);

  std::vector<std::thread> others_;
  std::mutex mutex_;
  std::condition_variable begin_, end_;
  // Guarded by mutex_.
  const DoPiece* do_piece_ = nullptr;
  int pieces_ = 0;
  int busy_ = 0;            // other threads that have not finished this run
  std::uint64_t runs_ = 0;  // begun so far
  bool is_closing_ = false;
  std::atomic<int> next_{0};  // the first piece that nobody has taken
};

}  // namespace mirocup::training
