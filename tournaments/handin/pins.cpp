// SPDX-License-Identifier: MIT
#include "tournaments/handin/pins.hpp"

#include "tournaments/handin/replies.hpp"
#include "tournaments/league/submission.hpp"

#include <nlohmann/json.hpp>

namespace mirocup::league {

namespace {

constexpr int max_pins = 10;  // of a team in an hour

}  // namespace

web::Reply pin_version(DeskState& state, const std::string& team, const std::string& asked) {
  const auto entry = asked == "latest" ? std::optional(0) : number_of(asked);
  if (!entry) return problem_reply(400, "?entry=N or ?entry=latest is expected");
  const std::lock_guard lock(state.mutex);
  const std::int64_t now = state.options.now();
  // In a ladder each change has legs of its own.
  if (state.book.pins_in_last_hour(team, now) >= max_pins) {
    return problem_reply(429, team + " has chosen its version " + std::to_string(max_pins) +
                                  " times in the last hour; choose again later");
  }
  const auto done = pin_entry(state.files, state.folder, team, *entry, now);
  if (!done) return host_failed(done.error());
  if (!done->empty()) return problem_reply(409, *done);
  if (auto written = state.book.pin(team, *entry, now); !written)
    return host_failed(written.error());
  ++state.version;
  const auto playing = playing_entry(state.files, state.folder, team);
  if (!playing) return host_failed(playing.error());
  return json_reply(200, {{"pinned", *entry > 0 ? Json(*entry) : Json()}, {"playing", *playing}});
}

}  // namespace mirocup::league
