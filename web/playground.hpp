// SPDX-License-Identifier: MIT
//
// The playground: one page in which a visitor plays by hand, without a server.
#pragma once

#include "web/page_parts.hpp"

#include <optional>
#include <string>

namespace mirocup::web {

// Returns the playground's page with the drills of mirocup; nothing if the module was not built.
Result<std::optional<std::string>> playground_page(system::Files& files);

}  // namespace mirocup::web
