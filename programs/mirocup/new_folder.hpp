// SPDX-License-Identifier: MIT
//
// What every new team is made with: its folder, and the files of templates with the team's own
// words in them.
#pragma once

#include "core/base/error.hpp"
#include "system/files.hpp"
#include "system/locations.hpp"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace mirocup::app {

// Words of a template, each with the text that takes its place.
using Words = std::vector<std::pair<std::string, std::string>>;

// Errc::input if there is something in the folder.
Result<void> expect_empty_folder(const std::string& folder);

// Returns what takes the place of the words that all templates share: names, and places of this
// installation.
Words template_words(const system::TeamKit& kit, const std::string& folder);

// Copies a file of the installation into the folder, with other words in place of some.
Result<void> write_filled(system::Disk& disk, const std::filesystem::path& file,
                          const std::string& folder, const Words& words);

}  // namespace mirocup::app
