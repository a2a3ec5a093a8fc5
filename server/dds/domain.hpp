// SPDX-License-Identifier: MIT
//
// Discovery is a star. A match server listens on one of ten fixed ports of its DDS domain. Teams
// and spectators know the host's address and ask all ten ports. Nothing is multicast, and teams do
// not discover each other.
#pragma once

#include "server/dds/cyclone_log.hpp"
#include "server/dds/entity.hpp"
#include "system/descriptor.hpp"

#include <memory>
#include <string_view>

namespace mirocup::dds {

// The number of match servers that can run on one host at the same time.
inline constexpr int server_ports = 10;

// DDS domains are numbered from 0. Each domain has its own ports.
inline constexpr int default_domain = 0;
inline constexpr int last_domain = 230;  // later domains have no valid ports

// Returns the discovery port of the participant number `index`, as in DDSI-RTPS 2.2 (9.6.1.1). The
// participant receives data at the next port.
int port_of(int domain, int index);

// Returns rules for nftables that let each address send to the ports of a domain, and get from
// there, little more than two teams do: one forged call draws answers of many times its size.
std::string firewall_rules(int domain);

// Where a server sends the packets for a team.
enum class Reply {
  to_listed,  // to the addresses that the team lists, from any port
  to_source,  // back to where the team's packets come from, from the port they were sent to (NAT)
};

// The connection of this process to the network. Its destructor leaves the network properly. A
// process has at most one Domain at a time.
struct Domain {
  std::unique_ptr<CycloneLog> log;
  Entity domain;
  int number = default_domain;
  std::string credentials;  // the folder of this process's credentials; "": open mode
  Reply reply = Reply::to_listed;
  system::Descriptor port{};     // the claim of the discovery port, with Reply::to_source
  std::string server = {};       // a team's: the address of the match server
  std::string own_address = {};  // a team's: the address of this host towards the match server
};

// `interface` is the name or the address of the network interface at which the server is reached;
// "lo" restricts the server to this host. Errc::unavailable if no port of the domain is free.
Result<Domain> open_server_domain(const std::string& interface, const std::string& credentials,
                                  int number = default_domain, Reply reply = Reply::to_listed);

// `server` is the host of the match server. `interface`, a name or an IPv4 address, leads to it; if
// it is empty, the routing table says which does. Errc::unavailable if it is not up.
Result<Domain> open_team_domain(const std::string& server, const std::string& credentials,
                                int number = default_domain, const std::string& interface = "");

// Makes the DDS participant, which is the parent of all topics, readers and writers.
Result<Entity> make_participant(const Domain& domain);

// Return the DDS partitions of a match and of one team in the match.
std::string match_partition(std::string_view match_id);
std::string team_partition(std::string_view match_id, int colour, std::string_view name);

}  // namespace mirocup::dds
