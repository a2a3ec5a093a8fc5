// SPDX-License-Identifier: MIT
#include "core/replay/playback.hpp"

#include "core/replay/recorded.hpp"

#include <utility>

namespace mirocup::replay {

namespace {

// Returns which bodies differ after the tick, and both states of the first of them at the next
// checkpoint. Plays the leg once more for it, because only a playback that differs needs a trace.
std::string what_differs(const Recording& recording, std::uint32_t tick) {
  const std::size_t checkpoint = (tick + checkpoint_ticks - 1) / checkpoint_ticks;
  match::Leg leg(recording.setup);
  StateTrace again;
  while (!leg.is_over() && again.checkpoints.size() <= checkpoint) {
    leg.advance(recorded_answers(recording, leg.tick()));
    again.add(leg);
  }
  const int robots = leg.field().robots_per_team;
  const auto bodies = differing_bodies(recording.trace, again, tick, 2 * robots + 1);
  if (bodies.empty()) return "";
  std::string text;
  for (const int body : bodies) text += (text.empty() ? "; " : ", ") + body_name(body, robots);
  text += bodies.size() == 1 ? " differs" : " differ";

  const auto& recorded = recording.trace.checkpoints;
  if (checkpoint >= recorded.size() || checkpoint >= again.checkpoints.size()) return text;
  const int body = bodies.front();
  return text + ": after tick " + std::to_string(checkpoint * checkpoint_ticks) +
         " the record has " + body_name(body, robots) + " " +
         body_text(recorded[checkpoint], body, robots) + ", the replay " +
         body_text(again.checkpoints[checkpoint], body, robots);
}

}  // namespace

Playback::Playback(const Recording& recording) : recording_(recording), leg_(recording.setup) {}

bool Playback::differs(std::uint32_t tick, std::string what) {
  divergence_ = Divergence{tick, std::move(what)};
  return false;
}

bool Playback::advance() {
  if (divergence_ || leg_.is_over()) return false;
  const std::uint32_t tick = leg_.tick();
  leg_.advance(recorded_answers(recording_, tick));
  if (leg_.log().size() <= tick) {  // a fault ended it before anything moved
    if (tick == recording_.ticks.size()) return false;
    return differs(tick, "the replay ends here, the record goes on");
  }
  if (tick >= recording_.ticks.size()) {
    return differs(tick, "the record ends here, the replay goes on");
  }
  const std::uint64_t expected = recording_.ticks[tick].hash;
  const std::uint64_t again = leg_.log()[tick].hash;
  if (again != expected) {
    return differs(tick, "the state differs: the record's hash is " + to_hex(expected) +
                             ", the replay's " + to_hex(again) + what_differs(recording_, tick));
  }
  if (leg_.is_over() && leg_.log().size() != recording_.ticks.size()) {
    return differs(leg_.tick(), "the replay ends here, the record goes on");
  }
  return true;
}

}  // namespace mirocup::replay
