// SPDX-License-Identifier: MIT
//
// The memory of the machine that this process may use, and the memory that a leg needs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace mirocup::system {

// The limits of memory, bytes: of a team's process (its address space), of a match server, and of
// a leg with both teams.
inline constexpr std::size_t memory_of_a_team = std::size_t{1} << 30;
inline constexpr std::size_t memory_of_a_server = std::size_t{64} << 20;
inline constexpr std::size_t memory_of_a_leg = 2 * memory_of_a_team + memory_of_a_server;

// Returns how much memory, bytes, this process and its children could take before the kernel has to
// end a process. This is the memory that the kernel calls available or, if less, the room that is
// left in a memory cgroup around this process. Returns nothing if the kernel does not say. Tests
// pass a folder `root` with copies of the kernel's files.
std::optional<std::size_t> available_memory(const std::string& root = "");

// Returns how many processes the kernel has ended for lack of memory since its start; nothing if
// the kernel does not say.
std::optional<std::uint64_t> out_of_memory_kills(const std::string& root = "");

// Returns a size as text for a person: "181 MiB".
std::string mebibytes(std::size_t bytes);

}  // namespace mirocup::system
