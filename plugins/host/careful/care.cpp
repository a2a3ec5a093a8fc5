// SPDX-License-Identifier: MIT
#include "plugins/host/care.hpp"

#include "plugins/host/careful/careful_memory.hpp"
#include "plugins/host/careful/requests.hpp"

namespace mirocup::plugins {

void begin_care(const Surroundings& surroundings) {
  fill_new_memory_with(surroundings.memory_fill);
  offset_numbers(surroundings.number_offset);
}

void before_call() {
  fill_stack();
  note_requests(true);
}

const char* after_call() {
  note_requests(false);
  return find_memory_mistake();
}

void write_requests(char* text, std::size_t size) {
  copy_requests(text, size);
}

}  // namespace mirocup::plugins
