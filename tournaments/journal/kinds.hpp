// SPDX-License-Identifier: MIT
//
// The lines of a journal as a std::variant of structs. Each struct has the name of its kind,
// `kind`, and lists its other keys by list_fields (record/json_fields.hpp).
#pragma once

#include "record/json_fields.hpp"
#include "tournaments/journal/journal.hpp"

#include <type_traits>
#include <variant>

namespace mirocup::league {

template <class... Kinds>
std::optional<std::variant<Kinds...>> read_kind(const record::JsonReader& line,
                                                std::type_identity<std::variant<Kinds...>>) {
  const record::JsonReader name = line.at("kind");
  const auto* kind = name.json().get_ptr<const std::string*>();
  std::optional<std::variant<Kinds...>> read;
  const auto read_if_named = [&]<class Kind>(std::type_identity<Kind>) {
    if (kind != nullptr && *kind == Kind::kind) read = record::read_fields<Kind>(line);
  };
  (read_if_named(std::type_identity<Kinds>()), ...);
  if (!read) name.complain("no kind of journal line is called " + name.quoted());
  return read;
}

// Returns "line 7", with the number that the journal gave to the line.
inline std::string name_of_line(const Json& line) {
  return line.is_object() && line.contains("n") ? "line " + record::json_text(line["n"]) : "a line";
}

// Reads a line of a journal. Errors: Errc::damaged, which begins with `where` and names the line.
template <class Line>
Result<Line> read_line(const Json& line, const std::string& where = "") {
  std::optional<record::JsonProblem> problem;
  auto read = read_kind(record::JsonReader(line, "", problem), std::type_identity<Line>());
  if (problem)
    return tl::unexpected(record::error_of(*problem, where + name_of_line(line), Errc::damaged));
  return std::move(*read);
}

// Return the kind of a line and its keys, for Journal::append().
template <class Line>
std::string_view line_kind(const Line& line) {
  return std::visit([](const auto& one) { return one.kind; }, line);
}
template <class Line>
Json line_fields(const Line& line) {
  return std::visit([](const auto& one) { return record::fields_json(one); }, line);
}

}  // namespace mirocup::league
