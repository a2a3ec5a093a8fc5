// SPDX-License-Identifier: MIT
//
// Unpacks any bytes as what a team has drawn in a leg.
#include "record/thoughts_file.hpp"
#include "tests/security/fuzz/fuzz_target.hpp"

MIROCUP_FUZZ_TARGET(thoughts) {
  (void)mirocup::record::unpacked_thoughts(mirocup::fuzz::text_of(data, size), "t");
}
