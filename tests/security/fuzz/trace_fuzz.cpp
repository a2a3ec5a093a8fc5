// SPDX-License-Identifier: MIT
//
// Reads any bytes as one line of a trace, and judges it where it is a situation.
#include "record/json_reader.hpp"
#include "record/traces/trace.hpp"
#include "record/traces/trace_verdict.hpp"
#include "tests/security/fuzz/fuzz_target.hpp"

MIROCUP_FUZZ_TARGET(trace) {
  using namespace mirocup;
  const auto line = record::parse_json(mirocup::fuzz::text_of(data, size));
  if (line.problem) return;
  const auto trace = traces::trace_from_json(line.value);
  if (trace) (void)record::json_text(traces::judge_trace(*trace));
}
