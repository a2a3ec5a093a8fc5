// SPDX-License-Identifier: MIT
//
// What the pages of the desk have in common: the page around them, and words for values.
#pragma once

#include "tournaments/publish/html.hpp"

#include <nlohmann/json.hpp>

#include <string>

namespace mirocup::league {

using Json = nlohmann::ordered_json;

// The page around the content, in the design of all pages. `back` is true below the team's page.
std::string desk_page(const std::string& title, const Html& content);

// The button that ends the session, which stands in the corner of the first card.
void log_out_button(Html& html);

// Ends a card and begins the next, with a heading.
void next_card(Html& html, const std::string& heading);

// A text of an object; "" if there is none of that name.
std::string text_in(const Json& object, const char* key);

// A number of an object in a printf format; "" if there is none of that name.
std::string number_text(const Json& object, const char* key, const char* format);

}  // namespace mirocup::league
