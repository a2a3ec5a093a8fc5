/* SPDX-License-Identifier: MIT */
#include "iostream.h"
