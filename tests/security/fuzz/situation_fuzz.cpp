// SPDX-License-Identifier: MIT
//
// Reads any bytes as a situation. One that is whole must come back from its own text.
#include "record/json_reader.hpp"
#include "record/situation_json.hpp"
#include "tests/security/fuzz/fuzz_target.hpp"

#include <nlohmann/json.hpp>

#include <cstdlib>

MIROCUP_FUZZ_TARGET(situation) {
  using namespace mirocup;
  const auto one = record::parse_situation(fuzz::text_of(data, size), "s.json");
  if (!one) return;
  const std::string text = record::json_text(record::to_json(*one));
  const auto again = record::parse_situation(text, "s.json");
  if (!again || record::json_text(record::to_json(*again)) != text) std::abort();
}
