// SPDX-License-Identifier: MIT
//
// A heading as JSON: an angle in radians, or its exact cosine and sine.
#pragma once

#include "core/base/heading.hpp"

namespace mirocup::record {

class JsonReader;

// Complains about an angle beyond +-max_angle, rad, and about a pair [cos, sin] that is not of
// length 1 within 1e-12. A pair is not normalized, because normalizing would change its last bits.
Heading read_heading(const JsonReader& json, double max_angle);

}  // namespace mirocup::record
