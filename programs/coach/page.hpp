// SPDX-License-Identifier: MIT
//
// The page of a study: for each goal the leg as it was played beside a future without the goal,
// with one time for both.
#pragma once

#include "programs/coach/study.hpp"

#include <string>

namespace mirocup::coach {

struct PageGoal {
  GoalStudy study;
  std::string text;  // the answer in words
};

// Returns a page that needs nothing else. It plays one more future of each goal that could be
// prevented. `about` stands at its end. Errors and preconditions: as for study_goals().
Result<std::string> page_of(const record::MatchRecord& record, const Cast& cast,
                            const std::vector<PageGoal>& goals, const std::string& about);

}  // namespace mirocup::coach
