// SPDX-License-Identifier: MIT
//
// Reads a shared library without loading it: whether it is a complete library for this machine, its
// exports and the libraries that it needs.
//
// The bytes come from a stranger: every offset is checked before it is followed, no code runs, and
// the size of the file bounds time and memory to a tenth of a second and some hundred KiB, whatever
// the tables of the file claim. The project does not use libelf, so that all of these checks are in
// this reader. A library that passes the checks can still fail to load, which only the sandbox
// finds out.
#pragma once

#include "system/processor.hpp"

#include <tl/expected.hpp>

#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mirocup::plugins {

struct SharedLibrary {
  std::vector<std::string> needed;  // names of the libraries that this library needs (DT_NEEDED)
  std::string search_path;          // DT_RUNPATH or DT_RPATH; "" if the library has neither
  bool exports_entry = false;       // true: the library defines a function mirocup_entry
};

// Returns the least level of processors with the instructions of a library for x86-64: SSSE3 to
// SSE4.2 (opcodes behind 0f 38 and 0f 3a) are of v2, AVX, AVX2 and BMI (prefix VEX) of v3, AVX-512
// (prefix EVEX) of v4. Other instructions are not told apart. All code counts, also a function that
// runs only if the processor has its instructions. Data between functions are taken for code, so a
// single instruction of a level does not count. Returns v1 for other files. The function reads no
// more bytes of code than the file has.
system::Processor processor_for(std::string_view library);

// Returns the item at an offset of a file; nothing if the file ends before the end of the item.
template <class T>
std::optional<T> item_at(std::string_view bytes, std::uint64_t offset) {
  if (offset > bytes.size() || bytes.size() - offset < sizeof(T)) return std::nullopt;
  T value;
  std::memcpy(&value, bytes.data() + offset, sizeof value);
  return value;
}

// Reads the whole file in `bytes`. The error is a sentence with advice for the library's author.
tl::expected<SharedLibrary, std::string> read_shared_library(std::string_view bytes);

}  // namespace mirocup::plugins
