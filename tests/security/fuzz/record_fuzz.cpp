// SPDX-License-Identifier: MIT
//
// Reads any bytes as a record: the reader must return an error and never crash.
#include "server/record/match_record.hpp"
#include "tests/support/memory_files.hpp"

#include <cstddef>
#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  mirocup::test_support::MemoryFiles files;
  (void)files.write("leg.json", {reinterpret_cast<const char*>(data), size});
  (void)mirocup::record::load(files, "leg.json", mirocup::record::ChecksumPolicy::ignored);
  return 0;
}
