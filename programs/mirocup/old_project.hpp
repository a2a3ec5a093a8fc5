// SPDX-License-Identifier: MIT
//
// Projects of Visual C++, which name the files to compile in a folder.
#pragma once

#include <string>
#include <vector>

namespace mirocup::app {

// True for the name of a project of Visual C++: .dsp of version 6, .vcproj, .vcxproj.
bool is_old_project(const std::string& path);

// Returns the files that the project compiles or shows, in the order of the text, relative to its
// folder, with "/" between folders. Empty if the text names no file.
std::vector<std::string> files_of_project(const std::string& text);

}  // namespace mirocup::app
