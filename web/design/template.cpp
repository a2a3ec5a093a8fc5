// SPDX-License-Identifier: MIT
#include "web/design/template.hpp"

#include "system/text.hpp"

#include <cstdio>
#include <cstdlib>
#include <kainjow/mustache.hpp>

namespace mirocup::web {

namespace {

using Json = nlohmann::ordered_json;
using kainjow::mustache::data;
using kainjow::mustache::mustache;

// In Mustache an empty text counts as a value; here it does not.
data data_of(const Json& value) {
  if (value.is_object()) {
    data object(data::type::object);
    for (const auto& [key, member] : value.items()) object.set(key, data_of(member));
    return object;
  }
  if (value.is_array()) {
    data list(data::type::list);
    for (const Json& element : value) list.push_back(data_of(element));
    return list;
  }
  if (value == true) return data(true);
  if (const auto* text = value.get_ptr<const std::string*>(); text && !text->empty())
    return data(*text);
  if (value.is_number()) return data(value.dump());
  return data(false);
}

// The template with the texts of all others in place of {{>name}}.
std::string with_includes(TemplateFiles files, std::string_view text) {
  std::string whole;
  while (true) {
    const std::size_t open = text.find("{{>");
    if (open == std::string_view::npos) return whole.append(text);
    const std::size_t close = text.find("}}", open);
    whole += text.substr(0, open);
    whole += with_includes(files, files(text.substr(open + 3, close - open - 3)));
    text.remove_prefix(close + 2);
  }
}

}  // namespace

std::string filled(TemplateFiles files, std::string_view name, const Json& values) {
  mustache page(with_includes(files, files(name)));
  page.set_custom_escape([](const std::string& text) { return system::html_escaped(text); });
  std::string text = page.is_valid() ? page.render(data_of(values)) : "";
  if (page.is_valid()) return text;
  std::fprintf(stderr, "mirocup: the template %.*s: %s\n", static_cast<int>(name.size()),
               name.data(), page.error_message().c_str());
  std::abort();
}

}  // namespace mirocup::web
