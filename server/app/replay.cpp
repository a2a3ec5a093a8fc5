// SPDX-License-Identifier: MIT
//
// mirocup replay RECORD: writes a page that shows the leg, a picture of one moment, or a
// video of a part.
#include "server/app/clip.hpp"
#include "server/app/commands.hpp"
#include "server/statistics/statistics_json.hpp"
#include "server/web/page.hpp"
#include "server/web/picture.hpp"
#include "system/printable.hpp"

#include <filesystem>
#include <iostream>
#include <optional>

namespace mirocup::app {

namespace {

constexpr double trail_seconds = 1.0;

tl::expected<std::string, replay::Divergence> picture_at(const replay::Recording& recording,
                                                         double time) {
  replay::Playback playback(recording);
  const double period = recording.setup.control_period;
  std::vector<Vec2> balls;
  while (playback.leg().tick() * period < time) {
    balls.push_back(playback.leg().snapshot().ball.position);
    if (!playback.advance()) break;
  }
  if (playback.divergence()) return tl::unexpected(*playback.divergence());
  const auto trail = std::min(balls.size(), static_cast<std::size_t>(trail_seconds / period));
  web::Moment moment{playback.leg().snapshot(),
                     {balls.end() - static_cast<std::ptrdiff_t>(trail), balls.end()}};
  return web::picture(playback.leg().field(), recording.setup.parameters, moment);
}

Result<int> run_clip(const ReplayOptions& options) {
  const auto span = parse_clip(options.clip);
  if (!span) return tl::unexpected(span.error());
  if (!is_video_name(options.output))
    return fail(Errc::input, options.output + ": a video ends in .webm, .mp4 or .gif");
  system::Disk disk;
  const auto record = record::load(disk, options.record);
  if (!record) return tl::unexpected(record.error());
  if (auto written = write_clip(disk, *record, *span, options.output); !written)
    return tl::unexpected(written.error());
  std::cout << system::printable(options.output) << '\n';
  return exit_yes;
}

}  // namespace

Result<int> run_replay(const ReplayOptions& options) {
  if (!options.clip.empty()) return run_clip(options);
  if (options.svg != options.at.has_value()) {
    return fail(Errc::input, "--at T and --svg belong together: a still picture of a moment");
  }
  if (options.svg && !options.statistics.empty()) {
    return fail(Errc::input, "--statistics belongs to a page, not to a picture of a moment");
  }
  system::Disk disk;
  const auto record = record::load(disk, options.record);
  if (!record) return tl::unexpected(record.error());
  const web::Times times = options.no_times ? web::Times::left_out : web::Times::shown;
  std::optional<statistics::LegStatistics> counted;
  const auto made = options.svg ? picture_at(record->recording, *options.at)
                                : web::replay_page(*record, times).map([&](web::ReplayPage page) {
                                    counted = std::move(page.statistics);
                                    return std::move(page.html);
                                  });
  if (!made && record::has_other_behaviour(*record)) {
    return tl::unexpected(record::behaviour_mismatch(options.record, *record, made.error().tick));
  }
  if (!made) {
    std::cerr << "mirocup: " << system::printable(options.record)
              << ": cannot be shown, it differs from tick " << made.error().tick
              << " on: " << made.error().what << '\n';
    return exit_no;
  }
  if (auto written = disk.write(options.output, *made); !written) {
    return tl::unexpected(written.error());
  }
  if (!options.statistics.empty()) {
    // The name alone, so that the file has the same bytes wherever the record is.
    const std::string name = std::filesystem::path(options.record).filename();
    const std::string text =
        statistics::leg_report_text(statistics::report_of(name, *record, *std::move(counted)));
    if (auto written = disk.write(options.statistics, text); !written) {
      return tl::unexpected(written.error());
    }
  }
  std::cout << system::printable(options.output) << '\n';
  return exit_yes;
}

}  // namespace mirocup::app
