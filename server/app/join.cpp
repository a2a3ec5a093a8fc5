// SPDX-License-Identifier: MIT
//
// mirocup join: plays a library in a match on the network.
#include "plugins/host/convert.hpp"
#include "plugins/host/plugin.hpp"
#include "server/app/commands.hpp"
#include "server/app/interrupt.hpp"
#include "server/dds/team_client.hpp"

#include <iostream>
#include <memory>
#include <optional>

namespace mirocup::app {

namespace {

// Without a word from the server for so long (s), it is gone.
constexpr double longest_silence = 10.0;
constexpr double look_around = 0.5;

struct Options {
  std::string match_id;
  std::string team;
  std::string name;
  std::string library;
  std::string server = "127.0.0.1";
  double patience = 60.0;
};

Result<int> run_join(const Options& options) {
  Interrupt interrupt;
  const Team team = *from_string<Team>(options.team);
  auto client =
      dds::TeamClient::join(options.server, options.match_id, team, options.name, options.patience,
                            [&interrupt] { return interrupt.is_asked_for(); });
  if (!client) return tl::unexpected(client.error());

  mirocup_setup setup = plugins::to_setup((*client)->briefing());
  setup.log = plugins::write_line;
  const std::string path =
      options.library.find('/') == std::string::npos ? "./" + options.library : options.library;
  auto plugin = plugins::Plugin::load(path, setup);
  if (!plugin) return fail(Errc::input, options.library + ": " + plugin.error().text);
  std::cerr << "mirocup: " << options.name << " plays " << options.team << " in match "
            << options.match_id << '\n';

  // The server sends a state again if it missed the answer; the answer is not thought of twice.
  std::optional<std::uint32_t> answered;
  match::Command command;
  double silence = 0.0;
  while (true) {
    if (interrupt.is_asked_for()) return fail(Errc::interrupted, "interrupted");
    const dds::News news = (*client)->wait(look_around);
    if (const auto* over = std::get_if<dds::MatchOver>(&news)) {
      std::cout << "the match is over (" << over->how << "): blue " << over->score[0] << ", yellow "
                << over->score[1] << '\n';
      return exit_yes;
    }
    const auto* scene = std::get_if<match::Scene>(&news);
    if (scene == nullptr) {
      silence += look_around;
      if (silence < longest_silence) continue;
      return fail(Errc::unavailable, "the match server has not been heard of for 10 s");
    }
    silence = 0.0;
    if (answered && scene->tick < *answered) continue;
    if (answered != scene->tick) {
      const auto decided = plugin->decide(
          plugins::to_observation(match::observe(*scene, team, (*client)->robots())));
      if (!decided) return fail(Errc::input, options.library + ": " + decided.error().text);
      command = plugins::to_command(*decided);
      answered = scene->tick;
    }
    (*client)->send(command, scene->tick);
  }
}

}  // namespace

void add_join(CLI::App& app, Run& run) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("join", "Play a library in a match on the network");
  command->add_option("--match", options->match_id, "ID of the match")->required();
  command->add_option("--team", options->team, "the colour to play")
      ->required()
      ->check(CLI::IsMember({"blue", "yellow"}));
  command->add_option("--name", options->name, "the name that the match knows the team by")
      ->required();
  command->add_option("--server", options->server, "host that the match runs on")
      ->capture_default_str();
  command->add_option("--patience", options->patience, "seconds to wait for the match")
      ->capture_default_str();
  command->add_option("FILE.so", options->library, "the team's library")->required();
  command->callback([options, &run] { run = [options] { return run_join(*options); }; });
}

}  // namespace mirocup::app
