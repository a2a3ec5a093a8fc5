// SPDX-License-Identifier: MIT
//
// Reads any bytes as a record: the reader must return an error and never crash.
#include "record/match_record.hpp"
#include "tests/security/fuzz/fuzz_target.hpp"
#include "tests/support/memory_files.hpp"

MIROCUP_FUZZ_TARGET(record) {
  mirocup::test_support::MemoryFiles files;
  (void)files.write("leg.json", mirocup::fuzz::text_of(data, size));
  (void)mirocup::record::load(files, "leg.json", mirocup::record::ChecksumPolicy::ignored);
}
