// SPDX-License-Identifier: MIT
//
// Reads any bytes as a library, and looks up the names of its functions.
#include "plugins/host/function_names.hpp"
#include "tests/security/fuzz/fuzz_target.hpp"

#include <array>
#include <cstdint>

MIROCUP_FUZZ_TARGET(names) {
  const auto library = mirocup::fuzz::text_of(data, size);
  constexpr std::array<std::uint64_t, 3> addresses{0, 0x1234, ~std::uint64_t{0}};
  (void)mirocup::plugins::functions_at(library, addresses);
  (void)mirocup::plugins::readable_name(library.substr(0, 4096));
}
