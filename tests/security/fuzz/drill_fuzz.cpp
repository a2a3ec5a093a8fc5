// SPDX-License-Identifier: MIT
//
// Reads any bytes as a drill, and draws the situation of one that is whole.
#include "record/drills/drill.hpp"
#include "tests/security/fuzz/fuzz_target.hpp"

MIROCUP_FUZZ_TARGET(drill) {
  const auto drill = mirocup::drills::parse_drill(mirocup::fuzz::text_of(data, size), "d.json");
  if (drill) (void)mirocup::drills::setup_of(*drill, 1);
}
