// SPDX-License-Identifier: MIT
#include "plugins/host/guest.hpp"

namespace mirocup::plugins {

Folders folders_of_guest() {
  return Folders::hidden;
}

tl::expected<Plugin, match::Fault> load_guest(const char* path, const mirocup_setup& setup) {
  return Plugin::load(path, setup);
}

}  // namespace mirocup::plugins
