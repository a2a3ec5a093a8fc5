// SPDX-License-Identifier: MIT
#pragma once

namespace mirocup {

// True if the tests run on a host of their own (own_host.cpp). Otherwise a test must leave the
// ports of this computer to the other tests. Valid inside tests.
bool is_on_own_host();

}  // namespace mirocup
