// SPDX-License-Identifier: MIT
//
// The design that all pages share, and templates of pages: HTML files that the build compiles into
// the program, in the language of Mustache (mustache.github.io).
#pragma once

#include <nlohmann/json.hpp>

#include <string>
#include <string_view>

namespace mirocup::web {

// Returns the text of the file design/NAME; empty if the program lacks the file. "design.css" is
// the style sheet of all pages; a page may add its own style sheet.
std::string_view design_file(std::string_view name);

// Finds the text of an included template by its name.
using TemplateFiles = std::string_view (*)(std::string_view name);

// Returns the template filled with values. In a template,
//   {{key}}                 is the value as text, in which nothing is markup (system::html_escaped)
//   {{{key}}}               is the value as markup, for pictures that the program draws
//   {{#key}}…{{/key}}       stands for each element of a list, or once if there is a value
//   {{^key}}…{{/key}}       stands if there is no value: null, false, "", an empty list
//   {{>name}}               is the text of another template, taken from `files`
// Templates are part of the program: a template with a mistake ends the program with a message that
// names template and mistake. `name` is the name of the template in `files`.
std::string filled(TemplateFiles files, std::string_view name,
                   const nlohmann::ordered_json& values);

}  // namespace mirocup::web
