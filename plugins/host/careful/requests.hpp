// SPDX-License-Identifier: MIT
//
// What a team asks the system for and does not get, noted in mirocup-careful-host: files, threads,
// variables of the environment. And numbers that differ from run to run, here by a known offset.
#pragma once

#include <cstddef>
#include <cstdint>

namespace mirocup::plugins {

// From here on the numbers of process, thread and processor that the team sees are greater by this.
void offset_numbers(std::int32_t offset);

// Whether the team's code runs; only then requests are noted.
void note_requests(bool are_noted);

// Copies the requests until now into `text`, one a line, each once, with a zero behind.
void copy_requests(char* text, std::size_t size);

}  // namespace mirocup::plugins
