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

}  // namespace mirocup::plugins
