// SPDX-License-Identifier: MIT
//
// mirocup compile SOURCE -o FILE.so: compiles a team's source, or the archive of its project, as a
// league does, in a sandbox.
#include "plugins/host/compile.hpp"

#include "programs/mirocup/commands.hpp"
#include "record/json_reader.hpp"
#include "system/files.hpp"
#include "system/locations.hpp"
#include "system/printable.hpp"

#include <nlohmann/json.hpp>

#include <iostream>

namespace mirocup::app {

namespace {

constexpr std::uint64_t max_source = 4u << 20;  // bytes of one file

plugins::SourceLanguage language_of(const CompileOptions& options) {
  using plugins::SourceLanguage;
  if (options.language == "c") return SourceLanguage::c;
  if (options.language == "c++") return SourceLanguage::cpp;
  if (options.language == "project") return SourceLanguage::project;
  for (const char* end : {".tar", ".tar.gz", ".tgz", ".zip"}) {
    if (options.path.ends_with(end)) return SourceLanguage::project;
  }
  return options.path.ends_with(".c") ? SourceLanguage::c : SourceLanguage::cpp;
}

}  // namespace

Result<int> run_compile(const CompileOptions& options) {
  system::Disk disk;
  const plugins::SourceLanguage language = language_of(options);
  const bool is_project = language == plugins::SourceLanguage::project;
  MIROCUP_TRY(
      const auto source,
      disk.read(options.path, {.max_size = is_project ? system::size_limit::entry : max_source}));
  const system::TeamKit kit = system::team_kit();
  MIROCUP_TRY(const auto done,
              plugins::compile_in_sandbox(
                  source, language,
                  {.headers = kit.headers,
                   .predict = kit.prefix + "/lib/libmirocup_predict.a",
                   .project_compiler = system::sibling_program("mirocup-project-compiler")},
                  {.seconds = options.seconds}));
  const bool is_compiled = done.why_not.empty();
  if (is_compiled) {
    MIROCUP_TRY_VOID(disk.write(options.output, done.library));
  }
  const std::string said = system::printable(done.output, system::LineEnds::kept);
  if (options.json) {
    using record::JsonReader;
    std::cout << record::json_text(
                     {{"compiled", is_compiled},
                      {"reason", is_compiled ? JsonReader::Json() : JsonReader::Json(done.why_not)},
                      {"log", said}})
              << '\n';
  } else {
    std::cout << said;
    if (!is_compiled) std::cout << system::printable(options.path) << ": " << done.why_not << '\n';
  }
  return is_compiled ? exit_yes : exit_no;
}

}  // namespace mirocup::app
