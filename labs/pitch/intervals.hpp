// SPDX-License-Identifier: MIT
//
// The interval of a number, from the costs at some values of the number (Fit::profile). The basis
// is the rise of the cost. The interval is wider if windows differ by more than noise, if one
// window alone decides, or if few windows depend on the number.
#pragma once

#include "labs/pitch/fit.hpp"
#include "labs/pitch/identify.hpp"

namespace mirocup::pitch {

inline constexpr double z95 = 1.959964;     // half-width of a 95 % interval in standard deviations
inline constexpr double rise95 = 3.841459;  // rise of a cost at the ends of a 95 % interval

// Returns the value with the least cost and its interval of 95 %, in the units of the profile's
// values. Precondition: at least two windows depend on the number. `others` is the standard
// deviation that the number has because the other numbers are uncertain.
Estimate interval_of(const Fit::Profile& profile, double others);

}  // namespace mirocup::pitch
