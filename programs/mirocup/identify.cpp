// SPDX-License-Identifier: MIT
//
// mirocup record-as-seen, identify and validate: recordings of a pitch, the numbers of the pitch,
// and how far the simulator is from it.
#include "pitch/identify.hpp"

#include "core/base/math.hpp"
#include "pitch/as_seen.hpp"
#include "pitch/page.hpp"
#include "pitch/result_json.hpp"
#include "pitch/validation_report.hpp"
#include "programs/mirocup/commands.hpp"
#include "programs/mirocup/output_folder.hpp"
#include "record/json_reader.hpp"
#include "record/match_record.hpp"
#include "record/pitch_json.hpp"
#include "system/files.hpp"

#include <filesystem>
#include <iostream>

namespace mirocup::app {

namespace {

Result<void> write_page(const std::string& path, const std::string& page) {
  if (path.empty()) return {};
  system::Disk disk;
  return disk.write(path, page);
}

// A minute of computing should not end with a file that cannot be written, nor with one that takes
// the place of what it was computed from.
Result<void> check_output(const std::string& path, const std::vector<std::string>& inputs) {
  namespace fs = std::filesystem;
  if (path.empty()) return {};
  std::error_code none;
  for (const std::string& input : inputs) {
    if (fs::weakly_canonical(fs::absolute(input), none) ==
        fs::weakly_canonical(fs::absolute(path), none))
      return fail(Errc::input, path + " is read: it cannot be written, too");
  }
  if (fs::is_directory(path, none)) return fail(Errc::input, path + " is a folder");
  return expect_writable_folder_of(path);
}

}  // namespace

Result<int> run_record_as_seen(const RecordAsSeenOptions& options) {
  MIROCUP_TRY_VOID(check_output(options.output, {options.record}));
  system::Disk disk;
  MIROCUP_TRY(const auto record, record::load(disk, options.record));
  MIROCUP_TRY(auto recording, pitch::as_seen(record.recording, options.record));
  pitch::look_through({.position = 1e-3 * options.noise_mm,
                       .heading = options.noise_deg * pi / 180.0,
                       .gaps = options.gaps,
                       .outliers = options.outliers,
                       .seed = options.seed},
                      recording);
  MIROCUP_TRY_VOID(disk.write(options.output, pitch::print_recording(recording)));
  std::cout << options.output << ": " << recording.frames.size() << " pictures\n";
  return exit_yes;
}

Result<int> run_identify(const IdentifyOptions& options) {
  for (const std::string& path : {options.output, options.page}) {
    MIROCUP_TRY_VOID(check_output(path, options.recordings));
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

// Only mirocup-bench is linked to other engines.
Result<int> validate_against_peer(const ValidateOptions& options) {
  std::vector<std::string> words{"mirocup-bench", "validate", "--against",
                                 options.against, "--pitch",  options.pitch};
  if (!options.page.empty()) words.insert(words.end(), {"-o", options.page});
  if (options.json) words.push_back("--json");
  words.push_back("--");
  words.insert(words.end(), options.recordings.begin(), options.recordings.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  return become_sibling_program(words[0], static_cast<int>(argv.size()), argv.data(), 1);
}

Result<int> run_validate(const ValidateOptions& options) {
  if (!options.against.empty()) return validate_against_peer(options);
  MIROCUP_TRY(
      const auto report,
      pitch::report_of({options.recordings, options.pitch, options.page, options.json}, nullptr));
  std::cout << report.text;
  return report.is_worse ? exit_no : exit_yes;
}

}  // namespace mirocup::app
