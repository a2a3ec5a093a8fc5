// SPDX-License-Identifier: MIT
//
// Between the match's structures and the topics of idl/mirocup.idl.
#pragma once

#include "core/match/leg.hpp"

#include <mirocup.h>
#include <string_view>

namespace mirocup::dds {

mirocup_v2_WorldState to_sample(const match::Snapshot& scene, int robots, std::uint64_t leg);
match::Snapshot to_scene(const mirocup_v2_WorldState& sample);

// How a Welcome answers a Hello.
enum class Admission : std::uint8_t { accepted, not_now, refused };

// Accepted, with everything that a team is told once.
mirocup_v2_Welcome to_sample(const match::Briefing& briefing, std::uint64_t leg,
                             std::uint64_t nonce);

// What the briefing's numbers stand for again; points into the structures given. False if a number
// cannot be.
struct Told {
  field::Field field;
  simulator::Parameters parameters;
  referee::Rules rules;
  match::Briefing briefing;
};
bool from_sample(const mirocup_v2_Welcome& sample, Told& told);

mirocup_v2_MatchEvent to_sample(const match::LoggedDecision& decision, std::uint64_t leg,
                                std::uint32_t number, const match::ByTeam<int>& score);

mirocup_v2_TeamCommand to_sample(const match::Command& command, Team team, std::uint32_t tick,
                                 std::uint64_t nonce);
match::Command to_command(const mirocup_v2_TeamCommand& sample);

// Into a bounded string of a sample; what is too long is cut.
template <std::size_t size>
void put_text(char (&to)[size], std::string_view text) {
  const std::size_t length = text.copy(to, size - 1);
  to[length] = '\0';
}

}  // namespace mirocup::dds
