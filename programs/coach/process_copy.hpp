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

#include <cerrno>
#include <concepts>
#include <csignal>
#include <memory>
#include <optional>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <type_traits>
#include <unistd.h>

namespace mirocup::coach {

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
    const pid_t original = getpid();
    pid_ = fork();
    if (pid_ != 0) return;
    // The original may have died before the kernel knew that its copy has to die with it.
    if (prctl(PR_SET_PDEATHSIG, SIGKILL) != 0 || getppid() != original) _exit(1);
    new (memory) T(work());
    _exit(0);
  }

  // Waits for the answer; to be called once. Nothing if the copy could not start or has crashed.
  std::optional<T> wait() {
    int status = -1;
    while (pid_ > 0 && waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
    }
    return status == 0 ? std::optional<T>(*answer_) : std::nullopt;
  }

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
