// SPDX-License-Identifier: MIT
#include "core/field/end.hpp"
