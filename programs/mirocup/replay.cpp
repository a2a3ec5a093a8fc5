// SPDX-License-Identifier: MIT
//
// mirocup replay RECORD: writes a page that shows the leg, a picture of one moment, or a
// video of a part.
#include "programs/mirocup/clip.hpp"
#include "programs/mirocup/commands.hpp"
#include "record/clock_words.hpp"
#include "record/statistics/statistics_json.hpp"
#include "system/number_of.hpp"
#include "system/text.hpp"
#include "web/page.hpp"
#include "web/picture.hpp"

#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <spawn.h>
#include <unistd.h>
#include <variant>

namespace mirocup::app {

namespace {

struct ReplayOptions {
  std::string record;
  std::string output;
  std::optional<std::string> at;  // a moment: s since the match began, or "second half 0:10"
  bool svg = false;
  std::string clip;  // "12:18", seconds since the match began; "": none
  bool no_times = false;
  bool public_page = false;  // without what only the teams may see
  bool no_proof = false;     // without what a browser needs to simulate the leg again
  std::string proof_module;  // address of the module, seen from the page; "": it is in the page
  std::optional<std::string> page_files;  // address of the folder of web::page_files()
  std::string statistics;                 // file for the statistics of the leg; "": none
  std::string links;                      // HTML for the page, of a league
  std::vector<std::string> names;         // of the teams on the page; none: those of the record
  bool open = false;                      // in a browser
};

constexpr double trail_seconds = 1.0;

// A moment of a leg: seconds since it began, or its clock.
using LegMoment = std::variant<double, record::ClockTime>;

Result<LegMoment> moment_of(const std::string& text) {
  const auto seconds = system::number_of<double>(text);
  if (seconds && *seconds >= 0.0 && *seconds <= 1e6) return *seconds;
  if (const auto clock = record::clock_time_of(text)) return *clock;
  return fail(Errc::input, "--at " + system::in_quotes(text) +
                               ": seconds since the match began (0 to 1e6) are expected, or the "
                               "clock, as in \"second half 0:10\"");
}

bool is_before(const match::Leg& leg, const LegMoment& moment) {
  if (const double* seconds = std::get_if<double>(&moment))
    return leg.tick() * leg.setup().control_period < *seconds;
  const match::Snapshot now = leg.view();
  return record::ClockTime{now.phase, now.clock} < std::get<record::ClockTime>(moment);
}

tl::expected<std::string, replay::Divergence> picture_at(const replay::Recording& recording,
                                                         const LegMoment& asked) {
  replay::Playback playback(recording);
  const double period = recording.setup.control_period;
  std::vector<Vec2> balls;
  while (is_before(playback.leg(), asked)) {
    if (playback.leg().is_over()) {
      std::cerr << "mirocup: the leg is over after " << playback.leg().tick() * period
                << " s; the picture shows the last moment of the leg\n";
      break;
    }
    balls.push_back(playback.leg().snapshot().ball.position);
    if (!playback.advance()) break;
  }
  if (playback.divergence()) return tl::unexpected(*playback.divergence());
  const auto trail = std::min(balls.size(), static_cast<std::size_t>(trail_seconds / period));
  web::Moment moment{playback.leg().snapshot(),
                     {balls.end() - static_cast<std::ptrdiff_t>(trail), balls.end()}};
  return web::picture(playback.leg().field(), recording.setup.parameters, moment);
}

// A page is written as .html and a picture as .svg, so that programs open them as what they are.
Result<std::string> output_of(const ReplayOptions& options) {
  const std::string ending = options.svg ? ".svg" : ".html";
  if (options.output.empty())
    return std::filesystem::path(options.record).replace_extension(ending).string();
  const std::string given = std::filesystem::path(options.output).extension();
  if (given == ending || (!options.svg && given == ".htm")) return options.output;
  // Something that is no file of its own, such as /dev/stdout, has no ending.
  if (given.empty()) return options.output;
  return fail(Errc::input, options.output + ": " + (options.svg ? "a picture" : "a page") +
                               " is written as " + ending);
}

Result<int> run_clip(const ReplayOptions& options) {
  MIROCUP_TRY(const auto span, parse_clip(options.clip));
  const std::string output =
      options.output.empty()
          ? std::filesystem::path(options.record).replace_extension(".webm").string()
          : options.output;
  if (!is_video_name(output))
    return fail(Errc::input, output + ": a video ends in .webm, .mp4 or .gif");
  system::Disk disk;
  MIROCUP_TRY(const auto record, record::load(disk, options.record));
  MIROCUP_TRY_VOID(write_clip(disk, record, span, output));
  std::cout << system::printable(output) << '\n';
  return exit_yes;
}

// Starts the desktop's program for the file and does not wait for it. Returns false if there is no
// desktop.
bool open_in_browser(const std::string& path) {
  if (std::getenv("DISPLAY") == nullptr && std::getenv("WAYLAND_DISPLAY") == nullptr) return false;
  std::string program = "xdg-open";
  std::string file = std::filesystem::absolute(path).string();
  char* const arguments[] = {program.data(), file.data(), nullptr};
  posix_spawn_file_actions_t silence;
  posix_spawn_file_actions_init(&silence);
  for (const int descriptor : {0, 1, 2})
    posix_spawn_file_actions_addopen(&silence, descriptor, "/dev/null", O_RDWR, 0);
  pid_t pid = 0;
  const int failed = posix_spawnp(&pid, program.c_str(), &silence, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&silence);
  return failed == 0;
}

// The script file with the commands, beside a page whose module is a file, too.
std::string commands_file_of(const std::string& page) {
  return std::filesystem::path(page).replace_extension(".proof.js").string();
}

// The proof that the page is to have, if any.
Result<std::optional<web::Proof>> proof_of(system::Files& files, const ReplayOptions& options,
                                           const std::string& output) {
  if (options.svg || options.no_proof) return std::nullopt;
  if (!options.proof_module.empty()) {
    const std::filesystem::path beside = commands_file_of(output);
    return web::Proof{.module_file = options.proof_module, .commands_file = beside.filename()};
  }
  if (options.public_page) return std::nullopt;
  MIROCUP_TRY(auto module, web::browser_module(files));
  return web::Proof{.module = std::move(module)};
}

// Says on standard error what a proof needs or takes.
void tell_of_proof(const web::ReplayPage& page, std::size_t beside) {
  if (beside > 0) {
    std::cerr << "mirocup: the page has " << page.html.size() / 1000
              << " kB; a browser can simulate its leg again with a file of " << beside / 1000
              << " kB beside the page\n";
  } else if (page.proof_size > 0) {
    std::cerr << "mirocup: the page has " << page.html.size() / 1000 << " kB; "
              << page.proof_size / 1000
              << " kB of them let a browser simulate the leg again (--no-proof leaves them out)\n";
  } else {
    std::cerr << "mirocup: a browser cannot simulate the leg of this page again, because this "
                 "mirocup was built without the module for browsers; docs/browser.md says what to "
                 "install\n";
  }
}

Result<int> run_replay(const ReplayOptions& options) {
  if (!options.clip.empty()) return run_clip(options);
  MIROCUP_TRY(const auto output, output_of(options));
  if (options.svg != options.at.has_value())
    return fail(Errc::input,
                "--at T and --svg need each other: they make a still picture of the moment T");
  if (options.svg && !options.statistics.empty()) {
    return fail(Errc::input, "--statistics belongs to a page, not to a picture of a moment");
  }
  MIROCUP_TRY(const auto moment, moment_of(options.at.value_or("0")));
  system::Disk disk;
  MIROCUP_TRY(const auto record, record::load(disk, options.record));
  const bool shows_own = !options.svg && !options.public_page;
  MIROCUP_TRY(
      const auto own,
      record::read_own_texts(disk, options.record, shows_own ? record::of_both : record::of_nobody,
                             system::Links::followed));
  const web::Times times = options.no_times ? web::Times::left_out : web::Times::shown;
  MIROCUP_TRY(const auto proof, proof_of(disk, options, output));
  record::MatchRecord named = record;
  for (std::size_t i = 0; i < options.names.size(); ++i) named.teams[i].name = options.names[i];
  web::ReplayPage shown;
  const auto made = options.svg
                        ? picture_at(record.recording, moment)
                        : web::replay_page(named, times, own, proof,
                                           shows_own ? web::Wheels::shown : web::Wheels::left_out,
                                           options.links, options.page_files)
                              .map([&shown](web::ReplayPage page) {
                                shown = std::move(page);
                                return shown.html;
                              });
  if (!made) return not_reproduced(options.record, record, made.error(), "shown");
  MIROCUP_TRY_VOID(disk.write(output, *made));
  std::string beside;
  if (proof && !proof->commands_file.empty()) {
    beside = web::commands_script(record);
    MIROCUP_TRY_VOID(disk.write(commands_file_of(output), beside));
  }
  const bool has_proof = shown.proof_size > 0 || !beside.empty();
  if (proof && (has_proof || !options.open)) tell_of_proof(shown, beside.size());
  if (!options.statistics.empty()) {
    // The name alone, so that the file has the same bytes wherever the record is.
    const std::string name = std::filesystem::path(options.record).filename();
    const std::string text =
        statistics::leg_report_text(statistics::report_of(name, record, shown.statistics));
    MIROCUP_TRY_VOID(disk.write(options.statistics, text));
  }
  std::cout << system::printable(output) << '\n';
  if (options.open && !open_in_browser(output))
    std::cerr << "mirocup: no browser can be opened from here: open the file in one\n";
  return exit_yes;
}

}  // namespace

void add_replay(system::Commands& commands) {
  const auto [command, o] = commands.add(
      run_replay, "replay", after_a_leg,
      "Make a page that shows a record in a browser, a picture of one moment, or a video",
      {"mirocup replay leg.json --open", "mirocup replay leg.json --clip 12:18 -o goal.gif",
       "mirocup replay leg.json --at 12.5 --svg -o moment.svg"});
  command.option("RECORD", o.record, "Match record").required();
  command.option("-o,--output FILE", o.output,
                 "File to write to (default: beside the record, with the ending .html, .svg or "
                 ".webm)");
  const system::Option at =
      command.option("--at MOMENT", o.at,
                     "Moment of the picture: seconds since the match began, or the clock that "
                     "pages and digests show, as in \"second half 0:10\"");
  const system::Option svg =
      command.flag("--svg", o.svg, "Draw a still picture of the moment --at");
  command
      .option("--clip FROM:TO", o.clip,
              "FROM:TO in seconds since the match began: a video (.webm, .mp4 or .gif)")
      .excludes(at)
      .excludes(svg);
  command.flag("--open", o.open, "Open the page in a browser");
  command.flag("--no-times", o.no_times,
               "Leave out times that a clock measured, so that the page is the same on "
               "every machine");
  command.flag(
      "--public", o.public_page,
      "Leave out the data that only the teams may see: their thoughts and logs, and the commands "
      "with which a browser can simulate the leg again");
  command.option("--links", o.links).hidden();
  command.option("--page-files", o.page_files).hidden();
  command.option("--names", o.names).takes(2, 2).hidden();
  command.flag("--no-proof", o.no_proof,
               "Leave out the module and the commands with which a visitor's browser can simulate "
               "the leg again");
  command.option("--proof-module ADDRESS", o.proof_module,
                 "Address, relative to the page, of a script file with the browser module of this "
                 "mirocup; the commands of the leg then go into a second script file, beside the "
                 "page, even with --public");
  command.option("--statistics FILE", o.statistics,
                 "File to write the statistics of the leg to, as JSON");
}

}  // namespace mirocup::app
