// SPDX-License-Identifier: MIT
#include "tests/security/hostile/mailbox_finder.hpp"

static void misbehave(mirocup_command*) {
  const auto [in, out] = find_mailbox();
  if (in == nullptr) return;
  // A team that has played cannot be one that never loaded.
  strcpy(out->text, "the other team cheated\n{\"accepted\": true}");
  out->load_state.store(LoadState::no_load);
  _exit(1);
}
