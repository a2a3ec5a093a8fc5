// SPDX-License-Identifier: MIT
//
// A heap that notices mistakes. It takes the place of malloc() and free() in mirocup-careful-host,
// also for the libraries that it loads.
//
// Each block lies between two zones of known bytes. A freed block is filled and kept for a while.
// So the heap notices a write beside a block, a write into a freed block, and a block that is freed
// twice. It does not notice a read beside a block, or of memory that was never written. But such a
// read depends on the fill, so the team answers differently in a leg with another fill.
//
// Not for several threads: a team has one.
#pragma once

#include <cstddef>
#include <cstdint>

namespace mirocup::plugins {

// From here on new blocks are filled with this byte.
void fill_new_memory_with(std::uint8_t fill);

// Fills memory like a block that was freed.
void fill_as_freed(void* bytes, std::size_t size);

// Fills the part of the stack that the next call will use.
void fill_stack();

// Looks at some hundred blocks: at the blocks that were freed last, and in turn at all others. If a
// team has few blocks, this finds a mistake in the same call; if it has thousands, some calls
// later. Returns a sentence about the first mistake since the start of the process, or null.
const char* find_memory_mistake();

}  // namespace mirocup::plugins
