// SPDX-License-Identifier: MIT
//
// Reads a JSON document and remembers the first problem with its JSON pointer (RFC 6901) and a
// reason: a missing or unknown key, a value of the wrong type or out of its range.
//
// A reader never throws. After a problem it still returns a value of the requested type. So a
// parser is a plain list of the keys and types that it expects, and looks for a problem once, at
// the end. All files of this project are read this way:
//
//   Result<Limits> parse_limits(std::string_view text, const std::string& path) {
//     return record::read_json<Limits>(text, path, Errc::input, [](const JsonReader& json) {
//       Limits limits;
//       json.expect_object({"schema", "seed", "league", "shares"});
//       json.expect_schema("mirocup/limits/1");
//       json.read_if_present("seed", limits.seed);
//       limits.league = json.at("league").as<RobotLeague>();
//       for (const JsonReader& share : json.at("shares").elements(1, 16)) {
//         limits.shares.push_back(share.number(0.0, 1.0));
//       }
//       return limits;
//     });
//   }
//
// The error of a wrong league is then "limits.json: /league: one of small, middle, large is
// expected, not "huge"". For files that later versions may extend, call expect_object() without a
// list of keys: it ignores unknown keys.
//
// Documents may come from strangers. Only parse_json() turns text into a tree. It builds no tree
// beyond JsonLimits, so no tree is too deep for recursive functions. A message quotes at most
// a short piece of the document.
//
// This header includes the JSON library for all who read or write JSON.
#pragma once

#include "core/base/error.hpp"
#include "core/base/names.hpp"

#include <nlohmann/json.hpp>

#include <concepts>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace mirocup::record {

// The first problem of a document.
struct JsonProblem {
  std::string pointer;  // the JSON pointer; "/" for the whole document
  std::string reason;
};

// One value of the document. A copy is cheap. The document and `problem` must outlive the reader.
// Threads: one for all readers of a document, since they share `problem`.
class JsonReader {
 public:
  using Json = nlohmann::ordered_json;

  // `pointer` is "" for the whole document. `problem` is set by the first complaint.
  JsonReader(const Json& value, std::string pointer, std::optional<JsonProblem>& problem)
      : value_(&value), pointer_(std::move(pointer)), problem_(&problem) {}

  // Reports a problem of this value, unless the document has a problem already. A long reason is
  // cut.
  void complain(const std::string& reason) const;

  // True if the value is an object. Otherwise complains.
  bool expect_object() const;

  // True if an object with only these keys; otherwise complains about it or its first other key.
  bool expect_object(std::initializer_list<std::string_view> keys) const;

  // True if the value is an array of min_size to max_size elements. Otherwise complains.
  bool expect_array(std::size_t min_size, std::size_t max_size) const;

  // Complains unless the key "schema" of this object has the given value.
  void expect_schema(std::string_view schema) const;

  bool has(const std::string& key) const { return value_->is_object() && value_->contains(key); }
  bool is_null() const { return value_->is_null(); }
  bool is_string() const { return value_->is_string(); }

  // Returns the number of elements of an array; 0 for any other value.
  std::size_t size() const { return value_->is_array() ? value_->size() : 0; }

  // Returns the member with a key, or the element with an index. If it is missing, complains and
  // returns a reader of null.
  JsonReader at(const std::string& key) const;
  JsonReader at(std::size_t index) const;

  // Returns the member with a key; nothing, without a complaint, if it is missing or null.
  std::optional<JsonReader> find(const std::string& key) const;

  // Returns all elements of an array. If the value is not an array or its size is out of range,
  // complains and returns no elements.
  std::vector<JsonReader> elements(
      std::size_t min_size = 0,
      std::size_t max_size = std::numeric_limits<std::size_t>::max()) const;

  // Returns all members of an object, in the order of the document. If the value is not an object,
  // complains and returns no members.
  std::vector<std::pair<std::string, JsonReader>> members() const;

  // Returns a finite number in [min, max]. After a complaint, returns the exceeded limit, or the
  // number in [min, max] that is nearest to 0 if the value is not a finite number.
  double number(double min = -std::numeric_limits<double>::infinity(),
                double max = std::numeric_limits<double>::infinity()) const;

  // Returns a number above 0. After a complaint, returns 1.
  double positive_number() const;

  // Returns a number without a fraction in [min, max]; 3.0 is such a number. After a complaint,
  // returns the number in [min, max] that is nearest to the value, or to 0 if the value is not a
  // number.
  template <std::integral T>
  T integer(T min = std::numeric_limits<T>::min(), T max = std::numeric_limits<T>::max()) const;

  bool boolean() const;
  std::string text() const;

  // Returns the enumerator with the name in the value; E needs enum_names (core/base/names.hpp).
  // After a complaint, returns the first enumerator.
  template <class E>
  E name() const;

  // Returns the value as T: a bool, an integer, a double, a std::string or an enum.
  template <class T>
  T as() const;

  // Sets `value` to the member with a key. If the member is missing, `value` stays unchanged; if it
  // is null, complains about the wrong type.
  template <class T>
  void read_if_present(const std::string& key, T& value) const {
    if (has(key)) value = at(key).as<T>();
  }

