// SPDX-License-Identifier: MIT
//
// Reads a JSON document strictly: every key is known, every type and range is right, or the first
// problem is remembered with its JSON pointer. After a problem every further answer is a default, so
// a parser reads as a list of what it expects and looks at problem() once, at its end.
#pragma once

#include <nlohmann/json.hpp>

#include <initializer_list>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace mirocup::record {

// The first problem: where, and why.
struct JsonProblem {
  std::string pointer;
  std::string reason;
};

// One value of the document. Cheap to copy; the document and `problem` outlive it.
class JsonReader {
 public:
  using Json = nlohmann::ordered_json;

  JsonReader(const Json& value, std::string pointer, std::optional<JsonProblem>& problem)
      : value_(value), pointer_(std::move(pointer)), problem_(problem) {}

  void complain(const std::string& reason) const;

  // Is this an object with no other keys than these?
  bool expect_object(std::initializer_list<std::string_view> keys) const;
  // Is this an array of a size in that range?
  bool expect_array(std::size_t least, std::size_t most) const;

  bool has(const std::string& key) const { return value_.is_object() && value_.contains(key); }
  bool is_null() const { return value_.is_null(); }
  bool is_string() const { return value_.is_string(); }
  std::size_t size() const { return value_.is_array() ? value_.size() : 0; }

  // A member or an element. Of what is missing: a null, after a complaint.
  JsonReader at(const std::string& key) const;
  JsonReader at(std::size_t index) const;

  double number(double least = -std::numeric_limits<double>::infinity(),
                double most = std::numeric_limits<double>::infinity()) const;
  double positive_number() const;
  bool boolean() const;
  std::string text() const;

 private:
  const Json& value_;
  std::string pointer_;
  std::optional<JsonProblem>& problem_;
};

// The document, or what is wrong with it in words: "not JSON: ...".
struct ParsedJson {
  JsonReader::Json value;
  std::string error;  // empty if there is none
};
ParsedJson parse_json(std::string_view text);

}  // namespace mirocup::record
