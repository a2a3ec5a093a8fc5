// SPDX-License-Identifier: MIT
#include "programs/mirocup/command_line.hpp"

#include "programs/mirocup/commands.hpp"
#include "record/match_record.hpp"
#include "server/dds/domain.hpp"
#include "system/locations.hpp"

namespace mirocup::app {

namespace {

// What the values of options are called, for options that do not say it themselves.
const system::ValueNames value_names{
    {"--seed", "SEED"},          {"--half", "SECONDS"},      {"--tick", "TICK"},
    {"--match", "ID"},           {"--interface", "NAME"},    {"--join-within", "SECONDS"},
    {"--away-limit", "SECONDS"}, {"--dds-domain", "NUMBER"}, {"--tries", "NUMBER"},
    {"--jobs", "NUMBER"},        {"--at-least", "MARKS"},    {"--name", "NAME"},
    {"--server", "HOST"},        {"--entries", "DIR"},       {"--at", "SECONDS"},
    {"--clip", "FROM:TO"},       {"--noise-mm", "MM"},       {"--noise-deg", "DEGREES"},
    {"--gaps", "SHARE"},         {"--outliers", "SHARE"},    {"--record", "RECORD"},
};

}  // namespace

void add_dds_domain(const system::Command& command, int& domain) {
  command.option("--dds-domain", domain, "DDS domain of the match; each domain has its own ports")
      .between(dds::default_domain, dds::last_domain)
      .shows_default();
}

void add_parameters(const system::Command& command, const char* option,
                    std::vector<std::string>& changes, const std::string& whose) {
  command
      .option(option, changes,
              "Set a parameter of " + whose +
                  ", a number that the strategy asks for by name; may be given several times")
      .named("KEY=VALUE");
}

std::variant<system::Run, int> read_command_line(int argc, char** argv) {
  system::Commands commands("mirocup", "A tournament platform for MiroSot robot soccer.",
                            record::software_version(),
                            "mirocup help COMMAND explains a command, with examples.");
  for (Add* const add :
       {add_match, add_drill, add_check, add_compile, add_hand_in, add_join, add_new, add_export,
        add_verify, add_rerun, add_replay, add_playground, add_stats})
    add(commands);
  commands.add_other(
      {"league",
       for_leagues,
       "Make, play and show leagues: mirocup help league",
       {"mirocup league init spring --team alpha=alpha.so --team house=house:striker",
        "mirocup league start spring"}});
  for (Add* const add : {add_record_as_seen, add_identify, add_validate, add_scene, add_referee})
    add(commands);
  commands.add_other(
      {"tune",
       for_teams,
       "Find better values for a team's parameters: mirocup tune --help",
       {"mirocup tune mine.so --param wait=0.3:0.6 --against chaser,striker -o tuned"}});
  commands.add_other({"bench",
                      for_engineers,
                      "Compare speed and error with other engines: mirocup help bench",
                      {"mirocup bench --quick"}});
  add_completion(commands);
  return commands.read(argc, argv, value_names, system::house_teams());
}

}  // namespace mirocup::app
