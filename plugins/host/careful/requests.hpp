// SPDX-License-Identifier: MIT
//
// In mirocup-careful-host: notes a team's requests to the system that are refused (files, threads,
// variables of the environment), and offsets numbers that differ from run to run.
#pragma once

#include <cstddef>
#include <cstdint>

namespace mirocup::plugins {

// From here on the numbers of process, thread and processor that the team sees are greater by this.
void offset_numbers(std::int32_t offset);

// Sets whether the team's code runs; only then requests are noted.
void note_requests(bool are_noted);

// Copies the requests until now into `text`, one a line, each once, ended with a zero.
void copy_requests(char* text, std::size_t size);

}  // namespace mirocup::plugins
