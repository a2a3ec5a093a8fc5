// SPDX-License-Identifier: MIT
#include "server/dds/domain.hpp"

#include "server/dds/credentials.hpp"
#include "server/dds/network_interface.hpp"

#include <cstdio>

namespace mirocup::dds {

namespace {

constexpr dds_domainid_t domain_id = 0;
constexpr int first_port =
    7410;  // of participant 0 in domain 0; each following participant's is two higher

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
         "<AllowMulticast>false</AllowMulticast></General>"
         "<Discovery><ParticipantIndex>" +
         index +
         "</ParticipantIndex><SPDPInterval>500ms</SPDPInterval><LeaseDuration>3s</LeaseDuration>" +
         peers +
         "</Discovery>"
         // Otherwise Cyclone would assemble a giant sample before it throws it away.
         "<Internal><MaxSampleSize>64 kB</MaxSampleSize></Internal>"
         "<Tracing><Verbosity>none</Verbosity></Tracing></Domain></CycloneDDS>";
}

Result<Domain> open_domain(const std::string& interface, const std::string& xml,
                           const std::string& credentials) {
  Domain opened{.log = std::make_unique<CycloneLog>(), .domain = {}, .credentials = credentials};
  const auto before = open_descriptors();
  auto made =
      keep(opened.domain, created(dds_create_domain(domain_id, xml.c_str()), "the connection"));
  if (!made) return fail(made.error().code, made.error().what + opened.log->last_error_suffix());
  if (!interface.empty()) bind_to_interface(before, interface);
  return opened;
}

std::string safe(std::string_view text) {
  std::string out;
  for (const char c : text) {
    const bool is_plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                          (c >= '0' && c <= '9') || c == '-' || c == '_' || c == '.';
    if (is_plain) {
      out += c;
      continue;
    }
    char code[4];
    std::snprintf(code, sizeof code, "%%%02X", static_cast<unsigned char>(c));
    out += code;
  }
  return out;
}

}  // namespace

Result<Domain> open_server_domain(const std::string& interface, const std::string& credentials) {
  Result<Domain> opened = fail(Errc::unavailable, "");
  for (int index = 0; index < server_ports; ++index) {
    opened =
        open_domain(interface, configuration(interface, std::to_string(index), ""), credentials);
    if (opened) return opened;
  }
  return fail(Errc::unavailable, "none of the " + std::to_string(server_ports) +
                                     " ports for match servers is free on \"" + interface +
                                     "\" (or there is no such interface): " + opened.error().what);
}

Result<Domain> open_team_domain(const std::string& server, const std::string& credentials) {
  const bool is_local = server == "localhost" || server.rfind("127.", 0) == 0;
  std::string peers;
  for (int index = 0; index < server_ports; ++index) {
    peers += "<Peer Address=\"" + server + ":" + std::to_string(first_port + 2 * index) + "\"/>";
  }
  const std::string interface = is_local ? "lo" : "";
  return open_domain(interface, configuration(interface, "none", "<Peers>" + peers + "</Peers>"),
                     credentials);
}

Result<Entity> make_participant(const Domain& domain) {
  Qos qos(dds_create_qos());
  if (!domain.credentials.empty()) {
    if (auto set = set_credentials(qos.get(), domain.credentials); !set) {
      return tl::unexpected(set.error());
    }
  }
  auto made = created(dds_create_participant(domain_id, qos.get(), nullptr), "the participant");
  if (!made) return fail(made.error().code, made.error().what + domain.log->last_error_suffix());
  return made;
}

std::string match_partition(std::string_view match_id) {
  return "match-" + safe(match_id);
}

std::string team_partition(std::string_view match_id, int colour, std::string_view name) {
  return match_partition(match_id) + (colour == 0 ? "/blue/" : "/yellow/") + safe(name);
}

}  // namespace mirocup::dds
