// SPDX-License-Identifier: MIT
//
// Reads any bytes as a recording of a camera: JSON lines if they begin with a brace, and otherwise
// a table.
#include "labs/pitch/camera_log.hpp"
#include "tests/security/fuzz/fuzz_target.hpp"

MIROCUP_FUZZ_TARGET(recording) {
  const auto text = mirocup::fuzz::text_of(data, size);
  const auto recording = text.starts_with('{') ? mirocup::pitch::parse_recording(text, "r")
                                               : mirocup::pitch::parse_csv(text, "r.csv");
  if (recording && recording->frames.size() >= 2) (void)recording->usual_period();
}
