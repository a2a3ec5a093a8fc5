// SPDX-License-Identifier: MIT
//
// The files of the published league.
#pragma once

#include <functional>
#include <map>
#include <string>

namespace mirocup::league {

struct SiteFile {
  std::string name;  // inside site/
  std::string bytes;
};

// Functions that return the bytes of files, by their names inside site/. Of a large league most
// pages are seldom read, so that a server makes each only when it is asked for. The functions refer
// to what they were made from.
using FileMakers = std::map<std::string, std::function<std::string()>>;

}  // namespace mirocup::league
