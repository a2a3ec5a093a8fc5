// SPDX-License-Identifier: MIT
//
// Between the match's structures and the topics of idl/mirocup.idl.
#pragma once

#include "core/match/match.hpp"

#include <mirocup.h>
#include <string_view>

namespace mirocup::dds {

mirocup_v2_WorldState to_sample(const match::Scene& scene, int robots, std::uint64_t leg);
match::Scene to_scene(const mirocup_v2_WorldState& sample);

// How a Welcome answers a Hello.
enum class Admission : std::uint8_t { accepted, not_now, refused };

// Accepted, with everything that a team is told once.
mirocup_v2_Welcome to_sample(const match::Briefing& briefing, std::uint64_t leg,
                             std::uint64_t nonce);

// A briefing together with the structures that it points to. It cannot be copied or moved: the
// pointers of a copy would lead into the original.
struct OwnedBriefing {
  OwnedBriefing() = default;
  OwnedBriefing(const OwnedBriefing&) = delete;
  OwnedBriefing& operator=(const OwnedBriefing&) = delete;

  field::Field field;
  simulator::Parameters parameters;
  referee::Rules rules;
  match::Briefing briefing;
};

// Fills `owned` with what the numbers of a Welcome stand for. Returns false, and leaves `owned`
// alone, if its league or its colour does not exist.
bool from_sample(const mirocup_v2_Welcome& sample, OwnedBriefing& owned);

mirocup_v2_MatchEvent to_sample(const match::LoggedDecision& decision, std::uint64_t leg,
                                std::uint32_t number, const match::ByTeam<int>& score);

mirocup_v2_TeamCommand to_sample(const match::Command& command, Team team, std::uint32_t tick,
                                 std::uint64_t nonce);
match::Command to_command(const mirocup_v2_TeamCommand& sample);

// Into a bounded string of a sample; what is too long is cut.
template <std::size_t size>
void copy_text(char (&to)[size], std::string_view text) {
  const std::size_t length = text.copy(to, size - 1);
  to[length] = '\0';
}

}  // namespace mirocup::dds
