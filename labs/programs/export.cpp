// SPDX-License-Identifier: MIT
//
// mirocup export POLICY: writes a learned network as the source of a team.
#include "labs/programs/commands.hpp"
#include "labs/training/policy/policy.hpp"
#include "system/files.hpp"
#include "system/locations.hpp"
#include "system/printable.hpp"
#include "system/text.hpp"

#include <filesystem>
#include <iostream>

namespace mirocup::labs {

namespace {

struct ExportOptions {
  std::string policy;  // the path of a mirocup/policy/1
  std::string output;  // of the source
};

// The name of the team: that of the file, in letters that a string and a report may have.
std::string team_name(const std::string& path) {
  std::string name = std::filesystem::path(path).stem().string();
  for (char& c : name) {
    if (!system::is_plain(c)) c = '_';
  }
  return name.empty() ? "learned" : name.substr(0, 31);
}

Result<int> run_export(const ExportOptions& options) {
  system::Disk disk;
  MIROCUP_TRY(const auto bytes, disk.read_named(options.policy, system::size_limit::scene));
  MIROCUP_TRY(const auto policy, policy::parse_policy(bytes, options.policy));
  const std::string source = policy::source_of(policy, team_name(options.output));
  MIROCUP_TRY_VOID(disk.write(options.output, source));
  std::cout << system::printable(options.output) << ": the source of a team. "
            << "Compile it: c++ -std=c++17 -O2 -fPIC -shared -I "
            << system::printable(system::team_kit().prefix) << "/include" << ' '
            << system::printable(options.output) << " -o learned.so\n";
  return exit_yes;
}

}  // namespace

void add_export(system::Commands& commands) {
  const auto [command, o] = commands.add(run_export, "export", for_teams,
                                         "Write a learned network as the source of a team",
                                         {"mirocup export policy.npz -o learned.cpp"});
  command.option("POLICY", o.policy, "The network, an .npz of schema mirocup/policy/1").required();
  command.option("-o,--output FILE.cpp", o.output, "File to write the source to").required();
}

}  // namespace mirocup::labs
