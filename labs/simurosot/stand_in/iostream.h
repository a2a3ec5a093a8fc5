/* SPDX-License-Identifier: MIT */
/* Only the names of the old <iostream.h>, because a team may define other names of std itself. */
#ifndef MIROCUP_SIMUROSOT_IOSTREAM_H
#define MIROCUP_SIMUROSOT_IOSTREAM_H
#include <fstream>
#include <iomanip>
#include <iostream>
using std::cerr;
using std::cin;
using std::clog;
using std::cout;
using std::dec;
using std::endl;
using std::ends;
using std::flush;
using std::fstream;
using std::hex;
using std::ifstream;
using std::ios;
using std::iostream;
using std::istream;
using std::oct;
using std::ofstream;
using std::ostream;
using std::resetiosflags;
using std::setfill;
using std::setiosflags;
using std::setprecision;
using std::setw;
using std::streambuf;
using std::ws;
#endif
