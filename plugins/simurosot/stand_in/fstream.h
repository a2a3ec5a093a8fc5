/* SPDX-License-Identifier: MIT */
#include <fstream>
using namespace std;