  // Returns the value as text for a message: its JSON, cut if long, or "an object", "an array".
  std::string quoted() const;

  const Json& json() const { return *value_; }

 private:
  using Whole = std::variant<std::int64_t, std::uint64_t>;

  // Returns the number if it has no fraction; otherwise complains.
  std::optional<Whole> whole_number() const;
  void complain_of_range(const std::string& value, bool is_below, const std::string& limit) const;

  const Json* value_;
  std::string pointer_;
  std::optional<JsonProblem>* problem_;
};

// The limits of a document. The defaults are many times larger than the files of this project.
struct JsonLimits {
  std::size_t bytes = 32u << 20;   // most bytes of the whole text
  std::size_t depth = 64;          // most levels of nested lists and objects
  std::size_t values = 1'000'000;  // most numbers, texts, lists, objects, …, all together
  std::size_t members = 256;       // most members of one object, since keys are compared one by one
  std::size_t number = 1024;       // most characters of one number
  std::size_t text = 1u << 20;     // most bytes of one text or key
};

// A parsed document, or its problem: the text is not JSON or larger than the limits, has a key
// twice in one object, or has a character U+0000.
struct ParsedJson {
  JsonReader::Json value;
  std::optional<JsonProblem> problem;
  std::size_t values = 0;  // number of values, counted as in JsonLimits
};
ParsedJson parse_json(std::string_view text, const JsonLimits& limits = {});

// Returns the text of a value: in one line, or with `indent` spaces for each level. Bytes that are
// not UTF-8 become U+FFFD, so the text is always JSON.
std::string json_text(const JsonReader::Json& value, int indent = -1);

// Returns the text at a key of an object; "" if the object has no such text.
std::string text_in(const JsonReader::Json& object, const char* key);

// Returns the error that a person reads: "PATH: POINTER: REASON".
Error error_of(const JsonProblem& problem, const std::string& path, Errc code);

// Parses `text`, calls read() with the reader of the whole document, and returns its result. If the
// document has a problem, returns the first problem as an error of `code` that names `path`.
template <class T, class Read>
Result<T> read_json(std::string_view text, const std::string& path, Errc code, Read read,
                    const JsonLimits& limits = {}) {
  const ParsedJson parsed = parse_json(text, limits);
  if (parsed.problem) return tl::unexpected(error_of(*parsed.problem, path, code));
  std::optional<JsonProblem> problem;
  T value = read(JsonReader(parsed.value, "", problem));
  if (problem) return tl::unexpected(error_of(*problem, path, code));
  return value;
}

template <std::integral T>
T JsonReader::integer(T min, T max) const {
  const auto nearest_to_zero = [&] { return min > T{0} ? min : max < T{0} ? max : T{0}; };
  const std::optional<Whole> whole = whole_number();
  if (!whole) return nearest_to_zero();
  return std::visit(
      [&](auto value) {
        const bool is_below = std::cmp_less(value, min);
        if (!is_below && !std::cmp_greater(value, max)) return static_cast<T>(value);
        const T limit = is_below ? min : max;
        complain_of_range(std::to_string(value), is_below, std::to_string(limit));
        return limit;
      },
      *whole);
}

template <class E>
E JsonReader::name() const {
  static_assert(!enum_names<E>.empty(), "an enum that is read from JSON needs enum_names");
  const auto known = value_->is_string() ? from_string<E>(text()) : std::nullopt;
  if (known) return *known;
  complain("one of " + list_of_names<E>() + " is expected, not " + quoted());
  return E{};
}

template <class T>
T JsonReader::as() const {
  if constexpr (std::is_same_v<T, bool>) {
    return boolean();
  } else if constexpr (std::is_integral_v<T>) {
    return integer<T>();
  } else if constexpr (std::is_floating_point_v<T>) {
    return static_cast<T>(number());
  } else if constexpr (std::is_enum_v<T>) {
    return name<T>();
  } else {
    static_assert(std::is_same_v<T, std::string>, "JSON has no such values");
    return text();
  }
}

// Returns the object with the changes of --rule or --condition; each change is KEY=VALUE with a
// value in JSON. Errors: Errc::input, which names the option.
Result<JsonReader::Json> with_changes(JsonReader::Json object,
                                      const std::vector<std::string>& changes,
                                      const std::string& option);

// Returns null for a text that is empty, because it is not known.
inline JsonReader::Json or_null(const std::string& text) {
  return text.empty() ? JsonReader::Json() : JsonReader::Json(text);
}

// Reads the members of an object but "preset" into the members of `values` of the same names.
// for_each(values, visit) calls visit(name, member, limits...) for all of these, and
// read(json, member, limits...) reads one. Complains that there is no such `what`.
template <class Values, class ForEach, class Read>
void read_named_members(const JsonReader& json, Values& values, const char* what, ForEach for_each,
                        Read read) {
  for (const auto& [key, value] : json.members()) {
    bool is_known = key == "preset";
    for_each(values, [&key = key, &value = value, &is_known, &read](const char* name, auto& member,
                                                                    auto... limits) {
      if (key != name) return;
      is_known = true;
      read(value, member, limits...);
    });
    if (!is_known) value.complain(std::string("there is no such ") + what);
  }
}

}  // namespace mirocup::record
