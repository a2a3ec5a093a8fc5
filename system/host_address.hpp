// SPDX-License-Identifier: MIT
//
// The address of a host by its name. The system's resolver may wait for half a minute.
#pragma once

#include "core/base/error.hpp"

#include <string>

namespace mirocup::system {

// Returns the first IPv4 address of a host in dotted form, "10.0.0.5". `host` is a name or such an
// address. Errc::unavailable if the host has no IPv4 address, or if the resolver does not answer
// within `seconds`; such a resolver continues in another thread.
Result<std::string> address_of(const std::string& host, double seconds);

}  // namespace mirocup::system
