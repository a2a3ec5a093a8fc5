// SPDX-License-Identifier: MIT
//
// Secure mode (DDS Security): every process shows a certificate and permissions that the league has
// signed, and every other process enforces the permissions. README.md describes the files.
#pragma once

#include "core/base/error.hpp"

#include <dds/dds.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace mirocup::dds {

// Adds to `qos` the properties of a secure participant. `folder` holds the credentials. If a file
// is missing, the error is Errc::input.
Result<void> set_credentials(dds_qos_t* qos, const std::string& folder);

// Returns the moment, in seconds since 1970 UTC, until which the certificate in `folder` and the
// certificates of its authorities are valid. Returns nothing if the certificates cannot be read.
std::optional<std::int64_t> credentials_end(const std::string& folder);

// Like credentials_end(), for a team's certificate in the folder of the server's credentials.
// Returns nothing if the folder has no certificate of the team.
std::optional<std::int64_t> team_credentials_end(const std::string& server_folder,
                                                 std::string_view team);

}  // namespace mirocup::dds
