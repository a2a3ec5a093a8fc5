// SPDX-License-Identifier: MIT
//
// The names of the functions of a library, from the tables of symbols in its file.
//
// As in elf.hpp, the bytes come from a stranger: every offset is checked, and no code runs. The
// work of all loops together is bounded, because each symbol is read once, whatever the file
// claims. For line numbers, which are in the debugging information, use addr2line.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace mirocup::plugins {

// The names of functions, a name for each given address.
struct FunctionNames {
  std::vector<std::string> names;
  std::size_t symbols_read = 0;  // symbols read in all tables; at most 2^21
};

// Returns the names of the functions at these addresses, which are relative to the place where the
// library is loaded. Names of C++ are made readable, as "Mine::decide", without the types of
// arguments; other names stay unchanged. A name is "" if the file lacks it, for example in a
// stripped file. Only the first table of symbols of each kind is read.
FunctionNames functions_at(std::string_view library, std::span<const std::uint64_t> addresses);

// Returns the readable form of a function's name in a table of symbols; the name itself if it is
// not a C++ name of a form that this function knows.
std::string readable_name(std::string_view symbol);

}  // namespace mirocup::plugins
