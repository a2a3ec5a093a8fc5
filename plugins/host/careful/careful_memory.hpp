// SPDX-License-Identifier: MIT
//
// A heap that notices mistakes. The heap replaces malloc() and free() in mirocup-careful-host and
// in the libraries that this program loads.
//
// Each block lies between two zones of known bytes. A freed block is filled and kept for a while.
// So the heap notices a write beside a block, a write into a freed block, and a block that is freed
// twice. The heap does not notice a read beside a block, or a read of memory that was never
// written. But such a read gives bytes of the fill, so the team answers differently in a leg with
// another fill.
//
// Threads: one, because a team has only one.
#pragma once

#include <cstddef>
#include <cstdint>

namespace mirocup::plugins {

// From now on new blocks are filled with this byte.
void fill_new_memory_with(std::uint8_t fill);

// Fills memory like a block that was freed.
void fill_as_freed(void* bytes, std::size_t size);

// Fills the part of the stack that the next call will use.
void fill_stack();

// Checks some hundred blocks: the blocks that were freed last, and some of the others, which take
// turns from call to call. So a mistake is found in the same call if a team has few blocks, and
// some calls later if it has thousands. Returns a sentence about the first mistake since the start
// of the process, or null.
const char* find_memory_mistake();

}  // namespace mirocup::plugins
