// SPDX-License-Identifier: MIT
std::vector<std::string> neighbours(const LeagueState& state, const std::string& team);
