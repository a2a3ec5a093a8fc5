// SPDX-License-Identifier: MIT
//
// Helpers of the tests of teams on the network.
#pragma once

#include "tests/support/program.hpp"

#include <filesystem>
#include <functional>
#include <iterator>
#include <set>
#include <sstream>
#include <string>
#include <unistd.h>
#include <vector>

namespace mirocup::test_support {

// Returns an ID of its own for each test process, because tests may run at the same time.
inline std::string match_id(const std::string& name) {
  return name + "-" + std::to_string(getpid());
}

// Returns the command line with which a house team, or the library at a path, joins a match, with
// further options.
inline std::vector<std::string> join(const std::string& id, const std::string& colour,
                                     const std::string& name, const std::string& team,
                                     std::vector<std::string> more = {}) {
  const bool is_house = team.find('/') == std::string::npos;
  more.insert(more.begin(), {program("mirocup"), "join", "--match", id, "--team", colour, "--name",
                             name, is_house ? program("house/" + team + ".so") : team});
  return more;
}

// Waits until the process has written `text` to standard error. False if it never does.
inline bool has_said(const Running& process, const std::string& text) {
  return wait_until([&] { return process.err().find(text) != std::string::npos; });
}

// The UDP sockets of a process: their number, and the number of packets that they have dropped.
struct Sockets {
  int open = 0;
  long dropped = 0;
};
inline Sockets sockets_of(int pid) {
  std::set<std::string> own;
  std::error_code none;
  for (const auto& entry :
       std::filesystem::directory_iterator("/proc/" + std::to_string(pid) + "/fd", none)) {
    own.insert(std::filesystem::read_symlink(entry.path(), none).string());
  }
  Sockets sockets;
  std::istringstream table(read_file("/proc/net/udp"));
  std::string line;
  while (std::getline(table, line)) {
    std::istringstream text(line);
    const std::vector<std::string> words{std::istream_iterator<std::string>(text), {}};
    constexpr std::size_t inode = 9, drops = 12;
    if (words.size() <= drops || own.count("socket:[" + words[inode] + "]") == 0) continue;
    ++sockets.open;
    sockets.dropped += std::stol(words[drops]);
  }
  return sockets;
}

// Waits until the process has opened a UDP socket. False if it never does.
inline bool is_there(const Running& process) {
  return wait_until([&] { return sockets_of(process.pid()).open > 0; });
}

// Repeats an attempt with longer and longer time limits until it prints the expected text, because
// a busy machine needs more time.
inline Outcome run_until_said(const std::string& what,
                              const std::function<Outcome(const std::string& patience)>& attempt) {
  Outcome last;
  for (const char* patience : {"1.5", "6", "30"}) {
    last = attempt(patience);
    if ((last.out + last.err).find(what) != std::string::npos) break;
  }
  return last;
}

// Returns the command line of a program that loads a library of tests/support first. `how`:
// variables of its environment.
inline std::vector<std::string> preloaded(const std::string& library,
                                          const std::vector<std::string>& arguments,
                                          std::vector<std::string> how) {
  how.insert(how.begin(), {"/usr/bin/env", "LD_PRELOAD=" + program_for_all(library),
                           "ASAN_OPTIONS=verify_asan_link_order=0"});
  how.insert(how.end(), arguments.begin(), arguments.end());
  return how;
}

// The packets that the program sends are lost or changed, as tests/support/bad_network.c describes.
inline std::vector<std::string> on_bad_network(const std::vector<std::string>& arguments,
                                               const std::vector<std::string>& how) {
  return preloaded("bad_network.so", arguments, how);
}

// A program that receives changed packets. Cyclone DDS forgets to free what it has copied of a few
// of them (ddsrt_memdup), which LeakSanitizer would make an exit code of the program. `list`: a
// new file that tells it so.
inline std::vector<std::string> under_garbage(std::vector<std::string> arguments,
                                              const std::string& list) {
  write_file(list, "leak:ddsrt_memdup\n");
  arguments.insert(arguments.begin(),
                   {"/usr/bin/env", "LSAN_OPTIONS=print_suppressions=0:suppressions=" + list});
  return arguments;
}

// The program and the processes that it starts see a clock that is this many hours behind.
inline std::vector<std::string> behind(int hours, const std::vector<std::string>& arguments) {
  return preloaded("old_clock.so", arguments, {"OLD_CLOCK=" + std::to_string(3600L * hours)});
}

}  // namespace mirocup::test_support
