// SPDX-License-Identifier: MIT
//
// mirocup: one match, its records, its teams. One file per subcommand.
#include "programs/mirocup/commands.hpp"
#include "record/match_record.hpp"
#include "server/dds/domain.hpp"
#include "system/child_process.hpp"
#include "system/locations.hpp"
#include "system/run_program.hpp"

#include <algorithm>

namespace mirocup::app {

void add_dds_domain(const system::Command& command, int& domain) {
  command
      .option("--dds-domain NUMBER", domain,
              "DDS domain of the match; each domain has its own ports")
      .between(dds::default_domain, dds::last_domain)
      .shows_default();
}

void add_parameters(const system::Command& command, const char* option,
                    std::vector<std::string>& changes, const std::string& whose) {
  command.option(option + std::string(" KEY=VALUE"), changes,
                 "Set a parameter of " + whose +
                     ", a number that the strategy asks for by name; may be given several times");
}

void add_answer(const system::Command& command, std::string& path) {
  command.option("--answer", path).hidden();
}

Result<int> not_reproduced(const std::string& path, const record::MatchRecord& record,
                           const replay::Divergence& found, const char* undone) {
  if (record::has_other_behaviour(record))
    return tl::unexpected(record::behaviour_mismatch(path, record, found.tick));
  std::cerr << "mirocup: " << system::printable(path) << ": cannot be " << undone
            << ", it differs from tick " << found.tick << " on: " << system::printable(found.what)
            << '\n';
  return exit_no;
}

Error become_labs(std::vector<std::string> arguments) {
  Error error =
      system::become_sibling_program("mirocup-labs", std::move(arguments), "-D MIROCUP_LABS=ON");
  error.what += "; an installation has it in the package mirocup-labs";
  return error;
}

// A command that mirocup-labs runs, with its help.
struct LabsCommand {
  const char* name;
  const char* group;
  const char* description;
  const char* example;
};
constexpr LabsCommand commands_of_labs[] = {
    {"export", for_teams, "Write a learned network as the source of a team",
     "mirocup export policy.npz -o learned.cpp"},
    {"tune", for_teams, "Find better values for a team's parameters",
     "mirocup tune mine.so --param wait=0.3:0.6 --against chaser,striker -o tuned"},
    {"record-as-seen", for_engineers,
     "Write what a camera would have seen of a played match, as a recording",
     "mirocup record-as-seen leg.json -o seen.jsonl"},
    {"identify", for_engineers,
     "Find the numbers of a pitch from recordings: floor, walls, motors, camera",
     "mirocup identify seen.jsonl -o ours.json --page ours.html"},
    {"validate", for_engineers, "Print how well the simulator predicts recordings",
     "mirocup validate seen.jsonl --pitch ours.json -o validation.html"},
    {"bench", for_engineers, "Compare speed and error with other engines",
     "mirocup bench --quick"}};

static Result<int> run(int argc, char** argv) {
  std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
  // `help league start` is `league start --help`.
  if (words.size() > 1 && words[0] == "help") {
    words.erase(words.begin());
    words.emplace_back("--help");
  }
  // `complete COMMAND WORD…` asks the program that runs the command.
  const bool completes = words.size() > 2 && words[0] == "complete";
  const auto command = words.begin() + (completes ? 1 : 0);
  const std::string asked = command != words.end() ? *command : "";
  if (asked == "league") {
    const bool is_tune = words.end() - command > 1 && command[1] == "tune";
    words.erase(command);
    return tl::unexpected(is_tune ? become_labs(words)
                                  : system::become_sibling_program("mirocup-league", words));
  }
  for (const LabsCommand& of_labs : commands_of_labs) {
    if (asked == of_labs.name) return tl::unexpected(become_labs(words));
  }

  system::Commands commands("mirocup", "A tournament platform for MiroSot robot soccer.",
                            record::software_version(),
                            "mirocup help COMMAND explains a command, with examples.");
  for (Add* const add :
       {add_match, add_drill, add_grade, add_check, add_compile, add_hand_in, add_join, add_new,
        add_verify, add_rerun, add_replay, add_playground, add_workbench, add_stats, add_coach})
    add(commands);
  commands.add_other(
      {"league",
       for_leagues,
       "Make, play and show leagues: mirocup help league",
       {"mirocup league init spring --team alpha=alpha.so --team house=house:striker",
        "mirocup league start spring"}});
  for (const auto& [name, group, description, example] : commands_of_labs)
    commands.add_other({name, group, description, {example}});
  for (Add* const add : {add_scene, add_referee}) add(commands);
  add_completion(commands);
  return commands.run(argc, argv, system::house_teams());
}

}  // namespace mirocup::app

int main(int argc, char** argv) {
  return mirocup::system::run_program([&] { return mirocup::app::run(argc, argv); });
}
