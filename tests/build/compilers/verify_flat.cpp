// SPDX-License-Identifier: MIT
//
// Verifies flat recordings with core alone. Usage: verify_flat FLAT...; prints a line for each;
// exit 1 if one is not reproduced.
#include "core/replay/verification.hpp"
#include "tests/build/compilers/flat_recording.hpp"

#include <cstdio>
#include <fstream>
#include <sstream>

using namespace mirocup;

int main(int argc, char** argv) {
  int bad = 0;
  for (int i = 1; i < argc; ++i) {
    std::ostringstream bytes;
    bytes << std::ifstream(argv[i], std::ios::binary).rdbuf();
    const auto recording = test_support::recording_from(bytes.str());
    if (!recording) {
      std::printf("%s: this is no flat recording of these sources\n", argv[i]);
      ++bad;
      continue;
    }
    const auto divergence = replay::verify(*recording);
    if (divergence) {
      std::printf("%s: differs from tick %u on: %s\n", argv[i], divergence->tick,
                  divergence->what.c_str());
      ++bad;
    } else {
      std::printf("%s: reproduced, %zu ticks, state hash %s\n", argv[i], recording->ticks.size(),
                  to_hex(recording->state_hash).c_str());
    }
  }
  return bad == 0 && argc > 1 ? 0 : 1;
}
