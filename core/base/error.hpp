// SPDX-License-Identifier: MIT
//
// Errors: failures outside of the game, and how functions report them.
//
// A function that can fail for a reason outside the program returns Result<T>. A forfeit, the crash
// of a strategy and a void leg are not errors: they are outcomes of the leg. Once constructed, the
// objects of core do not fail at all: a bad command is zeroed or clamped, and counted.
#pragma once

#include <tl/expected.hpp>

#include <string>
#include <utility>

namespace mirocup {

// The kinds of failure that a script has to tell apart. Each has an exit code: see exit_code().
enum class Errc {
  input,        // wrong usage, or an impossible value in a file that a person wrote
  unavailable,  // a file, a child process or the network is not available
  no_room,      // the disk, or the user's part of it, is full
  damaged,      // data that a program wrote was changed, or is of another version
  host,         // the machine failed and nothing was decided: run it again
  interrupted,  // stopped on request: the same command, given again, continues
};

// A failure. `what` is a sentence for the person who must act: it names the file, key or symbol.
struct Error {
  Errc code;
  std::string what;
};

// A value or the reason why there is none.
template <class T>
using Result = tl::expected<T, Error>;

// Returns a failure for the return statement of a function with a Result.
inline tl::unexpected<Error> fail(Errc code, std::string what) {
  return tl::unexpected<Error>(Error{code, std::move(what)});
}

// MIROCUP_TRY(const auto file, open(path)); declares `file` with the value of a Result, or returns
// its error from the function; MIROCUP_TRY(file, open(path)); assigns the value.
// MIROCUP_TRY_VOID(write(path)); returns the error, if there is one. Use each of them as a whole
// statement inside braces.
#define MIROCUP_TRY(value, ...)                                                                    \
  auto MIROCUP_TRIED(__LINE__) = __VA_ARGS__;                                                      \
  if (!MIROCUP_TRIED(__LINE__)) return tl::unexpected(std::move(MIROCUP_TRIED(__LINE__)).error()); \
  value = *std::move(MIROCUP_TRIED(__LINE__))
#define MIROCUP_TRY_VOID(...) \
  if (auto tried_ = __VA_ARGS__; !tried_) return tl::unexpected(std::move(tried_).error())
#define MIROCUP_TRIED(line) MIROCUP_TRIED_IN(line)
#define MIROCUP_TRIED_IN(line) tried_##line

// Exit codes of a program that did its work. 0: yes; 1: no (a replay diverged, a file was rejected,
// fixtures are left to play).
inline constexpr int exit_yes = 0;
inline constexpr int exit_no = 1;

// Returns the exit code of an error; it is the same in every program.
constexpr int exit_code(Errc code) {
  switch (code) {
    case Errc::input:
      return 2;
    case Errc::unavailable:
    case Errc::no_room:
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
