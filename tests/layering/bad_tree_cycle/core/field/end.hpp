// SPDX-License-Identifier: MIT
//
// Two folders that include each other: core/field includes core/geometry, which includes core/field.
#include "core/geometry/angle.hpp"
