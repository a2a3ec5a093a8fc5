// SPDX-License-Identifier: MIT
//
// mirocup record-as-seen: what a camera would have seen of a played match.
#include "core/base/math.hpp"
#include "labs/pitch/camera_log.hpp"
#include "labs/programs/commands.hpp"
#include "programs/mirocup/output_folder.hpp"
#include "record/match_record.hpp"
#include "system/files.hpp"

#include <cstdint>
#include <iostream>

namespace mirocup::labs {

namespace {

struct RecordAsSeenOptions {
  std::string record;
  std::string output;
  double noise_mm = 2.0;
  double noise_deg = 1.0;
  double gaps = 0.02;  // shares
  double outliers = 0.01;
  std::uint64_t seed = 1;
};

Result<int> run_record_as_seen(const RecordAsSeenOptions& options) {
  MIROCUP_TRY_VOID(app::expect_writable_output(options.output, {options.record}));
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

}  // namespace

void add_record_as_seen(system::Commands& commands) {
  const auto [command, o] =
      commands.add(run_record_as_seen, "record-as-seen", for_engineers,
                   "Write what a camera would have seen of a played match, as a recording",
                   {"mirocup record-as-seen leg.json -o seen.jsonl"});
  command.option("RECORD", o.record, "Match record, written by --record").required();
  command.option("-o FILE", o.output, "File to write the recording to (mirocup/recording/1)")
      .required();
  command.option("--noise-mm MM", o.noise_mm, "Standard deviation of a position, mm")
      .between(0.0, 100.0)
      .shows_default();
  command.option("--noise-deg DEGREES", o.noise_deg, "Standard deviation of a heading, degrees")
      .between(0.0, 90.0)
      .shows_default();
  command.option("--gaps SHARE", o.gaps, "Share of bodies that a picture misses")
      .between(0.0, 0.9)
      .shows_default();
  command.option("--outliers SHARE", o.outliers, "Share of bodies that are seen at a wrong place")
      .between(0.0, 0.5)
      .shows_default();
  command.option("--seed SEED", o.seed, "Seed of the noise").is_a_seed().shows_default();
}

}  // namespace mirocup::labs
