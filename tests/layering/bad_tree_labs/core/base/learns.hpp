// SPDX-License-Identifier: MIT
//
// The layering check must not accept this file: nothing outside of labs uses labs.
#include "labs/pitch/fit.hpp"
