// SPDX-License-Identifier: MIT
//
// What the tests of teams on the network share.
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

// Matches of tests that run at the same time must not meet.
inline std::string match_id(const std::string& name) {
  return name + "-" + std::to_string(getpid());
}

// The command line of a house team, or the library at a path, that joins a match.
inline std::vector<std::string> join(const std::string& id, const std::string& colour,
                                     const std::string& name, const std::string& team) {
  const std::string library =
      team.find('/') == std::string::npos ? program("house/" + team + ".so") : team;
  return {program("mirocup"), "join", "--match", id, "--team", colour, "--name", name, library};
}

// Until something holds that another process brings about; false if it never does.
inline bool wait_until(const std::function<bool()>& holds) {
  for (int i = 0; i < 3000; ++i) {
    if (holds()) return true;
    usleep(10'000);
  }
  return false;
}

inline bool has_said(const Running& process, const std::string& text) {
  return wait_until([&] { return process.err().find(text) != std::string::npos; });
}

// UDP sockets of a process: how many, and how many packets they have dropped.
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

// The process has appeared on the network.
inline bool is_there(const Running& process) {
  return wait_until([&] { return sockets_of(process.pid()).open > 0; });
}

// Runs something with more and more patience, until it says what is expected: a busy machine needs
// longer to know.
inline Outcome run_until_said(const std::string& what,
                              const std::function<Outcome(const std::string& patience)>& attempt) {
  Outcome last;
  for (const char* patience : {"1.5", "6", "30"}) {
    last = attempt(patience);
    if ((last.out + last.err).find(what) != std::string::npos) break;
  }
  return last;
}

// A program with a library of tests/support loaded first; `how` are variables of the environment.
inline std::vector<std::string> preloaded(const std::string& library,
                                          const std::vector<std::string>& arguments,
                                          std::vector<std::string> how) {
  how.insert(how.begin(), {"/usr/bin/env", "LD_PRELOAD=" + program(library),
                           "ASAN_OPTIONS=verify_asan_link_order=0"});
  how.insert(how.end(), arguments.begin(), arguments.end());
  return how;
}

// Whose packets get lost or are garbled, as tests/support/bad_network.c says.
inline std::vector<std::string> on_bad_network(const std::vector<std::string>& arguments,
                                               const std::vector<std::string>& how) {
  return preloaded("bad_network.so", arguments, how);
}

// On a computer whose clock is so many hours behind; so are those of the processes that it starts.
inline std::vector<std::string> behind(int hours, const std::vector<std::string>& arguments) {
  return preloaded("old_clock.so", arguments, {"OLD_CLOCK=" + std::to_string(3600L * hours)});
}

}  // namespace mirocup::test_support
