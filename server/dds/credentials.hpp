// SPDX-License-Identifier: MIT
//
// Secure mode: a process shows a certificate, and everybody enforces what its permissions, signed
// by the league, allow. README.md has the files.
#pragma once

#include "core/base/error.hpp"

#include <dds/dds.h>

#include <string>

namespace mirocup::dds {

// Makes a participant with this QoS a secure one. `folder` holds the files; a missing one is
// Errc::input.
Result<void> set_credentials(dds_qos_t* qos, const std::string& folder);

}  // namespace mirocup::dds
