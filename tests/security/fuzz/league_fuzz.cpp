// SPDX-License-Identifier: MIT
//
// Reads any bytes as league.json. What is accepted is printed, and must be accepted again.
#include "tests/security/fuzz/fuzz_target.hpp"
#include "tournaments/format/league_file.hpp"

#include <cstdlib>
#include <iostream>

MIROCUP_FUZZ_TARGET(league) {
  using namespace mirocup::league;
  const auto file =
      parse_league_file(std::string(mirocup::fuzz::text_of(data, size)), "league.json");
  if (!file) return;
  const std::string printed = print_league_file(*file);
  const auto again = parse_league_file(printed, "league.json");
  if (!again) {
    std::cerr << printed << again.error().what << '\n';
    std::abort();
  }
  if (print_league_file(*again) != printed) std::abort();
}
