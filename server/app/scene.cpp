// SPDX-License-Identifier: MIT
//
// mirocup scene FILE: runs bodies, commands and parameters, and nothing of the game.
#include "server/app/commands.hpp"
#include "server/record/files.hpp"
#include "server/record/scene_json.hpp"

#include <ctime>
#include <iostream>
#include <memory>

namespace mirocup::app {

namespace {

struct Options {
  std::string path;
  std::string accuracy = "standard";
  std::string out;  // "": standard output
  bool json = false;
};

Result<int> run_scene(const Options& options) {
  record::Disk disk;
  const auto text = disk.read(options.path);
  if (!text) return tl::unexpected(text.error());
  const auto scene = record::parse_scene(*text, options.path);
  if (!scene) return tl::unexpected(scene.error());

  const auto accuracy = *from_string<simulator::Accuracy>(options.accuracy);
  const std::clock_t begin = std::clock();
  const auto result = simulator::run_scene(*scene, simulator::tolerances_of(accuracy));
  const double cpu_seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;

  const std::string json = record::to_json(*scene, result, cpu_seconds).dump() + "\n";
  if (options.out.empty()) {
    std::cout << json;
  } else if (auto written = disk.write(options.out, json); !written) {
    return tl::unexpected(written.error());
  }
  return exit_yes;
}

}  // namespace

void add_scene(CLI::App& app, Run& run) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("scene", "Run a scene of the physics alone");
  command->add_option("FILE", options->path, "a scene, mirocup/scene/1")->required();
  command->add_option("--accuracy", options->accuracy, "of lasting contacts")
      ->check(CLI::IsMember({"coarse", "standard", "reference"}));
  command->add_option("-o", options->out, "where the result goes (default: standard output)");
  command->add_flag("--json", options->json, "the result is JSON with and without it");
  command->callback([options, &run] { run = [options] { return run_scene(*options); }; });
}

}  // namespace mirocup::app
