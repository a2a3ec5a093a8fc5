// SPDX-License-Identifier: MIT
//
// mirocup scene FILE: simulates bodies and wheel commands, without teams and laws.
#include "programs/mirocup/commands.hpp"
#include "record/scene_json.hpp"

namespace mirocup::app {

namespace {

struct SceneOptions {
  std::string path;
  std::string accuracy = "standard";
  std::string out;  // "": standard output
  bool json = false;
};

Result<int> run_scene(const SceneOptions& options) {
  system::Disk disk;
  MIROCUP_TRY(const auto text, disk.read_named(options.path, system::size_limit::scene));
  MIROCUP_TRY(const auto scene, record::parse_scene(text, options.path));

  const auto accuracy = *from_string<simulator::Accuracy>(options.accuracy);
  const std::clock_t begin = std::clock();
  const auto result = simulator::run_scene(scene, simulator::tolerances_of(accuracy));
  if (result.stopped_at)
    return fail(Errc::input, options.path + ": more than " +
                                 std::to_string(simulator::max_scene_impacts) + " impacts until " +
                                 std::to_string(*result.stopped_at) +
                                 " s: choose a shorter duration");
  const double cpu_seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;

  const std::string json = record::json_text(record::to_json(scene, result, cpu_seconds)) + "\n";
  if (options.out.empty()) {
    std::cout << json;
  } else {
    MIROCUP_TRY_VOID(disk.write(options.out, json));
  }
  return exit_yes;
}

}  // namespace

void add_scene(system::Commands& commands) {
  const auto [command, o] =
      commands.add(run_scene, "scene", for_engineers,
                   "Simulate a scene: bodies and wheel commands, without teams and laws",
                   {"mirocup scene scene.json --accuracy reference -o result.json"});
  command.option("FILE", o.path, "Scene, a file of schema mirocup/scene/1").required();
  command.option("--accuracy", o.accuracy, "Accuracy of lasting contacts (default: standard)")
      .one_of({"coarse", "standard", "reference"});
  command.option("-o,--output FILE", o.out,
                 "File to write the result to (default: standard output)");
  command.flag("--json", o.json, "Accepted for uniformity: the result is always JSON");
}

}  // namespace mirocup::app
