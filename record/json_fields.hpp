// SPDX-License-Identifier: MIT
//
// The keys of a struct, listed once for its reader and its writer:
//
//   void list_fields(auto& f, Try& one) {
//     f("at", one.at, 0, max_time);
//     f("user", one.user);  // an optional; null if it is empty
//     f("accepted", one.is_accepted);
//     f.if_set("note", one.note);
//   }
//
// With this list, fields_json(one) makes the object, and read_fields<Try>(json) reads it like
// JsonReader: it never throws, and reports the first problem. A value is a number, a bool, a text,
// an enum with names, a point [x, y], a list of robots, a struct with list_fields, or an optional,
// a vector or a ByTeam of these ({"blue", "yellow"}). Numbers after a value are its least and
// greatest value, or the least and greatest size of a vector. list_fields must be in the namespace
// of its struct or in mirocup::record, not in an unnamed namespace.
#pragma once

#include "core/match/snapshot.hpp"
#include "record/json_reader.hpp"

#include <type_traits>

namespace mirocup::record {

template <class T>
struct IsOptional : std::false_type {};
template <class T>
struct IsOptional<std::optional<T>> : std::true_type {};
template <class T>
struct IsVector : std::false_type {};
template <class T>
struct IsVector<std::vector<T>> : std::true_type {};
template <class T>
struct IsByTeam : std::false_type {};
template <class T>
struct IsByTeam<match::ByTeam<T>> : std::true_type {};

template <class T>
JsonReader::Json fields_json(const T& value);

class FieldWriter {
 public:
  using Json = JsonReader::Json;

  void operator()(const char* key, const auto& value, auto...) {
    object_[key] = fields_json(value);
  }
  // A key that a file may lack.
  void optional(const char* key, const auto& value, auto...) { object_[key] = fields_json(value); }
  // A key that is not written if the value equals `plain`.
  template <class T>
  void unless(const T& plain, const char* key, const T& value, auto...) {
    if (!(value == plain)) object_[key] = fields_json(value);
  }
  template <class T>
  void if_set(const char* key, const T& value) {
    unless(T{}, key, value);
  }
  // A value that `write` and `read` convert.
  void as(const char* key, auto write, auto) { object_[key] = write(); }
  void as_if_set(bool is_set, const char* key, auto write, auto) {
    if (is_set) object_[key] = write();
  }
  // The keys of a struct among those of the object; a file without `key` has none of them.
  void merged(const char*, const auto& part) {
    if (part) object_.update(fields_json(*part));
  }
  // A key for people, which is written and not read, because its value follows from other keys.
  void only_written(const char* key, Json value) { object_[key] = std::move(value); }

  const Json& object() const { return object_; }

 private:
  Json object_ = Json::object();
};

class FieldReader {
 public:
  explicit FieldReader(const JsonReader& json) : json_(json) {}

  void operator()(const char* key, auto& value, auto... limits) {
    read(json_.at(key), value, limits...);
  }
  void optional(const char* key, auto& value, auto... limits) {
    if (json_.has(key)) read(json_.at(key), value, limits...);
  }
  template <class T>
  void unless(const T&, const char* key, T& value, auto... limits) {
    optional(key, value, limits...);
  }
  void if_set(const char* key, auto& value) { optional(key, value); }
  void as(const char* key, auto, auto read) { read(json_.at(key)); }
  void as_if_set(bool, const char* key, auto, auto read) {
    if (json_.has(key)) read(json_.at(key));
  }
  void merged(const char* key, auto& part) {
    if (json_.has(key)) read(json_, part.emplace());
  }
  void only_written(const char*, const JsonReader::Json&) {}

  template <class T, class... Limits>
  static void read(const JsonReader& json, T& value, Limits... limits) {
    if constexpr (IsOptional<T>::value) {
      value.reset();
      if (!json.is_null()) read(json, value.emplace(), limits...);
    } else if constexpr (IsVector<T>::value) {
      for (const JsonReader& element : json.elements(static_cast<std::size_t>(limits)...))
        read(element, value.emplace_back());
    } else if constexpr (IsByTeam<T>::value) {
      for (const Team team : both_teams)
        read(json.at(std::string(to_string(team))), value[index_of(team)], limits...);
    } else if constexpr (std::is_same_v<T, referee::RobotSet>) {
      for (const JsonReader& robot : json.elements())
        value.set(robot.integer<std::size_t>(0, value.size() - 1));
    } else if constexpr (std::is_same_v<T, Vec2>) {
      value = {json.at(0).number(), json.at(1).number()};
    } else if constexpr (std::is_floating_point_v<T>) {
      value = json.number(limits...);
    } else if constexpr (std::is_integral_v<T> && !std::is_same_v<T, bool>) {
      value = json.integer<T>(static_cast<T>(limits)...);
    } else if constexpr (std::is_scalar_v<T> || std::is_same_v<T, std::string>) {
      value = json.as<T>();
    } else {
      FieldReader fields(json);
      list_fields(fields, value);
    }
  }

 private:
  JsonReader json_;
};

template <class T>
JsonReader::Json fields_json(const T& value) {
  if constexpr (IsOptional<T>::value) {
    return value ? fields_json(*value) : JsonReader::Json();
  } else if constexpr (IsVector<T>::value) {
    auto list = JsonReader::Json::array();
    for (const auto& element : value) list.push_back(fields_json(element));
    return list;
  } else if constexpr (IsByTeam<T>::value) {
    return {{"blue", fields_json(value[0])}, {"yellow", fields_json(value[1])}};
  } else if constexpr (std::is_same_v<T, referee::RobotSet>) {
    auto list = JsonReader::Json::array();
    for (std::size_t i = 0; i < value.size(); ++i)
      if (value[i]) list.push_back(i);
    return list;
  } else if constexpr (std::is_same_v<T, Vec2>) {
    return JsonReader::Json::array({value.x(), value.y()});
  } else if constexpr (std::is_enum_v<T>) {
    return to_string(value);
  } else if constexpr (std::is_arithmetic_v<T> || std::is_same_v<T, std::string>) {
    return value;
  } else {
    FieldWriter fields;
    T copy = value;  // list_fields takes a reference, because readers change the value
    list_fields(fields, copy);
    return fields.object();
  }
}

template <class T>
T read_fields(const JsonReader& json) {
  T value{};
  FieldReader::read(json, value);
  return value;
}

// Returns the value at a key of an object; `otherwise` if the object has no such value.
template <class T>
T value_in(const JsonReader::Json& object, const char* key, T otherwise = {}) {
  std::optional<JsonProblem> problem;
  const JsonReader json(object, "", problem);
  T value = otherwise;
  if (json.has(key)) FieldReader::read(json.at(key), value);
  return problem ? otherwise : value;
}

}  // namespace mirocup::record
