// SPDX-License-Identifier: MIT
#include "labs/pitch/fit.hpp"
