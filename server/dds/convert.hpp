// SPDX-License-Identifier: MIT
//
// Conversions between the match's structures and the topics of idl/mirocup.idl. A conversion
// changes no number, because both sides have the frame and the units of the field.
#pragma once

#include "core/match/leg.hpp"

#include <mirocup.h>
#include <string>
#include <string_view>

namespace mirocup::dds {

// The longest name of a team, bytes.
inline constexpr std::size_t max_team_name = sizeof(mirocup_v1_Hello::name) - 1;

// `robots`: number of each team's robots. `leg`: the number that the server drew for the leg.
mirocup_v1_WorldState to_sample(const match::Snapshot& scene, int robots, std::uint64_t leg);
match::Snapshot to_scene(const mirocup_v1_WorldState& sample);

// The answer to a Hello in a Welcome. The numbers are those of the IDL's constants
// ADMISSION_ACCEPTED and so on.
enum class Admission : std::uint8_t { accepted, not_now, refused };

// Returns the facts of a leg for spectators. `speed`: factor of real time, 0 for lockstep.
mirocup_v1_MatchInfo to_sample(const match::Briefing& briefing, std::uint64_t leg,
                               const match::ByTeam<std::string>& names, double speed);

// Returns a Welcome that accepts the team and holds the whole briefing.
mirocup_v1_Welcome to_sample(const match::Briefing& briefing, std::uint64_t leg,
                             std::uint64_t nonce);

// A briefing together with the structures that it points to. The object cannot be copied or moved,
// because the pointers of a copy would lead into the original.
struct OwnedBriefing {
  OwnedBriefing() = default;
  OwnedBriefing(const OwnedBriefing&) = delete;
  OwnedBriefing& operator=(const OwnedBriefing&) = delete;

  field::Field field;
  simulator::Parameters parameters;
  referee::Rules rules;
  match::Briefing briefing;
};

// Fills `owned` from the numbers of a Welcome. Returns false, and leaves `owned` unchanged, if the
// Welcome has an unknown league or colour.
bool from_sample(const mirocup_v1_Welcome& sample, OwnedBriefing& owned);

// `number` counts the events of the leg from 0. `score` is the score after the decision.
mirocup_v1_MatchEvent to_sample(const match::LoggedDecision& decision, std::uint64_t leg,
                                std::uint32_t number, const match::ByTeam<int>& score);

// `tick` is the tick of the WorldState that the command answers. `nonce` is from the team's Hello.
mirocup_v1_TeamCommand to_sample(const match::Command& command, Team team, std::uint32_t tick,
                                 std::uint64_t nonce);
match::Command to_command(const mirocup_v1_TeamCommand& sample);

// True if mirocup.idl has constants for the sample's state, phase, restart and colours, and the
// number of robots is at most MAX_ROBOTS. The caller ignores other samples.
bool is_known(const mirocup_v1_WorldState& sample);

// Returns why this process cannot play with one that has the topic layout `theirs`; "" if it can.
std::string layout_mismatch(std::uint32_t theirs);

// Copies text into a bounded string of a sample and cuts it to fit.
template <std::size_t size>
void copy_text(char (&to)[size], std::string_view text) {
  const std::size_t length = text.copy(to, size - 1);
  to[length] = '\0';
}

}  // namespace mirocup::dds
