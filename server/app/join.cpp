// SPDX-License-Identifier: MIT
//
// mirocup join: plays a library in a match on the network.
#include "mirocup/team.hpp"
#include "plugins/host/plugin.hpp"
#include "server/app/commands.hpp"
#include "server/app/interrupt.hpp"

#include <chrono>
#include <iostream>
#include <optional>

namespace mirocup::app {

namespace {

using SteadyClock = std::chrono::steady_clock;

// Without a word from the server for so long (s), it is gone.
constexpr double max_silence = 10.0;
constexpr double poll_interval = 0.25;

// A library at the end of a connection.
class RemoteTeam {
 public:
  RemoteTeam(const JoinOptions& options, Interrupt& interrupt, team::Connection& match)
      : options_(options), interrupt_(interrupt), match_(match) {}

  // Until the match is over.
  Result<int> play();

 private:
  Result<void> take_seat();
  Result<void> answer();
  Result<void> check_silence() const;
  int report() const;

  const JoinOptions& options_;
  Interrupt& interrupt_;
  team::Connection& match_;
  std::optional<plugins::Plugin> plugin_;
  SteadyClock::time_point heard_ = SteadyClock::now();
};

Result<int> RemoteTeam::play() {
  while (!interrupt_.is_asked_for()) {
    const int news = match_.wait(poll_interval);
    Result<void> done;
    switch (news) {
      case MIROCUP_TEAM_SEATED:
        done = take_seat();
        break;
      case MIROCUP_TEAM_TICK:
        done = answer();
        break;
      case MIROCUP_TEAM_OVER:
        return report();
      case MIROCUP_TEAM_REFUSED:
        return fail(Errc::unavailable, "the match server refuses the team: " + match_.text());
      default:
        done = check_silence();
    }
    if (!done) return tl::unexpected(done.error());
    if (news != MIROCUP_TEAM_NOTHING) heard_ = SteadyClock::now();
  }
  return fail(Errc::interrupted, "interrupted");
}

// Of a leg that is new to the team: it begins from nothing, as it would in a process of its own.
Result<void> RemoteTeam::take_seat() {
  plugin_.reset();
  const std::string path =
      options_.library.find('/') == std::string::npos ? "./" + options_.library : options_.library;
  auto plugin = plugins::Plugin::load(path, match_.setup());
  if (!plugin) return fail(Errc::input, options_.library + ": " + plugin.error().text);
  plugin_.emplace(std::move(*plugin));
  std::cerr << "mirocup: " << options_.name << " plays " << options_.team << " in match "
            << options_.match_id << '\n';
  return {};
}

Result<void> RemoteTeam::answer() {
  const mirocup_observation& now = match_.observation();
  if (now.placing != 0) {
    const auto placement = plugin_->place(now);
    if (!placement) return fail(Errc::input, options_.library + ": " + placement.error().text);
    match_.place(*placement);
  }
  const auto decided = plugin_->decide(now);
  if (!decided) return fail(Errc::input, options_.library + ": " + decided.error().text);
  match_.send(*decided);
  return {};
}

Result<void> RemoteTeam::check_silence() const {
  const double silence = std::chrono::duration<double>(SteadyClock::now() - heard_).count();
  if (!plugin_ && silence > options_.join_within) {
    return fail(
        Errc::unavailable,
        match_.text() + ", for " + std::to_string(static_cast<int>(options_.join_within)) + " s");
  }
  if (plugin_ && silence > max_silence) {
    return fail(Errc::unavailable, "the match server has not been heard of for 10 s");
  }
  return {};
}

int RemoteTeam::report() const {
  std::cout << "the match is over (" << match_.text() << "): blue " << match_.score()[0]
            << ", yellow " << match_.score()[1] << '\n';
  return exit_yes;
}

}  // namespace

Result<int> run_join(const JoinOptions& options) {
  Interrupt interrupt;
  team::Connection match({.match = options.match_id,
                          .team = index_of(*from_string<Team>(options.team)),
                          .name = options.name,
                          .server = options.server,
                          .credentials = options.credentials});
  if (!match.is_open()) return fail(Errc::unavailable, match.why());
  return RemoteTeam(options, interrupt, match).play();
}

}  // namespace mirocup::app
