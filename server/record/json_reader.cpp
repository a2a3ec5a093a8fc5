// SPDX-License-Identifier: MIT
#include "server/record/json_reader.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace mirocup::record {

namespace {

const JsonReader::Json& null_value() {
  static const JsonReader::Json null;
  return null;
}

std::string short_number(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

// What RFC 6901 wants of a key inside a pointer.
std::string escaped(const std::string& key) {
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

}  // namespace

void JsonReader::complain(const std::string& reason) const {
  if (!problem_) problem_ = JsonProblem{pointer_.empty() ? "/" : pointer_, reason};
}

bool JsonReader::expect_object(std::initializer_list<std::string_view> keys) const {
  if (!value_.is_object()) {
    complain("an object is expected");
    return false;
  }
  for (auto item = value_.begin(); item != value_.end(); ++item) {
    if (std::find(keys.begin(), keys.end(), item.key()) != keys.end()) continue;
    JsonReader(*item, pointer_ + "/" + escaped(item.key()), problem_).complain("unknown key");
    return false;
  }
  return true;
}

bool JsonReader::expect_array(std::size_t least, std::size_t most) const {
  if (value_.is_array() && value_.size() >= least && value_.size() <= most) return true;
  if (!value_.is_array()) {
    complain("an array is expected");
  } else if (least == most) {
    complain(std::to_string(least) + " values are expected, not " + std::to_string(value_.size()));
  } else {
    complain(std::to_string(least) + " to " + std::to_string(most) + " values are expected, not " +
             std::to_string(value_.size()));
  }
  return false;
}

JsonReader JsonReader::at(const std::string& key) const {
  const std::string pointer = pointer_ + "/" + escaped(key);
  if (has(key)) return {value_[key], pointer, problem_};
  JsonReader missing(null_value(), pointer, problem_);
  missing.complain("missing");
  return missing;
}

JsonReader JsonReader::at(std::size_t index) const {
  const std::string pointer = pointer_ + "/" + std::to_string(index);
  if (index < size()) return {value_[index], pointer, problem_};
  JsonReader missing(null_value(), pointer, problem_);
  missing.complain("missing");
  return missing;
}

double JsonReader::number(double least, double most) const {
  if (!value_.is_number()) {
    complain("a number is expected");
    return 0.0;
  }
  const double number = value_.get<double>();
  if (!std::isfinite(number)) {
    complain("a finite number is expected");
    return 0.0;
  }
  if (number < least || number > most) {
    complain(
        short_number(number) + " is not " +
        (number < least ? "at least " + short_number(least) : "at most " + short_number(most)));
  }
  return number;
}

double JsonReader::positive_number() const {
  const double value = number();
  if (value > 0.0) return value;
  complain("a number above 0 is expected");
  return 1.0;
}

bool JsonReader::boolean() const {
  if (value_.is_boolean()) return value_.get<bool>();
  complain("true or false is expected");
  return false;
}

std::string JsonReader::text() const {
  if (value_.is_string()) return value_.get<std::string>();
  complain("a string is expected");
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

}  // namespace mirocup::record
