// SPDX-License-Identifier: MIT
//
// Copies of this process, by fork(). A copy continues from the same moment as its original, with
// everything that a team remembers. Nobody but the team knows where it keeps that, so copies of the
// process are the only way to play several futures of one moment. What a copy does is lost with it,
// except its answer.
//
// A copy dies when its original dies. It ends without flushing or destroying anything, so it must
// not print. Use copies only in a process with one thread: a copy has no other.
#pragma once

#include <concepts>
#include <memory>
#include <optional>
#include <sys/mman.h>
#include <sys/types.h>
#include <type_traits>
#include <unistd.h>

namespace mirocup::coach {

// The parts of a Copy that do not depend on its answer. fork_copy() returns 0 in the copy, and a
// negative number if there is no copy.
pid_t fork_copy();
bool ends_well(pid_t copy);  // waits for its end

// A copy that runs a function, which returns a T. T is copied byte by byte, through memory that the
// two processes share.
template <class T>
class Copy {
 public:
  // Starts the copy, and does not wait for it.
  template <std::invocable Work>
  explicit Copy(Work&& work) {
    static_assert(std::is_trivially_copyable_v<T>);
    void* memory =
        mmap(nullptr, sizeof(T), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) return;
    answer_.reset(static_cast<T*>(memory));
    pid_ = fork_copy();
    if (pid_ != 0) return;
    new (memory) T(work());
    _exit(0);
  }

  // Waits for the answer; to be called once. Nothing if the copy could not start or has crashed.
  std::optional<T> wait() { return ends_well(pid_) ? std::optional<T>(*answer_) : std::nullopt; }

 private:
  struct Unmap {
    void operator()(T* answer) const { munmap(answer, sizeof(T)); }
  };
  std::unique_ptr<T, Unmap> answer_;
  pid_t pid_ = -1;
};
template <class Work>
Copy(Work&&) -> Copy<std::invoke_result_t<Work>>;

}  // namespace mirocup::coach
