// SPDX-License-Identifier: MIT
#include "programs/mirocup/old_project.hpp"

#include "system/text.hpp"

#include <algorithm>
#include <filesystem>
#include <regex>

namespace mirocup::app {

bool is_old_project(const std::string& path) {
  const std::string ending = system::lower_case(std::filesystem::path(path).extension().string());
  return ending == ".dsp" || ending == ".vcproj" || ending == ".vcxproj";
}

// SOURCE=.\Move.cpp, RelativePath=".\Move.cpp", <ClCompile Include="Move.cpp" />
std::vector<std::string> files_of_project(const std::string& text) {
  static const std::regex one(
      "(?:SOURCE=\"?|RelativePath[ \t\r\n]*=[ \t\r\n]*\"|<ClCompile[ \t\r\n]+Include=\")"
      "([^\"\r\n<>|]+)");
  std::vector<std::string> files;
  for (std::sregex_iterator at(text.begin(), text.end(), one), end; at != end; ++at) {
    std::string name = (*at)[1];
    std::replace(name.begin(), name.end(), '\\', '/');
    while (!name.empty() && name.back() == ' ') name.pop_back();
    files.push_back(std::filesystem::path(name).lexically_normal().string());
  }
  return files;
}

}  // namespace mirocup::app
