// SPDX-License-Identifier: MIT
//
// Secure mode (DDS Security): every process shows a certificate and its permissions, which the
// league has signed, and every other process enforces them. README.md describes the files.
#pragma once

#include "core/base/error.hpp"

#include <dds/dds.h>

#include <string>

namespace mirocup::dds {

// Adds to `qos` the properties that make a participant a secure one. `folder` holds the
// credentials; a missing file is Errc::input.
Result<void> set_credentials(dds_qos_t* qos, const std::string& folder);

}  // namespace mirocup::dds
