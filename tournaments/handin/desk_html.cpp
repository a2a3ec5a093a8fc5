// SPDX-License-Identifier: MIT
#include "tournaments/handin/desk_html.hpp"

#include "record/json_fields.hpp"
#include "system/text.hpp"
#include "tournaments/publish/page_values.hpp"

namespace mirocup::league {

std::string desk_page(const std::string& title, const std::string& content,
                      const std::string& root) {
  return filled_page("plain.html", {{"root", root},
                                    {"league", "League"},
                                    {"page_title", title},
                                    {"heading", title},
                                    {"content", content}});
}

std::string number_text(const Json& object, const char* key, const char* format) {
  const auto number = record::value_in<std::optional<double>>(object, key);
  if (!number) return "";
  const std::string text = system::formatted(format, *number);
  const bool is_minus_zero =
      text.starts_with('-') && text.find_first_of("123456789") == std::string::npos;
  return is_minus_zero ? text.substr(1) : text;
}

}  // namespace mirocup::league
