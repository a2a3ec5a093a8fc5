// SPDX-License-Identifier: MIT
//
// How processes find each other: a star. A match server listens on one of ten fixed ports; teams
// and spectators know its address and ask all ten. Nothing is multicast, and teams never see each
// other.
#pragma once

#include "server/dds/entity.hpp"

namespace mirocup::dds {

// Match servers that can run on one host at the same time.
inline constexpr int server_ports = 10;

// A domain with its participant, for one match. Deleting it leaves the network in order.
struct Domain {
  Entity domain;
  Entity participant;
};

// `interface`: a network interface's name or address that the server is reached at; "lo" for this
// host only.
Result<Domain> open_server_domain(const std::string& interface);

// `server`: the host that the match server runs on.
Result<Domain> open_team_domain(const std::string& server);

// Partitions of a match.
std::string match_partition(const std::string& match_id);
std::string team_partition(const std::string& match_id, int colour);

}  // namespace mirocup::dds
