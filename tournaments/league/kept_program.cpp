// SPDX-License-Identifier: MIT
#include "tournaments/league/kept_program.hpp"

#include "record/json_reader.hpp"
#include "record/match_record.hpp"
#include "system/locations.hpp"
#include "system/trusted_program.hpp"

#include <unistd.h>
#include <utility>

namespace mirocup::league {

namespace {

// A hash of hexadecimal digits; anything else in a record names no folder.
bool is_game(const std::string& game) {
  return !game.empty() && game.size() <= 64 &&
         game.find_first_not_of("0123456789abcdef") == std::string::npos;
}

std::string read_game(const record::JsonReader& json) {
  std::string game;
  json.at("software").read_if_present("game", game);
  return game;
}

// A line for each program that this host has kept or trusts: its SHA-256.
std::string list_path() {
  return system::state_folder() + "/programs";
}

// Returns the text of the list; "" if there is none yet.
Result<std::string> read_list() {
  if (system::state_folder().empty())
    return fail(Errc::unavailable,
                "there is no place for this host's list of programs: set XDG_STATE_HOME");
  system::Disk disk;
  if (!disk.exists(list_path())) return "";
  const auto real = system::trusted_path(list_path());
  if (!real)
    return fail(real.error().code,
                "the list " + list_path() + " is not read: " + real.error().what);
  return disk.read(*real, {.max_size = system::size_limit::note});
}

}  // namespace

std::string kept_program(const Folder& folder, const std::string& game) {
  return folder.programs() + "/" + game + "/mirocup";
}

std::string kept_module(const Folder& folder, const std::string& game, const std::string& file) {
  return folder.programs() + "/" + (is_game(game) ? game : "none") + "/" + file;
}

Result<std::string> game_of_record(system::Files& files, const Folder& folder,
                                   const std::string& record) {
  const std::string path = folder.path + "/" + record;
  MIROCUP_TRY(const auto text, files.read_if_there(path, {.max_size = system::size_limit::record}));
  if (!text) return "";
  return record::read_json<std::string>(*text, path, Errc::damaged, read_game);
}

Result<bool> is_trusted_program(const std::string& bytes) {
  MIROCUP_TRY(const auto list, read_list());
  return list.find(system::sha256(bytes) + "\n") != std::string::npos;
}

Result<void> trust_program(const std::string& bytes) {
  MIROCUP_TRY(const auto is_trusted, is_trusted_program(bytes));
  if (is_trusted) return {};
  system::Disk disk;
  return disk.make_folder(system::state_folder(), system::Readers::owner).and_then([&] {
    return disk.append(list_path(), system::sha256(bytes) + "\n");
  });
}

Result<std::vector<std::string>> trust_kept_programs(system::Files& files, const Folder& folder) {
  std::vector<std::string> trusted;
  MIROCUP_TRY(const auto games, files.names_if_there(folder.programs()));
  for (const std::string& game : games) {
    const std::string path = kept_program(folder, game);
    if (!is_game(game) || !files.exists(path)) continue;
    MIROCUP_TRY(const auto bytes, files.read(path, {.max_size = max_program}));
    MIROCUP_TRY_VOID(trust_program(bytes));
    trusted.push_back(path);
    for (const char* file : kept_module_files) {
      MIROCUP_TRY(const auto part,
                  files.read_if_there(kept_module(folder, game, file), {.max_size = max_program}));
      if (!part) continue;
      MIROCUP_TRY_VOID(trust_program(*part));
    }
  }
  return trusted;
}

MatchServers::MatchServers(system::Files& files, const Folder& folder)
    : files_(files), folder_(folder) {
  own_.path = system::sibling_program("mirocup");
  own_.words = {own_.path};
}

const MatchServer& MatchServers::of_game(const std::string& game) {
  const bool is_other = game != record::this_software().behaviour_hash && is_game(game);
  if (!is_other) return own_;
  const auto known = by_game_.find(game);
  if (known != by_game_.end()) return known->second;
  const std::string path = kept_program(folder_, game);
  if (!files_.exists(path)) return own_;
  return by_game_.emplace(game, open_kept(path)).first->second;
}

const MatchServer& MatchServers::of_record(const std::string& record) {
  const std::string path = folder_.path + "/" + record;
  const auto text = files_.read(path, {.max_size = system::size_limit::record});
  if (!text || !record::expect_whole(*text, path)) return own_;
  return of_game(
      record::read_json<std::string>(*text, path, Errc::damaged, read_game).value_or(""));
}

MatchServer MatchServers::open_kept(const std::string& path) {
  const auto bytes = files_.read(path, {.max_size = max_program});
  const auto is_trusted = bytes ? is_trusted_program(*bytes) : tl::unexpected(bytes.error());
  MatchServer server = own_;
  if (!is_trusted) {
    server.why_not_kept = path + " is not run: " + is_trusted.error().what;
  } else if (!*is_trusted) {
    server.why_not_kept = path +
                          " is not run, since this host's list of trusted programs does not have "
                          "it; if you trust the " +
                          "programs of this folder: mirocup league verify " + folder_.path +
                          " --trust-programs";
  } else if (auto copy = system::sealed_copy(*bytes); !copy) {
    server.why_not_kept = path + " is not run: " + copy.error().what;
  } else {
    const std::string here = "/proc/" + std::to_string(getpid()) + "/fd/";
    server = {.path = path,
              .words = {"/usr/bin/env", std::string(system::asks_no_other) + "=1",
                        here + std::to_string(copy->get())},
              .why_not_kept = ""};
    copies_.push_back(std::move(*copy));
  }
  return server;
}

}  // namespace mirocup::league
