// SPDX-License-Identifier: MIT
#include "record/json_reader.hpp"

#include "system/printable.hpp"
#include "system/text.hpp"

#include <algorithm>
#include <cmath>

namespace mirocup::record {

namespace {

// Longer values, keys, pointers and reasons are cut in messages.
constexpr std::size_t max_quoted = 60;
constexpr std::size_t max_key = 60;
constexpr std::size_t max_pointer = 300;
constexpr std::size_t max_reason = 600;

const JsonReader::Json& null_value() {
  static const JsonReader::Json null;
  return null;
}

// The beginning of a text of at most `size` bytes, with whole characters.
std::string cut(const std::string& text, std::size_t size) {
  if (text.size() <= size) return text;
  const auto is_inside_character = [&] {
    return (static_cast<unsigned char>(text[size]) & 0xc0) == 0x80;
  };
  while (size > 0 && is_inside_character()) --size;
  return text.substr(0, size) + "…";
}

// A key as a reference token of RFC 6901.
std::string reference_token(const std::string& key) {
  // Almost all keys are our own; readers of long files ask for millions of them.
  const auto is_plain = [](char c) { return (c >= 'a' && c <= 'z') || c == '_'; };
  if (key.size() <= max_key && std::all_of(key.begin(), key.end(), is_plain)) return key;
  const std::string text = system::printable(cut(key, max_key));
  return system::replaced(system::replaced(text, "~", "~0"), "/", "~1");
}

}  // namespace

void JsonReader::complain(const std::string& reason) const {
  if (*problem_) return;
  *problem_ = JsonProblem{pointer_.empty() ? "/" : cut(pointer_, max_pointer),
                          system::printable(cut(reason, max_reason))};
}

void JsonReader::complain_of_range(const std::string& value, bool is_below,
                                   const std::string& limit) const {
  complain(value + " is not " + (is_below ? "at least " : "at most ") + limit);
}

std::string JsonReader::quoted() const {
  // Never dumped whole: they may be nested deeper than a recursive function can go.
  if (value_->is_object()) return "an object";
  if (value_->is_array()) return "an array";
  return cut(json_text(*value_), max_quoted);
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
    at(key).complain("there is no such key; known are " + system::joined(keys, ", "));
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
  const double nearest = std::clamp(number, min, max);
  if (nearest != number) {
    complain_of_range(system::formatted("%g", number), number < min,
                      system::formatted("%g", nearest));
  }
  return nearest;
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

namespace {

// Builds the tree of a document within its limits, value by value as the library's parser finds
// them, and stops at the first problem. One pass: counting before building would take another, and
// the library's own builder with a filter takes longer and does not see a key that is there twice.
class TreeBuilder final : public nlohmann::json_sax<JsonReader::Json> {
 public:
  using Json = JsonReader::Json;

  TreeBuilder(std::string_view text, const JsonLimits& limits) : text_(text), limits_(limits) {}

  ParsedJson take() && {
    if (problem_) return {{}, std::move(problem_)};
    return {std::move(root_), {}, values_};
  }

  bool null() override { return add(Json()); }
  bool boolean(bool value) override { return add(Json(value)); }
  bool number_integer(number_integer_t value) override { return add(Json(value)); }
  bool number_unsigned(number_unsigned_t value) override { return add(Json(value)); }
  bool number_float(number_float_t value, const string_t& digits) override {
    if (digits.size() > limits_.number)
      return refuse("a number has at most " + std::to_string(limits_.number) + " characters, not " +
                    std::to_string(digits.size()));
    return add(Json(value));
  }
  bool string(string_t& value) override {
    return is_good_text(value) && add(Json(std::move(value)));
  }
  bool binary(binary_t&) override { return refuse("binary data is not JSON"); }
  bool start_object(std::size_t) override { return open(Json::object()); }
  bool end_object() override { return close(); }
  bool start_array(std::size_t) override { return open(Json::array()); }
  bool end_array() override { return close(); }

  bool key(string_t& name) override {
    auto& object = levels_.back()->get_ref<Json::object_t&>();
    key_ = &name;
    if (!is_good_text(name)) return false;
    if (object.find(name) != object.end()) return refuse("the key is there twice");
    if (object.size() >= limits_.members) {
      return refuse("an object has at most " + std::to_string(limits_.members) + " keys");
    }
    key_ = nullptr;
    object.emplace_back(std::move(name), Json());
    return true;
  }

  bool parse_error(std::size_t position, const std::string&,
                   const nlohmann::detail::exception& problem) override {
    constexpr int number_overflow = 406;  // the library's number for it
    const bool is_cut_off = position > text_.size();
    const std::string_view read = text_.substr(0, is_cut_off ? text_.size() : position);
    const auto lines = std::count(read.begin(), read.end(), '\n');
    const std::size_t last_line = read.rfind('\n');
    const std::size_t column =
        read.size() - (last_line == std::string_view::npos ? 0 : last_line + 1);
    const std::string where =
        "line " + std::to_string(lines + 1) + ", column " + std::to_string(column);
    levels_.clear();  // the whole text is at fault
    return refuse(problem.id == number_overflow ? where + ": the number is too large"
                  : is_cut_off                  ? "not JSON: it ends too early, in " + where
                                                : "not JSON: wrong at " + where);
  }

 private:
  // Adds a value where the document has one, and returns its place; null after a problem.
  Json* place(Json value) {
    if (++values_ > limits_.values) {
      refuse("a document has at most " + std::to_string(limits_.values) + " values");
      return nullptr;
    }
    if (levels_.empty()) {
      root_ = std::move(value);
      return &root_;
    }
    Json& container = *levels_.back();
    if (container.is_array()) {
      container.push_back(std::move(value));
      return &container.back();
    }
    Json& member = container.get_ref<Json::object_t&>().back().second;
    member = std::move(value);
    return &member;
  }

  bool add(Json value) { return place(std::move(value)) != nullptr; }

  bool open(Json container) {
    if (levels_.size() >= limits_.depth)
      return refuse("lists and objects may be nested at most " + std::to_string(limits_.depth) +
                    " deep");
    Json* const opened = place(std::move(container));
    if (opened == nullptr) return false;
    levels_.push_back(opened);
    return true;
  }

  bool close() {
    levels_.pop_back();
    return true;
  }

  bool is_good_text(const std::string& text) {
    if (text.size() > limits_.text)
      return refuse("a text has at most " + std::to_string(limits_.text) + " bytes, not " +
                    std::to_string(text.size()));
    if (text.find('\0') != std::string::npos) {
      return refuse("a text may not have the character U+0000");
    }
    return true;
  }

  // Notes the problem at the present place. Returns false, which ends the parser.
  bool refuse(std::string reason) {
    std::string pointer;
    for (const Json* level : levels_) {
      const bool is_last = level == levels_.back();
      if (level->is_array()) {
        // The last list does not have the value at fault yet.
        pointer += "/" + std::to_string(is_last ? level->size() : level->size() - 1);
      } else if (is_last && key_ != nullptr) {
        pointer += "/" + reference_token(*key_);
      } else if (!level->empty()) {
        pointer += "/" + reference_token(level->get_ref<const Json::object_t&>().back().first);
      }
    }
    problem_ = JsonProblem{pointer.empty() ? "/" : cut(pointer, max_pointer), std::move(reason)};
    return false;
  }

  std::string_view text_;
  const JsonLimits& limits_;
  Json root_;
  std::vector<Json*> levels_;         // the lists and objects that are open
  const std::string* key_ = nullptr;  // of a member that was not added
  std::size_t values_ = 0;
  std::optional<JsonProblem> problem_;
};

}  // namespace

ParsedJson parse_json(std::string_view text, const JsonLimits& limits) {
  if (text.size() > limits.bytes) {
    return {{},
            JsonProblem{"/", "it has " + std::to_string(text.size()) + " bytes; at most " +
                                 std::to_string(limits.bytes) + " are read"}};
  }
  TreeBuilder builder(text, limits);
  (void)JsonReader::Json::sax_parse(text, &builder);
  return std::move(builder).take();
}

std::string json_text(const JsonReader::Json& value, int indent) {
  return value.dump(indent, ' ', false, JsonReader::Json::error_handler_t::replace);
}

std::string text_in(const JsonReader::Json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : "";
}

Error error_of(const JsonProblem& problem, const std::string& path, Errc code) {
  return {code, path + ": " + problem.pointer + ": " + problem.reason};
}

Result<JsonReader::Json> with_changes(JsonReader::Json object,
                                      const std::vector<std::string>& changes,
                                      const std::string& option) {
  for (const std::string& change : changes) {
    const std::size_t equals = change.find('=');
    const std::string text = equals == std::string::npos ? "" : change.substr(equals + 1);
    ParsedJson value = parse_json(text);
    if (value.problem) return fail(Errc::input, option + " " + change + ": KEY=VALUE is expected");
    object[change.substr(0, equals)] = std::move(value.value);
  }
  return object;
}

}  // namespace mirocup::record
