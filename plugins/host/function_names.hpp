// SPDX-License-Identifier: MIT
//
// The names of the functions of a library, from the tables of symbols in its file.
//
// The bytes come from a stranger, as for elf.hpp: every offset is checked, nothing is run, and
// every loop is bounded. The debugging information, which has the lines, is left to addr2line.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace mirocup::plugins {

// Returns the name of the function that has the address, which counts from where the library is
// loaded: readable, "Mine::decide", without the types of its arguments. "" if the file does not
// tell, as one that was stripped. Bytes of a name that is none are left as they are.
std::string function_at(std::string_view library, std::uint64_t address);

// Returns the readable form of a function's name in a table of symbols; the name itself if its form
// is not one of C++ that is known here.
std::string readable_name(std::string_view symbol);

}  // namespace mirocup::plugins
