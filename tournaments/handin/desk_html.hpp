// SPDX-License-Identifier: MIT
//
// The common parts of the desk's pages: the page around the content, and words for values.
#pragma once

#include "record/json_reader.hpp"

#include <string>

namespace mirocup::league {

using Json = nlohmann::ordered_json;
using record::text_in;

// Returns a page with this content, in the design of all pages. `root` is the way from the page's
// address to the top of the site: web::root_of(). It is "" at /hand-in.
std::string desk_page(const std::string& title, const std::string& content,
                      const std::string& root = "");

// Returns the number at a key of an object in a printf format; "" if the object has no such number.
std::string number_text(const Json& object, const char* key, const char* format);

}  // namespace mirocup::league
