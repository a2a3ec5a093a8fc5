// SPDX-License-Identifier: MIT
//
// mirocup record-as-seen, identify and validate: recordings of a pitch, the numbers of the pitch,
// and how far the simulator is from it.
#include "server/pitch/identify.hpp"

#include "core/base/math.hpp"
#include "server/app/commands.hpp"
#include "server/pitch/as_seen.hpp"
#include "server/pitch/page.hpp"
#include "server/pitch/result_json.hpp"
#include "server/record/json_reader.hpp"
#include "server/record/match_record.hpp"
#include "server/record/pitch_json.hpp"
#include "system/files.hpp"

#include <filesystem>
#include <iostream>

namespace mirocup::app {

namespace {

Result<std::vector<pitch::Recording>> read_recordings(const std::vector<std::string>& paths) {
  std::vector<pitch::Recording> recordings;
  for (const std::string& path : paths) {
    auto recording = pitch::read_recording(path);
    if (!recording) return tl::unexpected(recording.error());
    recordings.push_back(std::move(*recording));
  }
  return recordings;
}

Result<void> write_page(const std::string& path, const std::string& page) {
  if (path.empty()) return {};
  system::Disk disk;
  return disk.write(path, page);
}

}  // namespace

Result<int> run_record_as_seen(const RecordAsSeenOptions& options) {
  system::Disk disk;
  const auto record = record::load(disk, options.record);
  if (!record) return tl::unexpected(record.error());
  auto recording = pitch::as_seen(record->recording, options.record);
  if (!recording) return tl::unexpected(recording.error());
  pitch::look_through({.position = 1e-3 * options.noise_mm,
                       .heading = options.noise_deg * pi / 180.0,
                       .gaps = options.gaps,
                       .outliers = options.outliers,
                       .seed = options.seed},
                      *recording);
  if (auto written = disk.write(options.output, pitch::print_recording(*recording)); !written) {
    return tl::unexpected(written.error());
  }
  std::cout << options.output << ": " << recording->frames.size() << " pictures\n";
  return exit_yes;
}

Result<int> run_identify(const IdentifyOptions& options) {
  const auto start = record::pitch_of_option(options.pitch);
  if (!start) return tl::unexpected(start.error());
  const auto recordings = read_recordings(options.recordings);
  if (!recordings) return tl::unexpected(recordings.error());
  const auto found = pitch::identify(*recordings, {start->parameters, 0.0});
  if (!found) return tl::unexpected(found.error());
  const std::string name = std::filesystem::path(options.output).stem().string();
  const auto json = pitch::pitch_json(*found, *start, name);
  system::Disk disk;
  if (auto written = disk.write(options.output, record::json_text(json, 1) + "\n"); !written) {
    return tl::unexpected(written.error());
  }
  if (auto written = write_page(options.page, pitch::page_of(*found, "The pitch " + name));
      !written)
    return tl::unexpected(written.error());
  std::cout << (options.json ? record::json_text(json) + "\n" : pitch::text_of_result(*found));
  return exit_yes;
}

Result<int> run_validate(const ValidateOptions& options) {
  const auto spec = record::pitch_of_option(options.pitch);
  if (!spec) return tl::unexpected(spec.error());
  const auto recordings = read_recordings(options.recordings);
  if (!recordings) return tl::unexpected(recordings.error());
  const auto result = pitch::validate(*recordings, {spec->parameters, spec->command_delay});
  const std::string title = "The simulator with the pitch " + spec->name + " against recordings";
  if (auto written = write_page(options.page, pitch::page_of(result, title)); !written)
    return tl::unexpected(written.error());
  std::cout << (options.json ? record::json_text(pitch::to_json(result)) + "\n"
                             : pitch::text_of_result(result));
  return result.objections.empty() ? exit_yes : exit_no;
}

}  // namespace mirocup::app
