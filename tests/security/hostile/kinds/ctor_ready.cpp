// SPDX-License-Identifier: MIT
#include "tests/security/hostile/mailbox_finder.hpp"

#include <sys/stat.h>

namespace mirocup::plugins {
void wake(const std::atomic<std::uint32_t>& word) {
  syscall(SYS_futex, &word, 1, 1, nullptr, nullptr, 0);
}
}  // namespace mirocup::plugins

// Says "ready" from a constructor and plays the leg in there, so that the process never restricts
// itself. Loading must be over all the same.
static void try_to_load() {
  struct stat status;
  for (const char* path : {SECRET, "/etc/ld.so.cache", "/lib/x86_64-linux-gnu/libm.so.6", "/"}) {
    if (open(path, O_RDONLY) >= 0) got_through(path);
    if (errno == ENOENT || errno == EACCES) got_through("an answer about a path");
    if (syscall(SYS_newfstatat, AT_FDCWD, path, &status, 0) == 0) got_through("the size of a file");
  }
  if (mmap(nullptr, 4096, PROT_READ | PROT_EXEC, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0) != MAP_FAILED)
    got_through("new code");
}

__attribute__((constructor)) static void at_load() {
  const auto [in, out] = find_mailbox();
  if (in == nullptr) return;
  out->load_state.store(LoadState::ready);
  mirocup::plugins::wake(out->answer);
  std::uint32_t answered = 0;
  while (true) {
    while (in->request.load() == answered) {
      const timespec moment{0, 100'000};
      nanosleep(&moment, nullptr);
    }
    answered = in->request.load();
    if (in->observation.tick == 0) fprintf(stderr, "plays from its constructor\n");
    if (in->observation.tick == hostile_tick) try_to_load();
    out->command = {};
    out->answer.store(answered);
    mirocup::plugins::wake(out->answer);
  }
}

BEHAVES_LATER
