// SPDX-License-Identifier: MIT
#include "record/csv_rows.hpp"

#include "record/json_reader.hpp"
#include "system/csv.hpp"

namespace mirocup::record {

namespace {

using Json = nlohmann::ordered_json;

std::string cell_of(const Json& value) {
  if (value.is_null()) return "";
  if (const auto* text = value.get_ptr<const std::string*>()) return *text;
  if (const bool* is = value.get_ptr<const bool*>()) return *is ? "yes" : "no";
  if (!value.is_array()) return json_text(value);
  std::string text;
  for (const Json& element : value) text += (text.empty() ? "" : " ") + cell_of(element);
  return text;
}

}  // namespace

std::string csv_of(const Json& rows, const std::vector<std::string>& columns) {
  std::vector<std::string> titles;
  std::vector<Json::json_pointer> paths;
  for (const std::string& column : columns) {
    const std::size_t equals = column.find('=');
    titles.push_back(column.substr(0, equals));
    paths.emplace_back("/" + column.substr(equals == std::string::npos ? 0 : equals + 1));
  }
  std::string text = system::csv_line(titles);
  for (const Json& row : rows) {
    std::vector<std::string> cells;
    for (const auto& path : paths) cells.push_back(row.contains(path) ? cell_of(row.at(path)) : "");
    text += system::csv_line(cells);
  }
  return text;
}

}  // namespace mirocup::record
