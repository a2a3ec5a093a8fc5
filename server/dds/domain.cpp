// SPDX-License-Identifier: MIT
#include "server/dds/domain.hpp"

#include "server/dds/credentials.hpp"
#include "server/dds/network_interface.hpp"
#include "system/host_address.hpp"
#include "system/text.hpp"

namespace mirocup::dds {

namespace {

constexpr double name_limit = 10.0;  // s in which the name of a server must be resolved

// Nothing that is sent needs to be fragmented by IP: a lost fragment would lose all of a packet,
// and some firewalls drop fragments. Cyclone splits larger samples itself.
constexpr const char* message_sizes =
    "<MaxMessageSize>1472B</MaxMessageSize><FragmentSize>1344B</FragmentSize>";

bool is_address(const std::string& interface) {
  return interface.find_first_not_of("0123456789.:") == std::string::npos;
}

std::string interface_xml(const std::string& interface) {
  return "<Interfaces><NetworkInterface " +
         std::string(is_address(interface) ? "address" : "name") + "=\"" + interface +
         "\"/></Interfaces>";
}

// `index` is the participant index; "none" takes any free port.
std::string configuration(const std::string& interface, const std::string& index,
                          const std::string& peers) {
  return "<CycloneDDS><Domain Id=\"any\"><General>" +
         (interface.empty() ? std::string() : interface_xml(interface)) +
         "<AllowMulticast>false</AllowMulticast>" + message_sizes +
         "</General>"
         "<Discovery><ParticipantIndex>" +
         index +
         "</ParticipantIndex><SPDPInterval>500ms</SPDPInterval><LeaseDuration>3s</LeaseDuration>" +
         peers +
         "</Discovery>"
         // Otherwise Cyclone would assemble a giant sample before it throws it away. With more than
         // one thread that receives, its end waits for a packet to itself, which may not arrive.
         "<Internal><MaxSampleSize>64 kB</MaxSampleSize>"
         "<MultipleReceiveThreads>false</MultipleReceiveThreads></Internal>"
         // CycloneLog reads of it who has no credentials; nothing is written.
         "<Tracing><Category>discovery</Category><OutputFile>stderr</OutputFile></Tracing>"
         "</Domain></CycloneDDS>";
}

Result<Domain> open_domain(const std::string& interface, const std::string& xml,
                           const std::string& credentials, int number) {
  Domain opened{.log = std::make_unique<CycloneLog>(),
                .domain = {},
                .number = number,
                .credentials = credentials};
  const auto before = open_descriptors();
  const dds_entity_t domain = dds_create_domain(static_cast<dds_domainid_t>(number), xml.c_str());
  if (domain == DDS_RETCODE_PRECONDITION_NOT_MET) {
    return fail(Errc::input, "this process has a connection in DDS domain " +
                                 std::to_string(number) + " already: close it first");
  }
  auto made = created(domain, "the connection");
  if (!made) return fail(made.error().code, made.error().what + opened.log->last_error_suffix());
  opened.domain = std::move(*made);
  if (!interface.empty()) bind_to_interface(before, interface);
  return opened;
}

}  // namespace

int port_of(int domain, int index) {
  return 7400 + 250 * domain + 10 + 2 * index;
}

Result<Domain> open_server_domain(const std::string& interface, const std::string& credentials,
                                  int number) {
  Result<Domain> opened = fail(Errc::unavailable, "");
  for (int index = 0; index < server_ports; ++index) {
    opened = open_domain(interface, configuration(interface, std::to_string(index), ""),
                         credentials, number);
    if (opened) return opened;
  }
  return fail(Errc::unavailable, "none of the " + std::to_string(server_ports) +
                                     " ports for match servers in DDS domain " +
                                     std::to_string(number) + " is free on \"" + interface +
                                     "\" (or there is no such interface): " + opened.error().what);
}

Result<Domain> open_team_domain(const std::string& server, const std::string& credentials,
                                int number) {
  const bool is_local = server == "localhost" || server.rfind("127.", 0) == 0;
  // By its address, because Cyclone would ask for a name's once for each peer.
  MIROCUP_TRY(const auto address, system::address_of(server, name_limit));
  std::string peers;
  for (int index = 0; index < server_ports; ++index) {
    peers += "<Peer Address=\"" + address + ":" + std::to_string(port_of(number, index)) + "\"/>";
  }
  const std::string interface = is_local ? "lo" : "";
  return open_domain(interface, configuration(interface, "none", "<Peers>" + peers + "</Peers>"),
                     credentials, number);
}

Result<Entity> make_participant(const Domain& domain) {
  Qos qos(dds_create_qos());
  if (!domain.credentials.empty()) {
    MIROCUP_TRY_VOID(set_credentials(qos.get(), domain.credentials));
  }
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
