// SPDX-License-Identifier: MIT
//
// How processes find each other: a star. A match server listens on one of ten fixed ports; teams
// and spectators know its address and ask all ten. Nothing is multicast, and teams never see each
// other.
#pragma once

#include "server/dds/cyclone_log.hpp"
#include "server/dds/entity.hpp"

#include <memory>
#include <string_view>

namespace mirocup::dds {

// Match servers that can run on one host at the same time.
inline constexpr int server_ports = 10;

// This process on the network. Deleting it leaves the network in order; there can be one at a time.
struct Domain {
  std::unique_ptr<CycloneLog> log;
  Entity domain;
  std::string credentials;  // the folder with what this process is known by, "": open mode
};

// `interface`: a network interface's name or address that the server is reached at; "lo" for this
// host only.
Result<Domain> open_server_domain(const std::string& interface, const std::string& credentials);

// `server`: the host that the match server runs on.
Result<Domain> open_team_domain(const std::string& server, const std::string& credentials);

// What takes part: the parent of all topics, readers and writers.
Result<Entity> make_participant(const Domain& domain);

// Partitions of a match. What is not safe in one is written as %XX.
std::string match_partition(std::string_view match_id);
std::string team_partition(std::string_view match_id, int colour, std::string_view name);

}  // namespace mirocup::dds
