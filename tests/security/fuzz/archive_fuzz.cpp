// SPDX-License-Identifier: MIT
//
// Unpacks any bytes as the archive of a project. Whatever is in it, nothing may be written beside
// the folder, which lies in an empty one.
#include "plugins/host/project/unpack.hpp"
#include "system/files.hpp"
#include "tests/security/fuzz/fuzz_target.hpp"
#include "tests/support/temporary_folder.hpp"

#include <cstdlib>

MIROCUP_FUZZ_TARGET(archive) {
  using namespace mirocup;
  static const test_support::TemporaryFolder temporary;
  static system::Disk disk;
  const std::string archive = temporary / "archive";
  const std::string folder = temporary / "folder";
  if (!disk.write(archive, fuzz::text_of(data, size)) || !disk.remove(folder) ||
      !disk.make_folder(folder))
    std::abort();
  const auto done = plugins::unpack(archive, folder);
  if (!done && (done.error().code != Errc::input || done.error().what.empty())) std::abort();
  if (disk.names_in(temporary / "").value().size() != 2) std::abort();
}
