// SPDX-License-Identifier: MIT
#include "server/record/locations.hpp"

#include <filesystem>

namespace mirocup::record {

namespace fs = std::filesystem;

std::string program_folder() {
  return fs::read_symlink("/proc/self/exe").parent_path().string();
}

std::string sibling_program(const std::string& name) {
  const fs::path here = program_folder();
  const fs::path installed = here.parent_path() / "libexec" / "mirocup" / name;
  return fs::exists(here / name) ? (here / name).string() : installed.string();
}

std::string house_team(const std::string& name) {
  if (name.empty() || name.find('/') != std::string::npos) return "";
  const fs::path here = program_folder();
  for (const fs::path& folder :
       {here / "house", here.parent_path() / "lib" / "mirocup" / "house"}) {
    const fs::path library = folder / (name + ".so");
    if (fs::exists(library)) return library.string();
  }
  return "";
}

}  // namespace mirocup::record
