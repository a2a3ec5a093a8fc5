// SPDX-License-Identifier: MIT
#include "plugins/host/care.hpp"

namespace mirocup::plugins {

void begin_care(const Surroundings&) {}

void before_call() {}

Mistake after_call() {
  return {};
}

const mirocup_observation& lend(const mirocup_observation& observation) {
  return observation;
}

mirocup_command& lend_command() {
  static mirocup_command command;
  command = {};
  return command;
}

void write_requests(char*, std::size_t) {}

}  // namespace mirocup::plugins
