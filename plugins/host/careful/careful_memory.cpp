// SPDX-License-Identifier: MIT
#include "plugins/host/careful/careful_memory.hpp"

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <cstring>

// The C library's own heap, from which the blocks are taken.
extern "C" {
void* __libc_malloc(std::size_t size);
void __libc_free(void* raw);
}

namespace mirocup::plugins {

namespace {

constexpr std::size_t front_size = 16;
constexpr std::size_t back_size = 32;
constexpr std::size_t heap_alignment = 16;

// Freed blocks that are kept, so that a write into one of them is noticed.
constexpr std::size_t max_kept = 4096;
constexpr std::size_t max_kept_bytes = 16u << 20;

// How many blocks are looked at after a call. The other blocks wait for their turn, so that a call
// costs about the same whether the team has ten blocks or ten thousand.
constexpr std::size_t live_at_once = 512;
constexpr std::size_t newest_freed_at_once = 64;
constexpr std::size_t freed_at_once = 128;

constexpr std::size_t filled_stack = 64u << 10;

enum class State : std::uint32_t { live = 0x11FE11FE, freed = 0x0F4EED0F };

// The head of a block, right before the bytes that the team uses. Behind these bytes comes a zone
// of back_size.
struct Block {
  Block* previous;
  Block* next;
  std::size_t size;
  void* raw;  // what the C library's heap returned
  State state;
  unsigned char freed_byte;  // fills the bytes once they are freed
  unsigned char zone_byte;   // fills the zones around the bytes
  unsigned char unused[10];
  unsigned char front[front_size];

  unsigned char* bytes() { return reinterpret_cast<unsigned char*>(this + 1); }
};
static_assert(sizeof(Block) % heap_alignment == 0);

// The heap works before any constructor runs, so all of it starts as zeros.
struct Heap {
  Block* first_live;
  Block* first_freed;  // the oldest
  Block* last_freed;
  Block* cursor;        // the live block to be looked at next
  Block* freed_cursor;  // the freed one
  std::size_t kept;
  std::size_t kept_bytes;
  std::uint8_t fill;
  char mistake[160];
};
Heap heap;

void note(const char* what, const Block* block) {
  if (heap.mistake[0] != '\0') return;
  if (block == nullptr) {
    std::snprintf(heap.mistake, sizeof heap.mistake, "%s", what);
  } else {
    std::snprintf(heap.mistake, sizeof heap.mistake, "%s a block of %zu bytes", what, block->size);
  }
}

// Compares eight bytes at a time: many blocks are looked at after each call.
bool holds_only(const unsigned char* bytes, std::size_t size, unsigned char value) {
  const std::uint64_t expected = 0x0101010101010101u * value;
  std::uint64_t word = 0;
  for (; size >= sizeof word; bytes += sizeof word, size -= sizeof word) {
    __builtin_memcpy(&word, bytes, sizeof word);
    if (word != expected) return false;
  }
  return std::all_of(bytes, bytes + size, [value](unsigned char byte) { return byte == value; });
}

void check_zones(Block* block) {
  if (!holds_only(block->front, front_size, block->zone_byte))
    note("it wrote before the beginning of", block);
  if (!holds_only(block->bytes() + block->size, back_size, block->zone_byte))
    note("it wrote behind the end of", block);
}

// Returns what the look has cost: a large block counts as several small ones.
std::size_t check_freed(Block* block) {
  check_zones(block);
  if (!holds_only(block->bytes(), block->size, block->freed_byte))
    note("it wrote into memory that it had freed,", block);
  return 1 + block->size / 1024;
}

// Both differ with the fill, so that a team which reads them answers differently.
unsigned char freed_byte() {
  return static_cast<unsigned char>(~heap.fill);
}

unsigned char zone_byte() {
  return static_cast<unsigned char>(heap.fill ^ 0xFA);
}

void* allocate(std::size_t size, std::size_t alignment) {
  const std::size_t more = sizeof(Block) + back_size + alignment;
  if (size > SIZE_MAX - more) {
    errno = ENOMEM;
    return nullptr;
  }
  void* raw = __libc_malloc(size + more);
  if (raw == nullptr) return nullptr;
  const auto lowest = reinterpret_cast<std::uintptr_t>(raw) + sizeof(Block);
  const auto address = (lowest + alignment - 1) / alignment * alignment;
  Block* block = reinterpret_cast<Block*>(address) - 1;
  *block = {nullptr, heap.first_live, size, raw, State::live, 0, zone_byte(), {}, {}};
  if (heap.first_live != nullptr) heap.first_live->previous = block;
  heap.first_live = block;
  std::memset(block->front, block->zone_byte, front_size);
  std::memset(block->bytes(), heap.fill, size);
  std::memset(block->bytes() + size, block->zone_byte, back_size);
  return block->bytes();
}

Block* block_of(void* bytes) {
  return static_cast<Block*>(bytes) - 1;
}

void give_back_oldest() {
  Block* oldest = heap.first_freed;
  check_freed(oldest);
  if (heap.freed_cursor == oldest) heap.freed_cursor = oldest->next;
  heap.first_freed = oldest->next;
  if (heap.first_freed == nullptr) {
    heap.last_freed = nullptr;
  } else {
    heap.first_freed->previous = nullptr;
  }
  --heap.kept;
  heap.kept_bytes -= oldest->size;
  __libc_free(oldest->raw);
}

void release(void* bytes) {
  Block* block = block_of(bytes);
  if (block->state == State::freed) return note("it freed twice", block);
  if (block->state != State::live)
    return note("it freed memory that was not from the heap", nullptr);
  check_zones(block);
  if (heap.cursor == block) heap.cursor = block->next;
  if (block->previous != nullptr) block->previous->next = block->next;
  if (block->next != nullptr) block->next->previous = block->previous;
  if (heap.first_live == block) heap.first_live = block->next;
  block->state = State::freed;
  block->previous = heap.last_freed;
  block->next = nullptr;
  block->freed_byte = freed_byte();
  std::memset(block->bytes(), block->freed_byte, block->size);
  if (heap.last_freed != nullptr) heap.last_freed->next = block;
  if (heap.first_freed == nullptr) heap.first_freed = block;
  heap.last_freed = block;
  ++heap.kept;
  heap.kept_bytes += block->size;
  while (heap.kept > max_kept || heap.kept_bytes > max_kept_bytes) give_back_oldest();
}

}  // namespace

void fill_new_memory_with(std::uint8_t fill) {
  heap.fill = fill;
}

void fill_as_freed(void* bytes, std::size_t size) {
  std::memset(bytes, freed_byte(), size);
}

[[gnu::noinline]] void fill_stack() {
  unsigned char unused[filled_stack];
  std::memset(unused, heap.fill, sizeof unused);
  asm volatile("" : : "r"(unused) : "memory");  // so that the compiler keeps the writes
}

const char* find_memory_mistake() {
  if (heap.cursor == nullptr) heap.cursor = heap.first_live;
  for (std::size_t i = 0; i < live_at_once && heap.cursor != nullptr; ++i) {
    check_zones(heap.cursor);
    heap.cursor = heap.cursor->next;
  }
  // A block is written to most often right after it was freed.
  std::size_t looked_at = 0;
  for (Block* block = heap.last_freed; block != nullptr && looked_at < newest_freed_at_once;
       block = block->previous) {
    looked_at += check_freed(block);
  }
  if (heap.freed_cursor == nullptr) heap.freed_cursor = heap.first_freed;
  for (looked_at = 0; heap.freed_cursor != nullptr && looked_at < freed_at_once;
       heap.freed_cursor = heap.freed_cursor->next) {
    looked_at += check_freed(heap.freed_cursor);
  }
  return heap.mistake[0] == '\0' ? nullptr : heap.mistake;
}

}  // namespace mirocup::plugins

