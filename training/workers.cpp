// SPDX-License-Identifier: MIT
#include "training/workers.hpp"

#include "plugins/host/floating_point.hpp"

#include <cfenv>

namespace mirocup::training {

Workers::Workers(int threads) {
  for (int i = 1; i < threads; ++i) others_.emplace_back([this, i] { wait_for_work(i); });
}

Workers::~Workers() {
  {
    const std::lock_guard lock(mutex_);
    is_closing_ = true;
  }
  begin_.notify_all();
  for (std::thread& other : others_) other.join();
}

void Workers::run(int pieces, const DoPiece& do_piece) {
  const bool alone = others_.empty() || pieces <= 1;
  next_ = 0;
  if (!alone) {
    {
      const std::lock_guard lock(mutex_);
      do_piece_ = &do_piece;
      pieces_ = pieces;
      busy_ = static_cast<int>(others_.size());
      ++runs_;
    }
    begin_.notify_all();
  }
  work(do_piece, pieces, 0);
  if (alone) return;
  std::unique_lock lock(mutex_);
  end_.wait(lock, [this] { return busy_ == 0; });
}

void Workers::wait_for_work(int thread) {
  std::uint64_t done = 0;
  while (true) {
    std::unique_lock lock(mutex_);
    begin_.wait(lock, [&] { return is_closing_ || runs_ != done; });
    if (is_closing_) return;
    done = runs_;
    const auto* do_piece = do_piece_;
    const int pieces = pieces_;
    lock.unlock();
    work(*do_piece, pieces, thread);
    lock.lock();
    if (--busy_ == 0) end_.notify_one();
  }
}

void Workers::work(const DoPiece& do_piece, int pieces, int thread) {
  // A library that was built with -Ofast may have changed the mode of the thread that loaded it.
  const plugins::FloatingPointGuard guard;
  std::fesetenv(FE_DFL_ENV);
  for (int i = next_++; i < pieces; i = next_++) do_piece(i, thread);
}

}  // namespace mirocup::training
