// SPDX-License-Identifier: MIT
//
// A validation from files to a page, for `mirocup validate` and, with a peer, for mirocup-bench.
#pragma once

#include "pitch/validate.hpp"

#include <string>
#include <vector>

namespace mirocup::pitch {

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

Result<std::vector<Recording>> read_recordings(const std::vector<std::string>& paths);

}  // namespace mirocup::pitch
