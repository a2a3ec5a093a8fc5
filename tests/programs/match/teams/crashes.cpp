// SPDX-License-Identifier: MIT
//
// A team that crashes in tick 40, three functions deep. Its parameter "loops" makes the description
// of its stack one that the unwinder never comes to the end of.
#include "mirocup/strategy.hpp"

namespace {

using namespace mirocup::strategy;

[[gnu::noinline]] void dig(volatile int* treasure) {
  *treasure = 1;
  asm volatile("");  // so that no call becomes a jump
}

// The address of its caller's frame is the result of a program that jumps back to its own start:
// DW_CFA_def_cfa_expression, 3 bytes, DW_OP_skip -3.
[[gnu::noinline]] void dig_in_a_loop(volatile int* treasure) {
  asm volatile(".cfi_escape 0x0f, 0x03, 0x2f, 0xfd, 0xff");
  *treasure = 1;
  asm volatile("");
}

class Crashes : public Team {
 public:
  using Team::Team;

  [[gnu::noinline]] void decide(const Observation& now, Command&) override {
    if (now.tick == 40) look_for(nullptr);
    asm volatile("");
  }

 private:
  [[gnu::noinline]] void look_for(volatile int* treasure) const {
    if (loops_) {
      dig_in_a_loop(treasure);
    } else {
      dig(treasure);
    }
    asm volatile("");
  }

  const bool loops_ = parameter("loops", 0.0) > 0.0;
};

}  // namespace

MIROCUP_EXPORT_TEAM(Crashes, "crashes")
