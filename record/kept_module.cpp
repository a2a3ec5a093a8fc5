// SPDX-License-Identifier: MIT
#include "record/kept_module.hpp"

#include "record/json_reader.hpp"
#include "system/child_process.hpp"
#include "system/files.hpp"
#include "system/locations.hpp"
#include "system/printable.hpp"
#include "system/text.hpp"
#include "system/users.hpp"

#include <filesystem>
#include <iostream>
#include <unistd.h>

namespace mirocup::record {

namespace {

namespace fs = std::filesystem;

constexpr system::ReadOptions of_module{.max_size = system::size_limit::system_file};

// A hash of hexadecimal digits; anything else in a record names no folder.
bool is_game(const std::string& game) {
  return !game.empty() && game.size() <= 64 &&
         game.find_first_not_of("0123456789abcdef") == std::string::npos;
}

std::string path_of_module(const fs::path& league, const std::string& game) {
  return league / "programs" / game / "mirocup.wasm";
}

// A line for each module that this host has kept or trusts: its SHA-256.
std::string list_of_modules() {
  return system::state_folder() + "/programs";
}

Result<void> expect_own(const std::string& path) {
  const auto owner = system::owner_of(path).value_or(0);
  std::error_code none;
  const fs::perms others = fs::perms::group_write | fs::perms::others_write;
  if (owner != 0 && owner != system::this_user())
    return fail(Errc::unavailable, path + " belongs to " + system::name_of_user(owner));
  if ((fs::status(path, none).permissions() & others) != fs::perms::none)
    return fail(Errc::unavailable, path + " may be written by others than its owner");
  return {};
}

Result<bool> is_trusted(const std::string& bytes) {
  const std::string list = list_of_modules();
  if (system::state_folder().empty())
    return fail(Errc::unavailable,
                "there is no place for this host's list of modules: set XDG_STATE_HOME");
  system::Disk disk;
  if (!disk.exists(list)) return false;
  MIROCUP_TRY_VOID(expect_own(system::state_folder()));
  MIROCUP_TRY_VOID(expect_own(list));
  MIROCUP_TRY(const auto text, disk.read(list, {.max_size = system::size_limit::note}));
  return text.find(system::sha256(bytes) + "\n") != std::string::npos;
}

Result<void> trust(const std::string& bytes) {
  MIROCUP_TRY(const auto is_listed, is_trusted(bytes));
  if (is_listed) return {};
  system::Disk disk;
  return disk.make_folder(system::state_folder(), system::Readers::owner).and_then([&] {
    return disk.append(list_of_modules(), system::sha256(bytes) + "\n");
  });
}

}  // namespace

Result<void> keep_module(system::Files& files, const std::string& league) {
  const std::string own = system::browser_folder() + "/mirocup.wasm";
  if (!files.exists(own)) return {};
  MIROCUP_TRY(const auto bytes, files.read_named(own, of_module.max_size));
  if (const auto listed = trust(bytes); !listed) {
    std::cerr << "mirocup: the module of this program is not kept in " << system::printable(league)
              << ": " << system::printable(listed.error().what) << '\n';
    return {};
  }
  const std::string kept = path_of_module(league, this_software().behaviour_hash);
  const auto there = files.read(kept, of_module);
  if (there && is_trusted(*there).value_or(true)) return {};
  return files.make_folder(fs::path(kept).parent_path()).and_then([&] {
    return files.write(kept, bytes);
  });
}

Result<std::vector<std::string>> trust_modules(system::Files& files, const std::string& league) {
  std::vector<std::string> trusted;
  MIROCUP_TRY(const auto games, files.names_if_there(league + "/programs"));
  for (const std::string& game : games) {
    const std::string path = path_of_module(league, game);
    MIROCUP_TRY(const auto bytes, files.read_if_there(path, of_module));
    if (!bytes) continue;
    MIROCUP_TRY_VOID(trust(*bytes));
    trusted.push_back(path);
  }
  return trusted;
}

Result<std::optional<replay::Divergence>> verify_by_module(system::Files& files,
                                                           const std::string& path,
                                                           const MatchRecord& record) {
  const std::string& game = record.software.behaviour_hash;
  const fs::path league = fs::path(path).parent_path() / "..";
  const std::string module = path_of_module(league.lexically_normal(), is_game(game) ? game : "");
  MIROCUP_TRY(const auto bytes, files.read_if_there(module, of_module));
  if (!bytes) return fail(Errc::unavailable, module + " does not exist");
  MIROCUP_TRY(const auto is_listed, is_trusted(*bytes));
  if (!is_listed)
    return fail(Errc::unavailable,
                module +
                    " is not used, since this host's list of modules does not have it; if "
                    "you trust the modules of this folder: mirocup league verify " +
                    league.lexically_normal().string() + " --trust-programs");
  // Node gets the bytes that were checked, also if the file changes meanwhile.
  MIROCUP_TRY(const auto copy, system::sealed_copy(*bytes));
  const std::string sealed =
      "/proc/" + std::to_string(getpid()) + "/fd/" + std::to_string(copy.get());
  MIROCUP_TRY(const auto answer,
              system::ask({"node", "--no-warnings", system::browser_folder() + "/verify.mjs",
                           fs::absolute(path), "--json", "--module", sealed},
                          {.seconds = limit_of_repeating(record.recording.setup.rules.half_s),
                           .bytes = system::size_limit::note}));
  if (answer.code == system::not_found)
    return fail(Errc::unavailable, module + " is not used, since node is not installed");
  const std::string said = system::last_line(answer.output);
  auto found = read_json<std::optional<replay::Divergence>>(
      said, module, Errc::unavailable,
      [](const JsonReader& json) -> std::optional<replay::Divergence> {
        if (json.at("reproduced").boolean()) return std::nullopt;
        return replay::Divergence{.tick = json.at("tick").integer<std::uint32_t>(),
                                  .what = json.at("what").text()};
      });
  if (answer.code > exit_no || !found)
    return fail(Errc::unavailable, module + " does not verify it: " + said);
  return found;
}

}  // namespace mirocup::record
