// SPDX-License-Identifier: MIT
#include "server/dds/credentials.hpp"

#include "system/files.hpp"
#include "system/text.hpp"
#include "system/tls.hpp"

#include <algorithm>

namespace mirocup::dds {

namespace {

struct Library {
  const char* property;
  const char* name;
  const char* init;
  const char* finalize;
};

// Cyclone's own libraries, which it finds by these names.
constexpr Library libraries[] = {
    {"dds.sec.auth.library", "dds_security_auth", "init_authentication", "finalize_authentication"},
    {"dds.sec.crypto.library", "dds_security_crypto", "init_crypto", "finalize_crypto"},
    {"dds.sec.access.library", "dds_security_ac", "init_access_control", "finalize_access_control"},
};

struct File {
  const char* property;
  const char* name;
  bool is_needed = true;
};

constexpr File files[] = {
    {"dds.sec.auth.identity_ca", "identity_ca.pem"},
    {"dds.sec.auth.identity_certificate", "certificate.pem"},
    {"dds.sec.auth.private_key", "key.pem"},
    {"dds.sec.access.permissions_ca", "permissions_ca.pem"},
    {"dds.sec.access.governance", "governance.p7s"},
    {"dds.sec.access.permissions", "permissions.p7s"},
    // The list of revoked certificates; only servers have it.
    {"org.eclipse.cyclonedds.sec.auth.crl", "revoked.pem", false},
};

}  // namespace

Result<void> set_credentials(dds_qos_t* qos, const std::string& folder) {
  for (const Library& l : libraries) {
    const std::string property = l.property;
    dds_qset_prop(qos, (property + ".path").c_str(), l.name);
    dds_qset_prop(qos, (property + ".init").c_str(), l.init);
    dds_qset_prop(qos, (property + ".finalize").c_str(), l.finalize);
  }
  system::Disk disk;
  for (const File& f : files) {
    const std::string path = folder + "/" + f.name;
    // Without a list that is there everybody could join whose certificate was revoked.
    MIROCUP_TRY(const auto text, disk.read_if_there(path, {.max_size = system::size_limit::note,
                                                           .links = system::Links::followed}));
    if (!text && f.is_needed)
      return fail(Errc::input, folder + " holds no credentials: " + path + " is not there");
    if (text) dds_qset_prop(qos, f.property, ("file:" + path).c_str());
  }
  return {};
}

namespace {

// Reads a certificate of a folder that the host or the team has named.
Result<std::string> read_certificate(const std::string& path) {
  system::Disk disk;
  return disk.read_named(path, system::size_limit::certificate);
}

}  // namespace

std::optional<std::int64_t> credentials_end(const std::string& folder) {
  std::optional<std::int64_t> end;
  for (const char* name : {"certificate.pem", "identity_ca.pem", "permissions_ca.pem"}) {
    const auto text = read_certificate(folder + "/" + name);
    const auto one = text ? system::certificate_end(*text) : std::nullopt;
    if (!one) return std::nullopt;
    end = end ? std::min(*end, *one) : *one;
  }
  return end;
}

std::optional<std::int64_t> team_credentials_end(const std::string& server_folder,
                                                 std::string_view team) {
  const auto text =
      read_certificate(server_folder + "/teams/" + system::percent_coded(team) + ".pem");
  return text ? system::certificate_end(*text) : std::nullopt;
}

}  // namespace mirocup::dds
