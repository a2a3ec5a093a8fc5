// SPDX-License-Identifier: MIT
//
// Who moves together: bodies that hold each other are one cluster, and one power series.
#pragma once

#include "core/simulator/impact.hpp"

#include <span>

namespace mirocup::simulator {

// The bodies that hold together with this one, itself included; empty if nothing holds it.
BodySet cluster_of(int body, std::span<const Contact> contacts);

}  // namespace mirocup::simulator
