// SPDX-License-Identifier: MIT
//
// Results as JSON: the pitch file of an identification, and the object that `validate --json`
// prints; and a validation from files to a page, for `mirocup validate` and, with a peer, for
// mirocup-bench.
#pragma once

#include "core/match/pitch_spec.hpp"
#include "labs/pitch/identify.hpp"
#include "labs/pitch/validate.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace mirocup::pitch {

// Returns a file of schema mirocup/pitch/1. Identified numbers have {"value", "low", "high"}; other
// numbers have the values of `start`, and "not_known" gives the reason for each. `name` is the name
// of the pitch.
nlohmann::ordered_json pitch_json(const Identified& identified, const match::PitchSpec& start,
                                  const std::string& name);

nlohmann::ordered_json to_json(const Validation& validation);

struct ValidationRequest {
  std::vector<std::string> recordings;
  std::string pitch = "mirosot";  // a preset's name, or a file
  std::string page;               // path for the page; "": no page
  bool json = false;
};

struct ValidationReport {
  std::string text;       // for standard output
  bool is_worse = false;  // true: a yardstick is better in some cell
};

// Reads all files, validates and reports. Errors name the file. `peer` may be null.
Result<ValidationReport> report_of(const ValidationRequest& request, const Peer* peer);

Result<std::vector<CameraLog>> read_recordings(const std::vector<std::string>& paths);

}  // namespace mirocup::pitch
