// SPDX-License-Identifier: MIT
//
// The common parts of replay pages, live pages and the playground: script, style, policy and data.
#pragma once

#include "core/field/field.hpp"
#include "record/match_record.hpp"
#include "system/files.hpp"

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace mirocup::web {

// The module (browser/) with which a visitor's browser simulates.
struct BrowserModule {
  std::string script;  // mirocup.js
  std::string wasm;    // mirocup.wasm
};

// Returns the module that the build or the installation has, or nothing if it was not built.
Result<std::optional<BrowserModule>> browser_module(system::Files& files);

// Returns modules of page/ as one script, each module after the modules that it imports. The script
// has no import and export, because a page that is opened from disk cannot import. Precondition: no
// two modules use the same global name.
std::string page_script(std::span<const std::string_view> modules);

std::string page_style();

// The place of a page's module for simulation.
enum class ModulePlace { nowhere, in_the_page, beside_it };

// Returns the content security policy of a page with a script: the page loads nothing from
// elsewhere, and runs only the script and, in a worker, the module if the page has a module. With
// ModulePlace::beside_it, the page also runs script files of its own host.
std::string page_policy(const std::string& script, ModulePlace module);

// Returns JSON as text for a <script> element; no part of the text can close the element.
std::string embedded(const record::Json& json);

record::Json module_json(const BrowserModule& module);

// A script file beside pages, which gives them data.
struct ScriptFile {
  std::string name;
  std::string text;
};

// Returns the module as a file for all pages of a site. The file's name has a hash of its content.
ScriptFile module_file(const BrowserModule& module);
record::Json zones_json(const field::Field& field);

}  // namespace mirocup::web
