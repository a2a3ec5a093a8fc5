// SPDX-License-Identifier: MIT
//
// mirocup league submit: stores an entry, checks it, and plays with it if it passes.
#include "programs/league/commands.hpp"
#include "system/locations.hpp"
#include "tournaments/league/submission.hpp"

#include <filesystem>

namespace mirocup::league {

namespace {

struct SubmitOptions : LeagueOptions {
  std::string team;
  std::string file;
  std::string run;  // the command of a firasim team; "": people start it
  std::string run_folder = ".";
  bool lockstep = false;  // of a firasim team
  bool json = false;
};

// Prints the answer.
void print(const SubmitOptions& options, const Submission& done) {
  if (!options.json) {
    std::cout << system::printable(done.message) << '\n';
    const bool has_notes = done.verdict.is_object() && done.verdict.contains("notes");
    for (const Json& note : has_notes ? done.verdict["notes"] : Json::array()) {
      if (record::text_in(note, "code") == "processor")
        std::cout << "warning: " << system::printable(record::text_in(note, "text")) << '\n';
    }
    return;
  }
  print_json({{"accepted", done.is_accepted},
              {"team", options.team},
              {"file", options.file},
              {"entry", done.entry > 0 ? Json(done.entry) : Json()},
              {"message", done.message},
              {"verdict", done.verdict}});
}

// Writes a team whose source is "firasim:NAME" into league.json, which describes it completely.
// Replaces a team of that name if the replaced team also speaks FIRASim's protocol. Returns a
// sentence that says why the team cannot enter; "" if it was written.
Result<std::string> enter_firasim_team(system::Files& files, const Folder& folder,
                                       const TeamConfig& team, std::int64_t now) {
  MIROCUP_TRY(const auto lock, system::FileLock::acquire(folder.submitting()));
  MIROCUP_TRY(const auto store, LeagueStore::open(files, folder));
  LeagueFile file = store.state().file;
  if (store.state().is_started) return "the league has started, so its programs stay as they are";
  const auto known = store.state().find_team(team.name);
  if (known && !file.teams[*known].is_firasim())
    return "the league has a team of that name, which plays with " + file.teams[*known].source;
  if (!known) {
    if (const std::string why = why_not_now(store.state(), team.name, utc_text(now)); !why.empty())
      return why;
    file.teams.push_back(team);
  } else {
    file.teams[*known] = team;
  }
  // Parsed first, because the parser checks names.
  const std::string text = print_league_file(file);
  MIROCUP_TRY_VOID(parse_league_file(text, folder.config()));
  MIROCUP_TRY_VOID(files.write(folder.config(), text));
  return "";
}

// A program for FIRASim is no file to be checked: the team joins at once.
Result<int> enter_program(system::Files& files, const SubmitOptions& options) {
  TeamConfig team;
  team.name = options.team;
  team.source = options.file;
  team.program.run = options.run;
  if (!options.run.empty())
    team.program.folder = std::filesystem::absolute(options.run_folder).lexically_normal().string();
  team.program.lockstep = options.lockstep;
  MIROCUP_TRY(const auto why,
              enter_firasim_team(files, Folder{options.folder}, team, system::now_s()));
  Submission done;
  done.is_accepted = why.empty();
  done.message = team.name +
                 (!done.is_accepted ? ": not taken: " + why
                  : team.is_started_by_people()
                      ? ": each leg waits until a person has started the team's program"
                      : ": the league starts the team's program for each leg: " + team.program.run);
  print(options, done);
  return done.is_accepted ? exit_yes : exit_no;
}

Result<int> run_submit(const SubmitOptions& options) {
  MIROCUP_TRY_VOID(expect_owner(Folder{options.folder}));
  system::Disk disk;
  if (options.file.empty()) return fail(Errc::input, "\"\" names no file");
  // Before anything is locked there.
  MIROCUP_TRY_VOID(expect_league(disk, Folder{options.folder}));
  if (options.file.starts_with(TeamConfig::firasim_prefix)) return enter_program(disk, options);
  if (!options.run.empty() || options.lockstep)
    return fail(Errc::input, std::string(options.run.empty() ? "--lockstep" : "--run") +
                                 " is only for a team that is entered as firasim:NAME");
  HandIn handed;
  handed.team = options.team;
  handed.path = options.file;
  if (options.file.starts_with(TeamConfig::house_prefix)) {
    const std::string name = options.file.substr(TeamConfig::house_prefix.size());
    handed.path = system::house_team(name);
    handed.house = options.file;
    if (handed.path.empty()) return fail(Errc::input, "there is no house team \"" + name + "\"");
  }
  handed.at = system::now_s();
  MIROCUP_TRY(const auto done, submit(disk, Folder{options.folder}, handed));
  print(options, done);
  return done.is_accepted ? exit_yes : exit_no;
}

struct TakeOptions : LeagueOptions {
  std::string team;
  int entry = 0;
};

Result<int> run_take(system::Files& files, const LeagueStore& store, const TakeOptions& options) {
  MIROCUP_TRY(auto book, Book::open(files, store.folder()));
  MIROCUP_TRY(auto booking, Booking::begin(files, store.folder()));
  MIROCUP_TRY(const auto why,
              booking.take_late(book, options.team, options.entry, system::now_s()));
  if (!why.empty()) return fail(Errc::input, why);
  std::cout << options.team << " plays with entry " << book.hand_ins().playing(options.team)
            << '\n';
  return exit_yes;
}

}  // namespace

void add_take(system::Commands& commands) {
  const auto [command, o] = add_command(commands, on_own_league<run_take, TakeOptions>, "take",
                                        to_take, "Let an entry play that came after the deadline",
                                        {"mirocup league take spring alpha 7"});
  command.option("TEAM", o.team, "Name of the team").required();
  command.option("ENTRY", o.entry, "Number of the entry, as status --entries shows it").required();
}

void add_submit(system::Commands& commands) {
  const auto [command, o] =
      add_command(commands, run_submit, "submit", to_take,
                  "Hand in an entry: store it, check it, and play with it if it passes",
                  {"mirocup league submit spring alpha alpha.so"});
  command.option("TEAM", o.team, "Name of the team").required();
  command
      .option("FILE", o.file,
              "Library of the team (.so), its file of Python (.py), house:TEAM, or "
              "firasim:NAME for a program that speaks FIRASim's protocol")
      .required();
  const system::Option run =
      command.option("--run COMMAND", o.run,
                     "Command that starts a program for FIRASim in each leg; "
                     "without --run, a person starts the program");
  command
      .option("--folder DIR", o.run_folder,
              "Folder in which the command of --run runs (default: the working folder)")
      .needs(run);
  command.flag("--lockstep", o.lockstep,
               "Let the legs of a program for FIRASim wait for its answers, not for the clock");
  command.flag("--json", o.json, "Print the answer as a JSON object");
}

}  // namespace mirocup::league
