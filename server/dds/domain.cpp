// SPDX-License-Identifier: MIT
#include "server/dds/domain.hpp"

#include "server/dds/claim.hpp"
#include "server/dds/credentials.hpp"
#include "server/dds/network_interface.hpp"
#include "system/host_address.hpp"
#include "system/text.hpp"

namespace mirocup::dds {

namespace {

constexpr double name_limit = 10.0;  // s in which the name of a server must be resolved

constexpr int port_base = 7400;

// Two teams behind one address send some 60 answers and 40 acknowledgements a second, and each
// calls ten ports twice a second. 0x000100c2 is the writer of a call (SPDP).
constexpr const char* rules = R"(table inet mirocup {
  set callers { type ipv4_addr; flags dynamic, timeout; timeout 1m; size 65535; }
  set senders { type ipv4_addr; flags dynamic, timeout; timeout 1m; size 65535; }
  set receivers { type ipv4_addr; flags dynamic, timeout; timeout 1m; size 65535; }
  chain input {
    type filter hook input priority filter;
    iifname "lo" accept
    udp dport $ports @th,416,32 0x000100c2 \
      add @callers { ip saddr limit rate over 50/second burst 100 packets } drop
    udp dport $ports add @senders { ip saddr limit rate over 200/second burst 400 packets } drop
  }
  chain output {
    type filter hook output priority filter;
    oifname "lo" accept
    udp sport $ports add @receivers { ip daddr limit rate over 400/second burst 800 packets } drop
  }
}
)";

// Nothing that is sent needs to be fragmented by IP: a lost fragment would lose all of a packet,
// and some firewalls drop fragments. Cyclone splits larger samples itself.
constexpr const char* message_sizes =
    "<MaxMessageSize>1472B</MaxMessageSize><FragmentSize>1344B</FragmentSize>";

bool is_address(const std::string& interface) {
  return interface.find_first_not_of("0123456789.:") == std::string::npos;
}

std::string interface_xml(const std::string& interface, bool can_multicast = false) {
  return "<Interfaces><NetworkInterface " +
         std::string(is_address(interface) ? "address" : "name") + "=\"" + interface + "\"" +
         (can_multicast ? " multicast=\"true\"" : "") + "/></Interfaces>";
}

// The parts of a configuration that depend on the side.
struct Side {
  std::string interface;  // an XML element, or "": all interfaces
  std::string index;      // the participant index; "none" takes any free port
  std::string discovery;  // further elements of Discovery
  std::string multicast = "false";
  std::string further;  // further elements of Domain
};

std::string configuration(const Side& side) {
  return "<CycloneDDS><Domain Id=\"any\"><General>" + side.interface + "<AllowMulticast>" +
         side.multicast + "</AllowMulticast>" + message_sizes +
         "</General>"
         "<Discovery><ParticipantIndex>" +
         side.index +
         "</ParticipantIndex><SPDPInterval>500ms</SPDPInterval><LeaseDuration>3s</LeaseDuration>" +
         side.discovery + "</Discovery>" + side.further +
         // Otherwise Cyclone would assemble a giant sample before it throws it away. With more than
         // one thread that receives, its end waits for a packet to itself, which may not arrive.
         "<Internal><MaxSampleSize>64 kB</MaxSampleSize>"
         "<MultipleReceiveThreads>false</MultipleReceiveThreads></Internal>"
         // CycloneLog reads of it who has no credentials; nothing is written.
         "<Tracing><Category>discovery</Category><OutputFile>stderr</OutputFile></Tracing>"
         "</Domain></CycloneDDS>";
}

Side listed_side(const std::string& interface, int index) {
  return {.interface = interface_xml(interface),
          .index = std::to_string(index),
          .discovery = "",
          .further = ""};
}

// One socket sends and receives everything, so that an answer comes from the address and port to
// which the team has sent, and it goes to the address and port from which the team has sent. A
// router that translates addresses lets it in as the reply. Cyclone has one socket only if it may
// multicast; with "ssm" and no such writer it sends none but the membership report of its group.
Side replying_side(const std::string& interface, int index) {
  const int offset = port_of(0, index) - port_base;
  return {.interface = interface_xml(interface, true),
          .index = "none",
          .discovery = "<Ports><MulticastMetaOffset>" + std::to_string(offset) +
                       "</MulticastMetaOffset></Ports>",
          .multicast = "ssm",
          .further =
              "<Compatibility><ManySocketsMode>none</ManySocketsMode></Compatibility>"
              // In spite of its name it holds for UDP too.
              "<TCP><AlwaysUsePeeraddrForUnicast>true</AlwaysUsePeeraddrForUnicast></TCP>"};
}

