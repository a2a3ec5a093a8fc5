// SPDX-License-Identifier: MIT
//
// What the module exports: the C interface that mirocup.js calls. Pointers are offsets in the
// module's memory. A text is a std::string that the caller frees; an answer is a text in JSON,
// {"error": {"code", "what"}} if something failed. Numbers of teams: 0 blue, 1 yellow.
#include "browser/game.hpp"
#include "record/json_reader.hpp"
#include "record/replay_file.hpp"

#include <cstdint>
#include <cstdlib>

#define MIROCUP_EXPORT(name) extern "C" __attribute__((export_name(#name)))

using namespace mirocup;
using browser::Game;
using browser::Json;
using Text = std::string;

namespace {

Text* answer(const Json& json) {
  return new Text(record::json_text(json));
}

Json error_json(const Error& error) {
  return {{"error", {{"code", exit_code(error.code)}, {"what", error.what}}}};
}

Text* answer(const Result<Json>& result) {
  return answer(result ? *result : error_json(result.error()));
}

// Hands the game over to the caller, as a number.
Json handle(Result<std::unique_ptr<Game>> game) {
  if (!game) return error_json(game.error());
  return {{"leg", reinterpret_cast<std::uintptr_t>(game->release())}};
}

Result<Json> parsed(const Text& text) {
  record::ParsedJson json = record::parse_json(text);
  if (json.problem) return tl::unexpected(record::error_of(*json.problem, "the leg", Errc::input));
  if (!json.value.is_object()) return fail(Errc::input, "the leg: an object is expected");
  return std::move(json.value);
}

}  // namespace

// Texts: of so many bytes, to be filled in; their bytes; their number; and their end.
MIROCUP_EXPORT(text_new) Text* text_new(std::size_t size) {
  return new Text(size, '\0');
}
MIROCUP_EXPORT(text_data) char* text_data(Text* text) {
  return text->data();
}
MIROCUP_EXPORT(text_size) std::size_t text_size(const Text* text) {
  return text->size();
}
MIROCUP_EXPORT(text_free) void text_free(Text* text) {
  delete text;
}

// Answers {reproduced, tick, what, ticks, state_hash, found}; browser::verify().
MIROCUP_EXPORT(verify)
Text* verify(const Text* record, const Text* replay, int is_whole, const Text* name) {
  return answer(browser::verify(*record, *replay, is_whole != 0, *name));
}
MIROCUP_EXPORT(sha256) Text* sha256(const Text* bytes) {
  return new Text(system::sha256(*bytes));
}

// Make a leg, Game::make() and Game::go_on(); answer {"leg": what the functions below take}.
MIROCUP_EXPORT(leg_make) Text* leg_make(const Text* options) {
  const auto json = parsed(*options);
  return answer(json ? handle(Game::make(*json)) : error_json(json.error()));
}
MIROCUP_EXPORT(leg_go_on)
Text* leg_go_on(const Text* record, const Text* replay, std::uint32_t tick, const Text* teams) {
  const auto json = parsed(*teams);
  if (!json) return answer(error_json(json.error()));
  auto past = browser::read_record(*record, *replay, "the record");
  if (!past) return answer(error_json(past.error()));
  return answer(handle(Game::go_on(*std::move(past), tick, *json)));
}
MIROCUP_EXPORT(leg_free) void leg_free(Game* game) {
  delete game;
}

MIROCUP_EXPORT(leg_play) int leg_play(Game* game, int ticks) {
  return game->play(ticks);
}
MIROCUP_EXPORT(leg_watch) void leg_watch(Game* game) {
  game->watch();
}
MIROCUP_EXPORT(leg_stop) void leg_stop(Game* game) {
  game->stop();
}
// Drives a robot by hand, rad/s; without `is_taken` its team drives it again.
MIROCUP_EXPORT(leg_drive)
void leg_drive(Game* game, int team, int robot, double left, double right, int is_taken) {
  game->take(both_teams[team], robot,
             is_taken != 0 ? std::optional(simulator::WheelSpeeds{left, right}) : std::nullopt);
}
// Game::seat(); answers {} or the error.
MIROCUP_EXPORT(leg_seat) Text* leg_seat(Game* game, const Text* teams) {
  const auto json = parsed(*teams);
  if (!json) return answer(error_json(json.error()));
  const auto seated = game->seat(*json);
  return answer(seated ? Json::object() : error_json(seated.error()));
}
// What a team drew in its last tick, as lines of mirocup/thoughts/1.
MIROCUP_EXPORT(leg_thoughts) Text* leg_thoughts(const Game* game, int team) {
  return new Text(game->driver(both_teams[team]).thoughts());
}
MIROCUP_EXPORT(leg_setup) Text* leg_setup(const Game* game) {
  return answer(game->setup());
}
MIROCUP_EXPORT(leg_tick) std::uint32_t leg_tick(const Game* game) {
  return game->leg().tick();
}
MIROCUP_EXPORT(leg_hash) std::uint64_t leg_hash(const Game* game) {
  return game->leg().state_hash();
}
MIROCUP_EXPORT(leg_status) Text* leg_status(const Game* game, std::size_t first) {
  return answer(game->status(first));
}
MIROCUP_EXPORT(leg_advice) Text* leg_advice(const Game* game, int team) {
  return answer(game->advice(both_teams[team]));
}
MIROCUP_EXPORT(leg_situation) Text* leg_situation(const Game* game) {
  return new Text(record::json_text(game->situation(), 1));
}

// The bodies as doubles: x and y of the ball, then x, y and heading of blue's and yellow's robots;
// metres and radians in the field's frame.
MIROCUP_EXPORT(leg_bodies) Text* leg_bodies(const Game* game) {
  const match::Snapshot now = game->leg().snapshot();
  Text bytes;
  const auto add = [&bytes](double value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  };
  add(now.ball.position.x());
  add(now.ball.position.y());
  for (const auto& robots : now.robots) {
    for (int i = 0; i < game->leg().field().robots_per_team; ++i) {
      for (const double value : {robots[i].position.x(), robots[i].position.y(), robots[i].heading})
        add(value);
    }
  }
  return new Text(std::move(bytes));
}

// The replay of a leg that is over, unpacked, and its record; the record names the replay file,
// whose packed bytes the caller has made of the first.
MIROCUP_EXPORT(leg_replay) Text* leg_replay(const Game* game) {
  return new Text(
      record::plain_replay(game->record().recording, game->leg().field().robots_per_team));
}
MIROCUP_EXPORT(leg_record)
Text* leg_record(const Game* game, const Text* replay_name, const Text* replay) {
  return new Text(record::record_text(game->record(), *replay_name, *replay));
}
