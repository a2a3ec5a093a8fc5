// SPDX-License-Identifier: MIT
#include "tournaments/league/kept_program.hpp"

#include "server/record/json_reader.hpp"
#include "server/record/match_record.hpp"
#include "system/locations.hpp"

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

}  // namespace

std::string kept_program(const Folder& folder, const std::string& game) {
  return folder.programs() + "/" + game + "/mirocup";
}

std::string program_of_game(system::Files& files, const Folder& folder, const std::string& game) {
  const bool is_other = game != record::this_software().behaviour_hash;
  const std::string kept = is_game(game) ? kept_program(folder, game) : "";
  if (is_other && !kept.empty() && files.exists(kept)) return kept;
  return system::sibling_program("mirocup");
}

Result<std::string> game_of_record(system::Files& files, const Folder& folder,
                                   const std::string& record) {
  const std::string path = folder.path + "/" + record;
  const auto text = files.read_if_there(path, {.max_size = system::size_limit::record});
  if (!text) return tl::unexpected(text.error());
  if (!*text) return "";
  return record::read_json<std::string>(**text, path, Errc::damaged, read_game);
}

}  // namespace mirocup::league
