// SPDX-License-Identifier: MIT
//
// Reads any bytes as the arrays of a policy, and writes the source of one that is whole.
#include "labs/training/policy/policy.hpp"
#include "tests/security/fuzz/fuzz_target.hpp"

#include <cstdlib>

MIROCUP_FUZZ_TARGET(npz) {
  const auto policy = mirocup::policy::parse_policy(mirocup::fuzz::text_of(data, size), "p.npz");
  if (!policy && policy.error().what.empty()) std::abort();
  if (policy) (void)mirocup::policy::source_of(*policy, "mine");
}
