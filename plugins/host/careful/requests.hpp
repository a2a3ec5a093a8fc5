// SPDX-License-Identifier: MIT
//
// In mirocup-careful-host: notes a team's refused requests to the system (files, threads, variables
// of the environment), and adds an offset to numbers that differ from run to run.
#pragma once

#include <cstddef>
#include <cstdint>

namespace mirocup::plugins {

// From now on the numbers of process, thread and processor that the team sees are greater by this
// offset.
void offset_numbers(std::int32_t offset);

// Sets whether the team's code runs; only then requests are noted.
void note_requests(bool are_noted);

// Copies the different requests so far into `text`, one in a line. A zero ends the text.
void copy_requests(char* text, std::size_t size);

}  // namespace mirocup::plugins
