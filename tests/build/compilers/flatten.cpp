// SPDX-License-Identifier: MIT
//
// Writes a record and its replay as one flat recording. Usage: flatten RECORD FLAT
#include "record/match_record.hpp"
#include "tests/build/compilers/flat_recording.hpp"

#include <iostream>

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  mirocup::system::Disk disk;
  const auto record = mirocup::record::load(disk, argv[1]);
  if (!record) {
    std::cerr << record.error().what << '\n';
    return mirocup::exit_code(record.error().code);
  }
  const auto written = disk.write(argv[2], mirocup::test_support::flat(record->recording));
  return written ? 0 : mirocup::exit_code(written.error().code);
}
