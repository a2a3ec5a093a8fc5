// SPDX-License-Identifier: MIT
//
// Claims of a name on this host. A claim ends with its descriptor, even if the process is killed.
// It is an abstract socket: it has no file, and all processes that share the network, and with it
// the ports, of this host know its name.
#pragma once

#include "core/base/error.hpp"
#include "system/descriptor.hpp"

#include <string>

namespace mirocup::dds {

// Returns a closed descriptor if another process has the claim. `name` has at most 100 bytes.
// Errors: Errc::unavailable.
Result<system::Descriptor> claim(const std::string& name);

}  // namespace mirocup::dds
