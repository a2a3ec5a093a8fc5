// SPDX-License-Identifier: MIT
//
// A sheet of exercises: drills with weights, and the two teams between which its scale runs. The
// JSON of a sheet is "mirocup/sheet/1", specified in docs/exercises.md.
#pragma once

#include "record/drills/drill.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace mirocup::drills {

struct SheetDrill {
  std::string drill;              // the name of a drill, or the path of its file
  std::string name;               // in reports; no two drills of a sheet have the same
  double weight = 1.0;            // of its score in the score of the sheet
  nlohmann::ordered_json change;  // keys of the drill's file with other values (RFC 7396)
};

struct Sheet {
  std::string name;  // name of the file without its suffix
  std::string title;
  std::string start;      // the team that students begin with, as on the command line: score 0
  std::string reference;  // the team that solves the sheet: score 100
  std::vector<SheetDrill> drills;
  std::vector<std::string> not_allowed = {};  // words that the source of an entry may not have
};

// Returns where a source has one of these words, "line 12 has drive_to"; "" if it has none. Letters
// and digits around a word make it another word.
std::string found_word(std::string_view source, const std::vector<std::string>& words);

// Reads a sheet. An error is Errc::input and names file and key.
Result<Sheet> parse_sheet(std::string_view text, const std::string& path);

// Reads the file of a drill, `text`, with the changes of the sheet. An error is Errc::input and
// names `path` and the key.
Result<Drill> parse_changed_drill(std::string_view text, const std::string& path,
                                  const SheetDrill& of_sheet);

}  // namespace mirocup::drills
