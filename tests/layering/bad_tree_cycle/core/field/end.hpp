// SPDX-License-Identifier: MIT
//
// Two folders that include each other: core/field includes core/geometry, and core/geometry
// includes core/field.
#include "core/geometry/angle.hpp"
