/* SPDX-License-Identifier: MIT */
#include <iostream>
using namespace std;
