// SPDX-License-Identifier: MIT
//
// Reads any bytes as a pitch. One that is whole must come back from its own text.
#include "record/json_reader.hpp"
#include "record/pitch_json.hpp"
#include "tests/security/fuzz/fuzz_target.hpp"

#include <nlohmann/json.hpp>

#include <cstdlib>

MIROCUP_FUZZ_TARGET(pitch) {
  using namespace mirocup;
  const auto one = record::parse_pitch(fuzz::text_of(data, size), "p.json");
  if (!one) return;
  const std::string text = record::json_text(record::to_json(*one));
  const auto again = record::parse_pitch(text, "p.json");
  if (!again || record::json_text(record::to_json(*again)) != text) std::abort();
}
