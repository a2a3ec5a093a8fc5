// SPDX-License-Identifier: MIT
//
// The folder in which programs remember what belongs to this computer and not to a league.
#pragma once

#include <string>

namespace mirocup::system {

// Returns $STATE_DIRECTORY, which systemd sets, $XDG_STATE_HOME/mirocup or ~/.local/state/mirocup;
// "" if no variable names an absolute path. The folder may not be there.
std::string state_folder();

}  // namespace mirocup::system
