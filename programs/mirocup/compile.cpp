// SPDX-License-Identifier: MIT
//
// mirocup compile SOURCE -o FILE.so: compiles a team's source, or the archive of its project, as a
// league does, in a sandbox.
#include "plugins/host/compile.hpp"

#include "plugins/host/elf.hpp"
#include "programs/mirocup/commands.hpp"
#include "system/locations.hpp"

#include <sstream>

namespace mirocup::app {

namespace {

struct CompileOptions {
  std::string path;
  std::string output;
  std::string language;   // "c", "c++", "project"; "": by the name of the file
  double seconds = 60.0;  // of processor time
  bool json = false;
  std::string answer;  // file for the answer
};

constexpr std::uint64_t max_source = 4u << 20;  // bytes of one file

plugins::SourceLanguage language_of(const CompileOptions& options) {
  using plugins::SourceLanguage;
  if (options.language == "c") return SourceLanguage::c;
  if (options.language == "c++") return SourceLanguage::cpp;
  if (options.language == "project") return SourceLanguage::project;
  const std::string path = system::lower_case(options.path);
  for (const char* end : {".tar", ".tar.gz", ".tgz", ".zip"}) {
    if (path.ends_with(end)) return SourceLanguage::project;
  }
  return path.ends_with(".c") ? SourceLanguage::c : SourceLanguage::cpp;
}

// True if a line of the source has a pragma or an attribute `target` or `target_clones`.
bool chooses_processor(const std::string& source) {
  std::istringstream lines(source);
  for (std::string line; std::getline(lines, line);) {
    const std::string code = line.substr(0, line.find("//"));
    const std::size_t at = code.find("target");
    if (at == std::string::npos || code.find('"', at) == std::string::npos) continue;
    for (const char* word : {"pragma", "Pragma", "attribute", "gnu::"}) {
      if (code.find(word) < at) return true;
    }
  }
  return false;
}

Result<int> run_compile(const CompileOptions& options, const record::WriteAnswer& answer) {
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
  if (is_compiled) MIROCUP_TRY_VOID(disk.write(options.output, done.library));
  std::string said = system::printable(done.output, system::LineEnds::kept);
  const system::Processor needs = plugins::processor_for(done.library);
  if (needs > system::Processor::v1 || (!is_project && chooses_processor(source))) {
    said += "warning: a pragma or an attribute \"target\" lets the compiler use instructions of " +
            std::string(needs > system::Processor::v1 ? to_string(needs) : "newer processors") +
            ", which end the team on a computer that lacks them: remove it\n";
  }
  const record::Json json{
      {"compiled", is_compiled}, {"reason", record::or_null(done.why_not)}, {"log", said}};
  MIROCUP_TRY_VOID(answer(json));
  if (options.json) {
    print_json(json);
  } else {
    std::cout << said;
    if (!is_compiled) std::cout << system::printable(options.path) << ": " << done.why_not << '\n';
  }
  return is_compiled ? exit_yes : exit_no;
}

}  // namespace

void add_compile(system::Commands& commands) {
  const auto [command, o] =
      commands.add(answering<run_compile, CompileOptions>, "compile", for_teams,
                   "Compile a team's source as a league does: in a sandbox and with fixed options",
                   {"mirocup compile mine.cpp -o mine.so"});
  command
      .option("SOURCE", o.path,
              "One file of C++20, or of C17 if its name ends in .c, or an archive of a project "
              "(.tar.gz, .tar, .zip)")
      .required();
  command.option("-o,--output FILE.so", o.output, "Library to write").required();
  command.option("--language", o.language, "Language of the source, if its name does not tell it")
      .one_of({"c", "c++", "project"});
  command
      .option("--seconds", o.seconds,
              "Seconds of processor time for all compilers together (default: 60)")
      .between(1.0, 600.0);
  command.flag("--json", o.json, "Print the answer as one JSON object");
  add_answer(command, o.answer);
}

}  // namespace mirocup::app
