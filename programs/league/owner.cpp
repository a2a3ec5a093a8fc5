// SPDX-License-Identifier: MIT
//
// mirocup league owner: whose files in a shared inbox count for a team.
#include "programs/league/commands.hpp"
#include "record/json_reader.hpp"
#include "system/clock.hpp"
#include "system/file_lock.hpp"
#include "system/locations.hpp"
#include "system/printable.hpp"
#include "system/users.hpp"
#include "tournaments/league/firasim_team.hpp"
#include "tournaments/league/inbox.hpp"

#include <iostream>

namespace mirocup::league {

namespace {

struct OwnerOptions {
  std::string folder;
  std::string team;
  std::string user;      // name or number; "": print who it is
  bool is_free = false;  // the next user whose file is accepted is the owner
};

Result<int> run_owner(const OwnerOptions& options) {
  MIROCUP_TRY_VOID(expect_owner(Folder{options.folder}));
  system::Disk disk;
  const Folder folder{options.folder};
  if (!is_good_name(options.team))
    return fail(Errc::input, "\"" + options.team + "\" is no name of a team");
  MIROCUP_TRY_VOID(LeagueStore::open(disk, folder));
  MIROCUP_TRY(const auto lock, system::FileLock::acquire(folder.submitting()));
  MIROCUP_TRY(auto known, read_hand_ins(disk, folder, options.team));
  if (options.is_free || !options.user.empty()) {
    known.owner.reset();
    if (!options.is_free) {
      known.owner = system::find_user(options.user);
      if (!known.owner) return fail(Errc::input, "there is no user " + options.user);
    }
    MIROCUP_TRY_VOID(write_hand_ins(disk, folder, options.team, known));
  }
  std::cout << options.team << ": "
            << (known.owner ? system::printable(system::name_of_user(*known.owner)) +
                                  " hands in by a shared inbox"
                            : "the user who hands in first by a shared inbox becomes its owner")
            << '\n';
  return exit_yes;
}

}  // namespace

void add_owner(system::Commands& commands) {
  const auto [command, o] =
      commands.add(run_owner, "owner", to_take,
                   "Print or change the user who hands in for a team by a shared inbox",
                   {"mirocup league owner spring alpha student7"});
  add_folder(command, o.folder);
  command.option("TEAM", o.team, "Name of the team").required();
  const system::Option user =
      command.option("USER", o.user, "Name or number of the user (default: print the owner)");
  command.flag("--free", o.is_free, "Let the next user whose file is accepted own the team")
      .excludes(user);
}

}  // namespace mirocup::league
