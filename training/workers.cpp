// SPDX-License-Identifier: MIT
#include "training/workers.hpp"

#include "plugins/host/floating_point.hpp"

#include <algorithm>
#include <cfenv>

namespace mirocup::training {

namespace {

// How often a thread looks for a change before it sleeps: some 50 us. A step of many matches
// follows the one before at once, and to be woken takes about as long.
constexpr int looks_before_sleep = 2000;

template <class T>
void wait_while(const std::atomic<T>& value, T old) {
  for (int i = 0; i < looks_before_sleep; ++i) {
    if (value.load(std::memory_order_acquire) != old) return;
#if defined(__x86_64__)
    __builtin_ia32_pause();
#elif defined(__aarch64__)
    asm volatile("yield");
#endif
  }
  value.wait(old, std::memory_order_acquire);
}

}  // namespace

Workers::Workers(int threads) : shares_(static_cast<std::size_t>(threads)) {
  for (int i = 1; i < threads; ++i) others_.emplace_back([this, i] { wait_for_work(i); });
}

Workers::~Workers() {
  is_closing_ = true;
  runs_.fetch_add(1, std::memory_order_release);
  runs_.notify_all();
  for (std::thread& other : others_) other.join();
}

void Workers::run(int pieces, const DoPiece& do_piece) {
  const bool alone = others_.empty() || pieces <= 1;
  const int sharing = alone ? 1 : threads();
  for (int i = 0; i < threads(); ++i) {
    Share& share = shares_[static_cast<std::size_t>(i)];
    share.next.store(pieces * std::min(i, sharing) / sharing, std::memory_order_relaxed);
    share.end = pieces * std::min(i + 1, sharing) / sharing;
  }
  if (alone) return work(do_piece, 0);
  do_piece_ = &do_piece;
  busy_.store(static_cast<int>(others_.size()), std::memory_order_relaxed);
  runs_.fetch_add(1, std::memory_order_release);
  runs_.notify_all();
  work(do_piece, 0);
  for (int busy = busy_.load(std::memory_order_acquire); busy != 0;
       busy = busy_.load(std::memory_order_acquire)) {
    wait_while(busy_, busy);
  }
}

void Workers::wait_for_work(int thread) {
  for (std::uint32_t done = 0;; ++done) {
    wait_while(runs_, done);
    if (is_closing_) return;
    work(*do_piece_, thread);
    if (busy_.fetch_sub(1, std::memory_order_acq_rel) == 1) busy_.notify_one();
  }
}

void Workers::work(const DoPiece& do_piece, int thread) {
  // A library that was built with -Ofast may have changed the mode of the thread that loaded it.
  const plugins::FloatingPointGuard guard;
  std::fesetenv(FE_DFL_ENV);
  for (int i = 0; i < threads(); ++i) {
    Share& share = shares_[static_cast<std::size_t>((thread + i) % threads())];
    for (int piece = share.next++; piece < share.end; piece = share.next++) do_piece(piece, thread);
  }
}

}  // namespace mirocup::training
