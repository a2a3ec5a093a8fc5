// SPDX-License-Identifier: MIT
#include "server/record/json_reader.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace mirocup::record {

namespace {

// Longer values are cut in messages.
constexpr std::size_t max_quoted = 60;

const JsonReader::Json& null_value() {
  static const JsonReader::Json null;
  return null;
}

std::string short_number(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

// A key as a reference token of RFC 6901.
std::string reference_token(const std::string& key) {
  std::string text;
  for (const char c : key) {
    if (c == '~') {
      text += "~0";
    } else if (c == '/') {
      text += "~1";
    } else {
      text += c;
    }
  }
  return text;
}

std::string list_of(std::initializer_list<std::string_view> keys) {
  std::string text;
  for (const std::string_view key : keys) text += (text.empty() ? "" : ", ") + std::string(key);
  return text;
}

}  // namespace

void JsonReader::complain(const std::string& reason) const {
  if (!*problem_) *problem_ = JsonProblem{pointer_.empty() ? "/" : pointer_, reason};
}

void JsonReader::complain_of_range(const std::string& value, bool is_below,
                                   const std::string& limit) const {
  complain(value + " is not " + (is_below ? "at least " : "at most ") + limit);
}

std::string JsonReader::quoted() const {
  // Never dumped whole: they may be nested deeper than a recursive function can go.
  if (value_->is_object()) return "an object";
  if (value_->is_array()) return "an array";
  std::string text = value_->dump(-1, ' ', false, Json::error_handler_t::replace);
  if (text.size() <= max_quoted) return text;
  std::size_t size = max_quoted;
  const auto is_inside_character = [&] {
    return (static_cast<unsigned char>(text[size]) & 0xc0) == 0x80;
  };
  while (is_inside_character()) --size;
  return text.substr(0, size) + "…";
}

bool JsonReader::expect_object() const {
  if (value_->is_object()) return true;
  complain("an object is expected");
  return false;
}

bool JsonReader::expect_object(std::initializer_list<std::string_view> keys) const {
  if (!expect_object()) return false;
  for (const auto& [key, member] : value_->items()) {
    if (std::find(keys.begin(), keys.end(), key) != keys.end()) continue;
    at(key).complain("there is no such key; known are " + list_of(keys));
    return false;
  }
  return true;
}

bool JsonReader::expect_array(std::size_t min_size, std::size_t max_size) const {
  if (value_->is_array() && size() >= min_size && size() <= max_size) return true;
  if (!value_->is_array()) {
    complain("an array is expected");
  } else if (min_size == max_size) {
    complain(std::to_string(min_size) + " values are expected, not " + std::to_string(size()));
  } else {
    complain(std::to_string(min_size) + " to " + std::to_string(max_size) +
             " values are expected, not " + std::to_string(size()));
  }
  return false;
}

void JsonReader::expect_schema(std::string_view schema) const {
  const JsonReader found = at("schema");
  if (found.json() == schema) return;
  found.complain("\"" + std::string(schema) + "\" is expected, not " + found.quoted());
}

JsonReader JsonReader::at(const std::string& key) const {
  const std::string pointer = pointer_ + "/" + reference_token(key);
  if (has(key)) return {(*value_)[key], pointer, *problem_};
  JsonReader missing(null_value(), pointer, *problem_);
  missing.complain("missing");
  return missing;
}

JsonReader JsonReader::at(std::size_t index) const {
  const std::string pointer = pointer_ + "/" + std::to_string(index);
  if (index < size()) return {(*value_)[index], pointer, *problem_};
  JsonReader missing(null_value(), pointer, *problem_);
  missing.complain("missing");
  return missing;
}

std::optional<JsonReader> JsonReader::find(const std::string& key) const {
  if (!has(key) || (*value_)[key].is_null()) return std::nullopt;
  return at(key);
}

std::vector<JsonReader> JsonReader::elements(std::size_t min_size, std::size_t max_size) const {
  std::vector<JsonReader> list;
  if (!expect_array(min_size, max_size)) return list;
  for (std::size_t i = 0; i < size(); ++i) list.push_back(at(i));
  return list;
}

std::vector<std::pair<std::string, JsonReader>> JsonReader::members() const {
  std::vector<std::pair<std::string, JsonReader>> list;
  if (!expect_object()) return list;
  for (const auto& [key, member] : value_->items()) list.emplace_back(key, at(key));
  return list;
}

double JsonReader::number(double min, double max) const {
  if (!value_->is_number()) {
    complain("a number is expected, not " + quoted());
    return std::clamp(0.0, min, max);
  }
  const double number = value_->get<double>();
  if (!std::isfinite(number)) {
    complain("a finite number is expected");
    return std::clamp(0.0, min, max);
  }
  if (number < min) complain_of_range(short_number(number), true, short_number(min));
  if (number > max) complain_of_range(short_number(number), false, short_number(max));
  return std::clamp(number, min, max);
}

double JsonReader::positive_number() const {
  const double value = number();
  if (value > 0.0) return value;
  complain("a number above 0 is expected, not " + quoted());
  return 1.0;
}

std::optional<JsonReader::Whole> JsonReader::whole_number() const {
  if (value_->is_number_unsigned()) return value_->get<std::uint64_t>();
  if (value_->is_number_integer()) return value_->get<std::int64_t>();
  if (value_->is_number_float()) {
    constexpr double two_to_63 = 9223372036854775808.0;
    const double number = value_->get<double>();
    if (number == std::trunc(number) && std::abs(number) < two_to_63) {
      return static_cast<std::int64_t>(number);
    }
  }
  complain("a whole number is expected, not " + quoted());
  return std::nullopt;
}

bool JsonReader::boolean() const {
  if (value_->is_boolean()) return value_->get<bool>();
  complain("true or false is expected, not " + quoted());
  return false;
}

std::string JsonReader::text() const {
  if (value_->is_string()) return value_->get<std::string>();
  complain("a string is expected, not " + quoted());
  return {};
}

ParsedJson parse_json(std::string_view text) {
  try {
    return {JsonReader::Json::parse(text), {}};
  } catch (const nlohmann::json::exception& e) {
    // "[json.exception.parse_error.101] parse error at line 3, column 5: ..."
    const std::string what = e.what();
    const std::size_t bracket = what.find("] ");
    return {{}, "not JSON: " + (bracket == std::string::npos ? what : what.substr(bracket + 2))};
  }
}

Error error_of(const JsonProblem& problem, const std::string& path, Errc code) {
  return {code, path + ": " + problem.pointer + ": " + problem.reason};
}

}  // namespace mirocup::record
