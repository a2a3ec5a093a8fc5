// SPDX-License-Identifier: MIT
//
// The names of the functions of a library, from the tables of symbols in its file.
//
// The bytes come from a stranger, as for elf.hpp: every offset is checked, nothing is run, and the
// work of all loops together is bounded: each symbol is read once, whatever the file claims. The
// debugging information, which has the lines, is left to addr2line.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace mirocup::plugins {

// The names of functions, one for each address that was asked for.
struct FunctionNames {
  std::vector<std::string> names;
  std::size_t symbols_read = 0;  // in all tables; at most 2^21
};

// Returns the names of the functions that have the addresses, which count from where the library is
// loaded: readable, "Mine::decide", without the types of their arguments. A name is "" if the file
// does not tell it, as a stripped file. Names that are not of C++ are left as they are.
// Only the first table of each kind is read.
FunctionNames functions_at(std::string_view library, std::span<const std::uint64_t> addresses);

// Returns the readable form of a function's name in a table of symbols; the name itself if its form
// is not one of C++ that is known here.
std::string readable_name(std::string_view symbol);

}  // namespace mirocup::plugins
