// SPDX-License-Identifier: MIT
//
// The files of the published league.
#pragma once

#include <functional>
#include <map>
#include <string>

namespace mirocup::league {

struct SiteFile {
  std::string name;  // path inside site/
  std::string bytes;
};

// The page in which visitors play by hand. The page has a separate content security policy.
inline constexpr const char* playground_name = "playground.html";

// Functions that return the bytes of files, by their names inside site/. Most pages of a large
// league are seldom read, so a server makes a page only when it is asked for. The data from which
// such functions were made must outlive them.
using FileMakers = std::map<std::string, std::function<std::string()>>;

}  // namespace mirocup::league
