// SPDX-License-Identifier: MIT
//
// The common parts of replay pages, live pages and the playground: script, style, policy, and the
// JSON that page/main.js reads.
#pragma once

#include "core/field/field.hpp"
#include "record/match_record.hpp"
#include "record/statistics/statistics.hpp"
#include "system/files.hpp"
#include "web/track_encoder.hpp"

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace mirocup::web {

using record::Json;

// The module (browser/) with which a visitor's browser simulates.
struct BrowserModule {
  std::string script;  // mirocup.js
  std::string wasm;    // mirocup.wasm
};

// Returns the module that the build or the installation has, or nothing if it was not built.
Result<std::optional<BrowserModule>> browser_module(system::Files& files);

// Returns the text of the file page/NAME; empty if the program lacks the file.
std::string_view asset(std::string_view name);

// Returns modules of page/ as one script, each module after the modules that it imports. The script
// has no import and export, because a page that is opened from disk cannot import. Precondition: no
// two modules use the same global name.
std::string page_script(std::span<const std::string_view> modules);

std::string page_style();

// The place of a page's module for simulation.
enum class ModulePlace { nowhere, in_the_page, beside_it };

// Returns the content security policy of a page with a script: the page loads nothing from
// elsewhere, and runs only the script and, in a worker, the module if the page has a module. With
// ModulePlace::beside_it, the page also runs script files of its own host. If `script` is empty,
// script and style are files beside the page.
std::string page_policy(const std::string& script, ModulePlace module);

// Returns a long text for the inside of a page, compressed by zlib and in base64, which has no
// characters of HTML's markup. A browser unpacks it with DecompressionStream('deflate'). The same
// text gives the same bytes.
std::string packed_text(std::string_view text);

// Returns JSON as text for a <script> element; no part of the text can close the element.
std::string embedded(const Json& json);

Json module_json(const BrowserModule& module);

// A script file beside pages, which gives them data.
struct ScriptFile {
  std::string name;
  std::string text;
};

// Returns the module as a file for all pages of a site. The file's name has a hash of its content.
ScriptFile module_file(const BrowserModule& module);

// Returns frames in the form that Track.load() of page/track.js reads: {frames, packed}.
Json track_json(const ColumnEncoder& frames);

Json zones_json(const field::Field& field);

// Returns the values of a scene that seldom change from tick to tick: {state, phase, left, score}.
Json moment_json(const match::Snapshot& scene);

// Returns the robots that count as keepers, blue's and yellow's; -1 if the team has no keeper.
Json keepers_json(const match::Snapshot& scene);

// Returns the leg's statistics in the form of `mirocup stats` (docs/statistics.md) but without the
// lists of goals and fouls, which pages take from the decisions: {play_s, …, teams: {blue,
// yellow}}.
Json statistics_json(const statistics::LegStatistics& leg);

// Returns the text of a server-sent event.
std::string event_text(const char* name, const Json& data);

}  // namespace mirocup::web
