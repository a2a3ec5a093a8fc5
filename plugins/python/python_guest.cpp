// SPDX-License-Identifier: MIT
#include "plugins/host/guest.hpp"
#include "plugins/host/launch.hpp"
#include "plugins/python/python_team.hpp"

#include <array>
#include <unistd.h>

namespace mirocup::plugins {

Folders folders_of_guest() {
  return Folders::listed;
}

tl::expected<Plugin, match::Fault> load_guest(const char*, const mirocup_setup& setup) {
  std::string text;
  std::array<char, 1 << 16> buffer;
  ssize_t length = 0;
  while ((length = pread(entry_descriptor, buffer.data(), buffer.size(),
                         static_cast<off_t>(text.size()))) > 0)
    text.append(buffer.data(), static_cast<std::size_t>(length));
  MIROCUP_TRY(auto team, python::load_team(text, "team.py", setup, python::Surrounding::sandbox));
  return Plugin::adopt(*team.strategy, team.team);
}

}  // namespace mirocup::plugins
