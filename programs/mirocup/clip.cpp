// SPDX-License-Identifier: MIT
#include "programs/mirocup/clip.hpp"

#include "core/replay/playback.hpp"
#include "system/child_process.hpp"
#include "system/number_of.hpp"
#include "system/text.hpp"
#include "web/picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <unistd.h>

namespace mirocup::app {

namespace {

namespace fs = std::filesystem;

constexpr double clip_trail_s = 1.0;
constexpr const char* video_scale = "scale=960:-2";  // px; codecs want an even height

// Removes the folder of the pictures at the end, whatever happens.
struct PictureFolder {
  std::string path;
  PictureFolder(const PictureFolder&) = delete;
  PictureFolder& operator=(const PictureFolder&) = delete;
  explicit PictureFolder(std::string where) : path(std::move(where)) {}
  ~PictureFolder() {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }
};

// Returns the number of pictures that were drawn.
Result<int> draw_pictures(system::Files& files, const replay::Recording& recording,
                          const ClipSpan& span, const std::string& folder) {
  replay::Playback playback(recording);
  const double period = recording.setup.control_period;
  std::vector<Vec2> balls;
  int pictures = 0;
  while (true) {
    const match::Snapshot scene = playback.leg().snapshot();
    const double now = playback.leg().tick() * period;
    if (now > span.to) break;
    if (now >= span.from) {
      const auto trail = std::min(balls.size(), static_cast<std::size_t>(clip_trail_s / period));
      const web::Moment moment{scene,
                               {balls.end() - static_cast<std::ptrdiff_t>(trail), balls.end()}};
      const std::string svg =
          web::picture(playback.leg().field(), recording.setup.parameters, moment);
      MIROCUP_TRY_VOID(files.write(folder + system::formatted("/%05d.svg", pictures), svg));
      ++pictures;
    }
    balls.push_back(scene.ball.position);
    if (!playback.advance()) break;
  }
  if (playback.divergence())
    return fail(Errc::damaged, "the record differs from tick " +
                                   std::to_string(playback.divergence()->tick) +
                                   " on: " + playback.divergence()->what);
  if (pictures == 0)
    return fail(Errc::input,
                "--clip: the leg ends before " + system::formatted("%.4f", span.from) + " s");
  return pictures;
}

std::vector<std::string> ffmpeg_command(const std::string& folder, double period,
                                        const std::string& output) {
  std::vector<std::string> command{"ffmpeg", "-nostdin", "-loglevel", "error", "-y"};
  // As a fraction, which files keep exactly.
  const std::string rate = "1000000/" + std::to_string(std::llround(1e6 * period));
  command.insert(command.end(), {"-framerate", rate, "-i", folder + "/%05d.svg"});
  if (output.ends_with(".gif")) {
    command.insert(command.end(),
                   {"-vf", "fps=25,scale=640:-2,split[a][b];[a]palettegen[p];[b][p]paletteuse"});
  } else if (output.ends_with(".mp4")) {
    command.insert(command.end(),
                   {"-vf", video_scale, "-pix_fmt", "yuv420p", "-movflags", "+faststart"});
  } else {
    command.insert(command.end(),
                   {"-vf", video_scale, "-c:v", "libvpx-vp9", "-b:v", "0", "-crf", "34"});
  }
  command.push_back("file:" + output);
  return command;
}

}  // namespace

Result<ClipSpan> parse_clip(const std::string& text) {
  const std::size_t colon = text.find(':');
  const std::string_view all(text);
  const ClipSpan span{.from = system::number_of<double>(all.substr(0, colon)).value_or(-1.0),
                      .to = system::number_of<double>(all.substr(colon + 1)).value_or(-1.0)};
  if (colon == std::string::npos || span.from < 0.0 || span.to < 0.0)
    return fail(
        Errc::input,
        "--clip " + text + ": two times in seconds are expected, as 12:18.5 for 12 s to 18.5 s");
  if (span.to <= span.from)
    return fail(Errc::input, "--clip " + text + ": it ends before it begins");
  if (span.to - span.from > max_clip_s)
    return fail(Errc::input, "--clip " + text + ": a clip has at most 60 s");
  return span;
}

bool is_video_name(const std::string& path) {
  constexpr std::array<std::string_view, 3> endings{".webm", ".mp4", ".gif"};
  return std::any_of(endings.begin(), endings.end(),
                     [&path](std::string_view ending) { return path.ends_with(ending); });
}

Result<void> write_clip(system::Files& files, const record::MatchRecord& record,
                        const ClipSpan& span, const std::string& output) {
  const PictureFolder folder(output + ".pictures-" + std::to_string(getpid()));
  MIROCUP_TRY_VOID(files.make_folder(folder.path, system::Readers::owner));
  MIROCUP_TRY_VOID(draw_pictures(files, record.recording, span, folder.path));
  MIROCUP_TRY(
      const auto answer,
      system::ask(ffmpeg_command(folder.path, record.recording.setup.control_period, output),
                  {.seconds = 3600.0, .bytes = std::uint64_t{1} << 30}));
  if (answer.code == system::not_found)
    return fail(Errc::unavailable, "--clip needs ffmpeg: apt-get install ffmpeg");
  if (answer.code != 0)
    return fail(Errc::unavailable, "ffmpeg could not write " + output + ": exit code " +
                                       std::to_string(answer.code) + " " +
                                       system::last_line(answer.output));
  return {};
}

}  // namespace mirocup::app
