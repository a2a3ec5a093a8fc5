// SPDX-License-Identifier: MIT
//
// mirocup identify: the numbers of a pitch from recordings.
#include "labs/pitch/identify.hpp"

#include "labs/pitch/page.hpp"
#include "labs/pitch/report.hpp"
#include "labs/programs/commands.hpp"
#include "programs/mirocup/output_folder.hpp"
#include "record/json_reader.hpp"
#include "record/pitch_json.hpp"
#include "system/files.hpp"

#include <filesystem>
#include <iostream>

namespace mirocup::labs {

namespace {

struct IdentifyOptions {
  std::vector<std::string> recordings;
  std::string pitch = "mirosot";  // from which the search begins
  std::string output;
  std::string page;  // "": none
  bool json = false;
};

Result<void> write_page(const std::string& path, const std::string& page) {
  if (path.empty()) return {};
  system::Disk disk;
  return disk.write(path, page);
}

Result<int> run_identify(const IdentifyOptions& options) {
  for (const std::string& path : {options.output, options.page}) {
    MIROCUP_TRY_VOID(app::expect_writable_output(path, options.recordings));
  }
  MIROCUP_TRY(const auto start, record::pitch_of_option(options.pitch));
  MIROCUP_TRY(const auto recordings, pitch::read_recordings(options.recordings));
  MIROCUP_TRY(const auto found, pitch::identify(recordings, {start.parameters, 0.0}));
  const std::string name = std::filesystem::path(options.output).stem().string();
  const auto json = pitch::pitch_json(found, start, name);
  system::Disk disk;
  MIROCUP_TRY_VOID(disk.write(options.output, record::json_text(json, 1) + "\n"));
  MIROCUP_TRY_VOID(write_page(options.page, pitch::page_of(found, "The pitch " + name)));
  std::cout << (options.json ? record::json_text(json) + "\n" : pitch::text_of_result(found));
  return exit_yes;
}

}  // namespace

void add_identify(system::Commands& commands) {
  const auto [command, o] =
      commands.add(run_identify, "identify", for_engineers,
                   "Find the numbers of a pitch from recordings: floor, walls, motors, camera",
                   {"mirocup identify seen.jsonl -o ours.json --page ours.html"});
  command
      .option("RECORDING", o.recordings, "Recordings (mirocup/recording/1, or .csv) of one pitch")
      .required();
  command.option("-o FILE", o.output, "File to write the pitch to (mirocup/pitch/1)").required();
  command
      .option("--pitch NAME|FILE", o.pitch,
              "Pitch with the known numbers: sizes, masses, and others that recordings do not tell")
      .shows_default();
  command.option("--page FILE", o.page,
                 "File to write a page to, with the found numbers and their 95 % intervals");
  command.flag("--json", o.json, "Print the pitch as one JSON object");
}

}  // namespace mirocup::labs
