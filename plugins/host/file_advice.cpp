// SPDX-License-Identifier: MIT
#include "plugins/host/file_advice.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace mirocup::plugins {

namespace {

constexpr const char* no_team_in_python =
    "it is Python, but no team: write \"from mirocup.team import Team\" and derive a class from "
    "Team";

bool starts_with(std::string_view bytes, std::string_view text) {
  return bytes.substr(0, text.size()) == text;
}

}  // namespace

std::string advice_on_file(std::string_view bytes) {
  constexpr std::array<std::pair<std::string_view, const char*>, 15> kinds{{
      {"!<arch>", "it is a static library (.a): link its objects with -shared"},
      {"MZ", "it is a library or program of Windows (DLL): build it on Linux, as a .so"},
      {"PK\x03\x04", "it is a zip archive: hand in the library that is in it"},
      {"\x1f\x8b", "it is a compressed archive: hand in the library that is in it"},
      {"\xcf\xfa\xed\xfe", "it is a library of macOS: build it on Linux, as a .so"},
      {"#include", "it is a source: compile it, g++ -std=c++20 -O2 -shared -fPIC"},
      {"//", "it is a source: compile it, g++ -std=c++20 -O2 -shared -fPIC"},
      {"import ", no_team_in_python},
      {"from ", no_team_in_python},
      {"\"\"\"", no_team_in_python},
      {"# ", no_team_in_python},
      {"class ", no_team_in_python},
      {"#!/usr/bin/env python", no_team_in_python},
      {"#!/usr/bin/python", no_team_in_python},
      {"#!", "it is a script: a team is a shared library, or a file of Python"},
  }};
  const auto* found = std::find_if(
      kinds.begin(), kinds.end(), [&](const auto& kind) { return starts_with(bytes, kind.first); });
  if (found != kinds.end()) return found->second;
  const bool is_text = bytes.find('\0') == std::string_view::npos;
  return is_text ? "it is not an ELF file but a text: hand in the shared library (.so) that the "
                   "build made, or a file of Python with \"from mirocup.team import Team\""
                 : "";
}

std::string advice_on_missing_entry(std::string_view bytes) {
  // The C++ name of a function without parameters ends with v.
  if (bytes.find("_Z13mirocup_entryv") != std::string_view::npos)
    return "it exports mirocup_entry() under a C++ name: declare it extern \"C\", or write "
           "MIROCUP_EXPORT_TEAM(YourClass, \"name\")";
  return "it exports no function mirocup_entry(): write MIROCUP_EXPORT_TEAM(YourClass, \"name\"), "
         "or in C define mirocup_entry()";
}

}  // namespace mirocup::plugins
