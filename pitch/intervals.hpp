// SPDX-License-Identifier: MIT
//
// The interval in which a number lies, from the cost along it (Fit::profile). It begins with the
// rise of the cost, and is wider if windows differ by more than noise, if one window alone decides,
// and if few windows tell the number.
#pragma once

#include "pitch/fit.hpp"
#include "pitch/identify.hpp"

namespace mirocup::pitch {

inline constexpr double z95 = 1.959964;     // standard deviations to each side hold 95 %
inline constexpr double rise95 = 3.841459;  // of a cost, at the ends of an interval

// Returns the value of the least cost and its interval of 95 %, in the units of the profile's
// values. Precondition: at least two windows have told it. `others` is the standard deviation that
// comes from the uncertainty of the other numbers.
Estimate interval_of(const Fit::Profile& profile, double others);

}  // namespace mirocup::pitch
