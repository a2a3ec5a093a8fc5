// SPDX-License-Identifier: MIT
#include "tournaments/handin/form.hpp"

#include "web/http/form.hpp"

namespace mirocup::league {

std::optional<Form> read_form(const web::Body& body) {
  constexpr std::size_t most = 4096;  // bytes
  std::string text;
  const bool is_whole = body([&text](std::string_view part) {
    text += part;
    return text.size() <= most;
  });
  if (!is_whole) return std::nullopt;
  Form form;
  web::add_form_values(text, form);
  return form;
}

std::string value_of(const Form& form, const std::string& key) {
  const auto found = form.lower_bound(key);  // find() may return any of several
  return found == form.end() || found->first != key ? "" : found->second;
}

}  // namespace mirocup::league