// The program exports these, so that every library of the process uses them.
extern "C" {

using namespace mirocup::plugins;

void* malloc(std::size_t size) noexcept {
  return allocate(size, heap_alignment);
}

void free(void* bytes) noexcept {
  const int kept_errno = errno;
  if (bytes != nullptr) release(bytes);
  errno = kept_errno;
}

void* calloc(std::size_t count, std::size_t size) noexcept {
  std::size_t all = 0;
  if (__builtin_mul_overflow(count, size, &all)) {
    errno = ENOMEM;
    return nullptr;
  }
  void* bytes = allocate(all, heap_alignment);
  if (bytes != nullptr) std::memset(bytes, 0, all);
  return bytes;
}

void* realloc(void* bytes, std::size_t size) noexcept {
  if (bytes == nullptr) return allocate(size, heap_alignment);
  void* moved = allocate(size, heap_alignment);
  if (moved == nullptr) return nullptr;
  std::memcpy(moved, bytes, std::min(size, block_of(bytes)->size));
  release(bytes);
  return moved;
}

void* memalign(std::size_t alignment, std::size_t size) noexcept {
  return allocate(size, std::max(alignment, heap_alignment));
}

void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
  return memalign(alignment, size);
}

int posix_memalign(void** bytes, std::size_t alignment, std::size_t size) noexcept {
  if (alignment < sizeof(void*) || (alignment & (alignment - 1)) != 0) return EINVAL;
  void* made = memalign(alignment, size);
  if (made == nullptr) return ENOMEM;
  *bytes = made;
  return 0;
}

void* valloc(std::size_t size) noexcept {
  constexpr std::size_t page = 4096;
  return memalign(page, size);
}

std::size_t malloc_usable_size(void* bytes) noexcept {
  return bytes == nullptr ? 0 : block_of(bytes)->size;
}

}  // extern "C"
