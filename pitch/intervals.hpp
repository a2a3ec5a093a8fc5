// SPDX-License-Identifier: MIT
//
// The interval in which a number lies, from the cost along it (Fit::profile). It begins with the
// rise of the cost, and is wider where windows differ by more than noise, where one of them pulls
// alone, and where few tell the number.
#pragma once

#include "pitch/fit.hpp"
#include "pitch/identify.hpp"

namespace mirocup::pitch {

inline constexpr double z95 = 1.959964;     // standard deviations to each side hold 95 %
inline constexpr double rise95 = 3.841459;  // of a cost, at the ends of an interval

// Returns the value of the least cost and its interval of 95 %, in the units of the profile's
// values. At least two windows have told it. `others` is the standard deviation that comes from
// what else is uncertain.
Estimate interval_of(const Fit::Profile& profile, double others);

}  // namespace mirocup::pitch
