/* SPDX-License-Identifier: MIT */
#include "afxwin.h"
