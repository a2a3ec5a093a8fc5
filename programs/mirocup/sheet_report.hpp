// SPDX-License-Identifier: MIT
//
// The scores of entries on the scale of a sheet, as JSON, CSV and text.
//
// The scale of a drill is linear in its marks: 0 is what the sheet's start has with the same tries,
// 100 what its reference has; scores end there. The score of the sheet is the mean of the scores
// of its drills by their weights.
#pragma once

#include "programs/mirocup/drill_report.hpp"
#include "record/drills/sheet.hpp"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace mirocup::app {

// The start and the reference of a sheet, tried with the same seeds as the entries.
struct SheetScale {
  DrillReport start;
  DrillReport reference;
};

// Returns {"sheet", "title", "first_seed", "teams": [{"team", "score", "low", "high", "note",
// "drills": [{"name", "version", "score", "low", "high", "tries", "failed_seeds", "weight",
// "marks", "start", "reference"}]}]}. With other seeds, a score would be between low and high in 95
// of 100 cases. "note" is the first fault of the entry; null: none.
nlohmann::ordered_json sheet_json(const drills::Sheet& sheet, std::uint64_t first_seed,
                                  const SheetScale& scale, const std::vector<DrillReport>& entries);

// These return the JSON of sheet_json() as a line for each team (team, sheet, score, low, high,
// note, and the score in each drill), and as text for a person.
std::string sheet_csv(const nlohmann::ordered_json& json);
std::string sheet_text(const nlohmann::ordered_json& json);

}  // namespace mirocup::app
