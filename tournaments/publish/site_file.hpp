// SPDX-License-Identifier: MIT
//
// A file of the published league.
#pragma once

#include <string>

namespace mirocup::league {

struct SiteFile {
  std::string name;  // inside site/
  std::string bytes;
};

}  // namespace mirocup::league
