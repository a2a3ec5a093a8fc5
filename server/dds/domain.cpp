// SPDX-License-Identifier: MIT
#include "server/dds/domain.hpp"

namespace mirocup::dds {

namespace {

constexpr dds_domainid_t domain_id = 0;
constexpr int first_port = 7410;  // of participant 0 in domain 0; each next one is two higher

bool is_address(const std::string& interface) {
  return interface.find_first_not_of("0123456789.:") == std::string::npos;
}

std::string interface_xml(const std::string& interface) {
  return "<Interfaces><NetworkInterface " +
         std::string(is_address(interface) ? "address" : "name") + "=\"" + interface +
         "\"/></Interfaces>";
}

// A giant sample would otherwise be gathered before it is thrown away.
constexpr const char* limits = "<Internal><MaxSampleSize>64 kB</MaxSampleSize></Internal>";

// Errors are told by whoever asked; the library's own chatter is not for the user.
constexpr const char* quiet = "<Tracing><Verbosity>none</Verbosity></Tracing>";

Result<Domain> open_domain(const std::string& xml) {
  auto domain = created(dds_create_domain(domain_id, xml.c_str()), "the domain");
  if (!domain) return tl::unexpected(domain.error());
  auto participant =
      created(dds_create_participant(domain_id, nullptr, nullptr), "the participant");
  if (!participant) return tl::unexpected(participant.error());
  return Domain{std::move(*domain), std::move(*participant)};
}

}  // namespace

Result<Domain> open_server_domain(const std::string& interface) {
  Result<Domain> opened = fail(Errc::unavailable, "");
  for (int index = 0; index < server_ports; ++index) {
    opened = open_domain(
        "<CycloneDDS><Domain Id=\"any\"><General>" + interface_xml(interface) +
        "<AllowMulticast>false</AllowMulticast></General><Discovery><ParticipantIndex>" +
        std::to_string(index) +
        "</ParticipantIndex><SPDPInterval>500ms</SPDPInterval><LeaseDuration>3s</LeaseDuration>"
        "</Discovery>" +
        limits + quiet + "</Domain></CycloneDDS>");
    if (opened) return opened;
  }
  return fail(Errc::unavailable, "none of the " + std::to_string(server_ports) +
                                     " ports for match servers is free on \"" + interface +
                                     "\" (or there is no such interface): " + opened.error().what);
}

Result<Domain> open_team_domain(const std::string& server) {
  const bool is_local = server == "localhost" || server.rfind("127.", 0) == 0;
  std::string peers;
  for (int index = 0; index < server_ports; ++index) {
    peers += "<Peer Address=\"" + server + ":" + std::to_string(first_port + 2 * index) + "\"/>";
  }
  return open_domain("<CycloneDDS><Domain Id=\"any\"><General>" +
                     (is_local ? interface_xml("lo") : std::string()) +
                     "<AllowMulticast>false</AllowMulticast></General><Discovery>"
                     "<ParticipantIndex>none</ParticipantIndex><SPDPInterval>500ms</SPDPInterval>"
                     "<LeaseDuration>3s</LeaseDuration><Peers>" +
                     peers + "</Peers></Discovery>" + limits + quiet + "</Domain></CycloneDDS>");
}

std::string match_partition(const std::string& match_id) {
  return "match-" + match_id;
}

std::string team_partition(const std::string& match_id, int colour) {
  return match_partition(match_id) + (colour == 0 ? "/blue" : "/yellow");
}

}  // namespace mirocup::dds
