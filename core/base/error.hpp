// SPDX-License-Identifier: MIT
//
// What can go wrong outside the game, and how it is told.
//
// A function that can fail for a reason outside the program returns Result<T>. A forfeit, a crash
// of a strategy or a void leg is not an error: it is a value of the match. Once constructed, core
// does not fail at all: a bad command is zeroed or clamped and counted.
#pragma once

#include <tl/expected.hpp>

#include <string>
#include <utility>

namespace mirocup {

// Why something failed, as far as a script has to know. One exit code belongs to each: see
// exit_code().
enum class Errc {
  input,        // wrong usage, or a file that a person wrote says something impossible
  unavailable,  // a file, a child process or the network cannot be had
  damaged,      // data that a program wrote is not what it wrote, or is of another version
  host,         // the machine failed; nothing was decided; run again
  interrupted,  // asked to stop; the same command goes on later
};

// `what` is a sentence for the person who must act: it names the file, the key, the symbol.
struct Error {
  Errc code;
  std::string what;
};

template <class T>
using Result = tl::expected<T, Error>;

inline tl::unexpected<Error> fail(Errc code, std::string what) {
  return tl::unexpected<Error>(Error{code, std::move(what)});
}

// Exit codes that say "done": 0 where the answer is yes, 1 where it is no (diverged, rejected, left
// over).
inline constexpr int exit_yes = 0;
inline constexpr int exit_no = 1;

// The exit code of each error, the same in every program.
constexpr int exit_code(Errc code) {
  switch (code) {
    case Errc::input:
      return 2;
    case Errc::unavailable:
      return 3;
    case Errc::damaged:
      return 4;
    case Errc::host:
      return 5;
    case Errc::interrupted:
      return 130;
  }
  return 5;
}

}  // namespace mirocup
