// SPDX-License-Identifier: MIT
//
// The half of parameter_table.hpp that runs in a team's process. It stands apart because that
// program is built without sanitizers and so must not need an object file of core.
#include "plugins/host/parameter_table.hpp"

#include <cstring>

namespace mirocup::plugins {

double parameter_of(void* host, const char* name, double fallback) {
  if (host == nullptr || name == nullptr) return fallback;
  const auto& own = *static_cast<const ParameterHost*>(host);
  for (std::uint32_t i = 0; i < own.table->count; ++i) {
    if (std::strcmp(own.table->rows[i].name, name) != 0) continue;
    own.asked->fetch_or(1U << i, std::memory_order_relaxed);
    return own.table->rows[i].value;
  }
  return fallback;
}

}  // namespace mirocup::plugins
