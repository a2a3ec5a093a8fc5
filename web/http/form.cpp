// SPDX-License-Identifier: MIT
#include "web/http/form.hpp"

#include <algorithm>
#include <charconv>

namespace mirocup::web {

std::string decoded(std::string_view coded, bool plus_is_space) {
  std::string text;
  for (std::size_t i = 0; i < coded.size(); ++i) {
    unsigned code = 0;
    const char* const digits = coded.data() + i + 1;
    if (coded[i] == '%' && i + 2 < coded.size() &&
        std::from_chars(digits, digits + 2, code, 16).ptr == digits + 2) {
      text += static_cast<char>(code);
      i += 2;
    } else {
      text += coded[i] == '+' && plus_is_space ? ' ' : coded[i];
    }
  }
  return text;
}

void add_form_values(std::string_view form, Form& values) {
  while (!form.empty()) {
    const std::string_view part = form.substr(0, form.find('&'));
    form.remove_prefix(std::min(part.size() + 1, form.size()));
    const std::size_t equals = std::min(part.find('='), part.size());
    if (part.empty()) continue;
    values.emplace(decoded(part.substr(0, equals), true),
                   decoded(part.substr(std::min(equals + 1, part.size())), true));
  }
}

std::optional<Form> read_form(const Body& body) {
  constexpr std::size_t most = 4096;  // bytes
  std::string text;
  const bool is_whole = body([&text](std::string_view part) {
    text += part;
    return text.size() <= most;
  });
  if (!is_whole) return std::nullopt;
  Form form;
  add_form_values(text, form);
  return form;
}

std::string value_of(const Form& form, const std::string& key) {
  const auto found = form.lower_bound(key);  // find() may return any of several
  return found == form.end() || found->first != key ? "" : found->second;
}

}  // namespace mirocup::web
