// SPDX-License-Identifier: MIT
//
// The answer of a program to the program that started it: JSON objects, one a line, in a file that
// nobody else writes. Standard output and standard error are for people: a library may print
// anything to them, and no verdict is read from them. The file is open only while a line is
// written, so that no team's process can have it.
#pragma once

#include "core/base/names.hpp"
#include "record/match_record.hpp"
#include "system/files.hpp"

#include <functional>
#include <string>

namespace mirocup::record {

// Writes one line of the answer. Errors: those of Files::append().
using WriteAnswer = std::function<Result<void>(const Json& line)>;

// Runs a command that answers into a new file at `path`, and returns its result. If the path is "",
// nobody asks and nothing is written. After an error the last line of the answer is
// {"error": Error::what, "code": Error::code}.
Result<int> answering(const std::string& path,
                      const std::function<Result<int>(const WriteAnswer&)>& run);

// Returns the last whole line of an answer, also while the program runs; null if there is none.
// Errors: those of Files::read_if_there(), or Errc::host if the line is not a JSON object.
Result<Json> last_answer(system::Files& files, const std::string& path);

}  // namespace mirocup::record

namespace mirocup {

template <>
inline constexpr std::array<std::string_view, 6> enum_names<Errc>{
    "input", "unavailable", "no_room", "damaged", "host", "interrupted"};

}  // namespace mirocup
