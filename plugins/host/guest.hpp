// SPDX-License-Identifier: MIT
//
// In the team's process: the kind of team that the program plays. mirocup-plugin-host plays
// libraries (library_guest.cpp), mirocup-python-host plays teams in Python
// (plugins/python/python_guest.cpp).
#pragma once

#include "plugins/host/plugin.hpp"
#include "plugins/host/sandbox/file_access.hpp"

namespace mirocup::plugins {

// Returns `listed` if loading a team of this kind lists the folders of the system's libraries.
Folders folders_of_guest();

// Loads the team from the entry at `path`, which is also open as entry_descriptor, and creates it.
// `setup` must outlive the team.
tl::expected<Plugin, match::Fault> load_guest(const char* path, const mirocup_setup& setup);

}  // namespace mirocup::plugins
