// SPDX-License-Identifier: MIT
//
// Discovery is a star. A match server listens on one of ten fixed ports of its DDS domain. Teams
// and spectators know its address and ask all ten. Nothing is multicast, and teams never see each
// other.
#pragma once

#include "server/dds/cyclone_log.hpp"
#include "server/dds/entity.hpp"

#include <memory>
#include <string_view>

namespace mirocup::dds {

// The number of match servers that can run on one host at the same time.
inline constexpr int server_ports = 10;

// DDS domains are numbered from 0. Each has its own ports, so another domain moves the ports.
inline constexpr int default_domain = 0;
inline constexpr int last_domain = 230;  // later domains have no valid ports

// Returns the port of discovery of the participant with an index, as DDSI-RTPS 2.2 says (9.6.1.1);
// its data come at the next port.
int port_of(int domain, int index);

// The connection of this process to the network. Its destructor leaves the network properly. A
// process has at most one at a time.
struct Domain {
  std::unique_ptr<CycloneLog> log;
  Entity domain;
  int number = default_domain;
  std::string credentials;  // the folder of this process's credentials; "": open mode
};

// `interface` is the name or the address of the network interface at which the server is reached;
// "lo" restricts it to this host. Errc::unavailable if none of the domain's ports is free.
Result<Domain> open_server_domain(const std::string& interface, const std::string& credentials,
                                  int number = default_domain);

// `server` is the host that the match server runs on.
Result<Domain> open_team_domain(const std::string& server, const std::string& credentials,
                                int number = default_domain);

// Makes the DDS participant, which is the parent of all topics, readers and writers.
Result<Entity> make_participant(const Domain& domain);

// Returns a text for a partition or a file: every byte but letters, digits, '-', '_' and '.' is
// written as %XX.
std::string encoded(std::string_view text);

// The DDS partitions of a match and of one team in it.
std::string match_partition(std::string_view match_id);
std::string team_partition(std::string_view match_id, int colour, std::string_view name);

}  // namespace mirocup::dds
