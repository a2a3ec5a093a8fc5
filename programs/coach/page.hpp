// SPDX-License-Identifier: MIT
//
// The page of a study: for each goal the leg as it was played beside a future without the goal,
// with one time for both.
#pragma once

#include "programs/coach/study.hpp"

#include <string>

namespace mirocup::coach {

// Returns a page that needs nothing else. It plays one more future of each goal that could be
// prevented. `texts` are the answers in words, one for each goal; `about` stands at the end. Errors
// and preconditions: as for study_goals().
Result<std::string> page_of(const record::MatchRecord& record, const Cast& cast,
                            const std::vector<GoalStudy>& goals,
                            const std::vector<std::string>& texts, const std::string& about);

}  // namespace mirocup::coach
