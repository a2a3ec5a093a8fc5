// SPDX-License-Identifier: MIT
#include "plugins/host/parameter_table.hpp"

#include <cassert>
#include <cstring>

namespace mirocup::plugins {

ParameterTable parameter_table(const match::TeamParameters& parameters) {
  assert(match::problem_with(parameters).empty());
  ParameterTable table;
  for (const auto& entry : parameters) {
    ParameterTable::Row& row = table.rows[table.count++];
    std::memcpy(row.name, entry.first.data(), entry.first.size());
    row.value = entry.second;
  }
  return table;
}

match::TeamParameters not_asked_for(const match::TeamParameters& parameters, std::uint32_t asked) {
  match::TeamParameters unknown;
  std::uint32_t bit = 1;
  for (const auto& entry : parameters) {
    if ((asked & bit) == 0) unknown.insert(entry);
    bit <<= 1U;
  }
  return unknown;
}

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