Result<Domain> open_domain(const std::string& interface, const std::string& xml,
                           const std::string& credentials, int number) {
  Domain opened{.log = std::make_unique<CycloneLog>(),
                .domain = {},
                .number = number,
                .credentials = credentials,
                .reply = Reply::to_listed};
  const auto before = open_descriptors();
  const dds_entity_t domain = dds_create_domain(static_cast<dds_domainid_t>(number), xml.c_str());
  if (domain == DDS_RETCODE_PRECONDITION_NOT_MET)
    return fail(Errc::input, "this process has a connection in DDS domain " +
                                 std::to_string(number) + " already: close it first");
  auto made = created(domain, "the connection");
  if (!made) return fail(made.error().code, made.error().what + opened.log->last_error_suffix());
  opened.domain = std::move(*made);
  if (!interface.empty()) bind_to_interface(before, interface);
  return opened;
}

}  // namespace

int port_of(int domain, int index) {
  return port_base + 250 * domain + 10 + 2 * index;
}

std::string firewall_rules(int domain) {
  return "define ports = " + std::to_string(port_of(domain, 0)) + "-" +
         std::to_string(port_of(domain, server_ports - 1) + 1) + "\n" + rules;
}

Result<Domain> open_server_domain(const std::string& interface, const std::string& credentials,
                                  int number, Reply reply) {
  Result<Domain> opened = fail(Errc::unavailable, "");
  for (int index = 0; index < server_ports; ++index) {
    const Side side =
        reply == Reply::to_source ? replying_side(interface, index) : listed_side(interface, index);
    system::Descriptor port;
    if (reply == Reply::to_source) {
      // Until Cyclone has opened its socket, another match could take the same port unnoticed.
      MIROCUP_TRY(port, claim("mirocup-port-" + std::to_string(port_of(number, index))));
      if (!port.is_open()) continue;
    }
    opened = open_domain(interface, configuration(side), credentials, number);
    if (!opened) continue;
    opened->reply = reply;
    opened->port = std::move(port);
    return opened;
  }
  return fail(Errc::unavailable, "none of the " + std::to_string(server_ports) +
                                     " ports for match servers in DDS domain " +
                                     std::to_string(number) + " is free on \"" + interface +
                                     "\" (or there is no such interface): " + opened.error().what);
}

Result<Domain> open_team_domain(const std::string& server, const std::string& credentials,
                                int number, const std::string& interface) {
  const bool is_local = server == "localhost" || server.rfind("127.", 0) == 0;
  // By its address, because Cyclone would ask for a name's once for each peer.
  MIROCUP_TRY(const auto address, system::address_of(server, name_limit));
  std::string peers;
  for (int index = 0; index < server_ports; ++index) {
    peers += "<Peer Address=\"" + address + ":" + std::to_string(port_of(number, index)) + "\"/>";
  }
  // Cyclone would take the first interface that can multicast, which is not that of a VPN.
  const std::string own = own_address_towards(address, interface);
  if (!interface.empty() && !interface_is_up(own)) {
    return fail(Errc::unavailable, "network interface \"" + interface +
                                       "\": this host has none of this name or address that is up");
  }
  const std::string from = is_local && interface.empty() ? "lo" : own;
  MIROCUP_TRY(Domain opened,
              open_domain(from,
                          configuration({.interface = from.empty() ? "" : interface_xml(from),
                                         .index = "none",
                                         .discovery = "<Peers>" + peers + "</Peers>",
                                         .further = ""}),
                          credentials, number));
  opened.server = address;
  opened.own_address = own;
  return opened;
}

Result<Entity> make_participant(const Domain& domain) {
  Qos qos(dds_create_qos());
  if (!domain.credentials.empty()) MIROCUP_TRY_VOID(set_credentials(qos.get(), domain.credentials));
  auto made = created(
      dds_create_participant(static_cast<dds_domainid_t>(domain.number), qos.get(), nullptr),
      "the participant");
  if (!made) return fail(made.error().code, made.error().what + domain.log->last_error_suffix());
  return made;
}

std::string match_partition(std::string_view match_id) {
  return "match-" + system::percent_coded(match_id);
}

std::string team_partition(std::string_view match_id, int colour, std::string_view name) {
  return match_partition(match_id) + (colour == 0 ? "/blue/" : "/yellow/") +
         system::percent_coded(name);
}

}  // namespace mirocup::dds
