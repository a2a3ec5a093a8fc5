// SPDX-License-Identifier: MIT
#include "tournaments/format/format.hpp"

#include "core/base/assert.hpp"
#include "tournaments/format/swiss.hpp"

namespace mirocup::league {

int Format::swiss_rounds(int teams) const {
  return rounds > 0 ? rounds : usual_swiss_rounds(teams);
}

std::string objection(const Format& format, int teams) {
  if (teams < 2) return "a league needs two teams";
  if (format.kind == FormatKind::groups && format.groups * 2 > teams)
    return std::to_string(format.groups) + " groups need " + std::to_string(2 * format.groups) +
           " teams";
  const int max = max_swiss_rounds(teams);
  if (format.kind == FormatKind::swiss && format.rounds > max)
    return std::to_string(teams) + " teams can play " + std::to_string(max) +
           " rounds at most if no two of them meet twice";
  return "";
}

std::vector<Fixture> first_schedule(const Format& format, int teams) {
  MIROCUP_ASSERT(objection(format, teams).empty());
  const KnockoutOptions knockout_options{.legs = format.legs, .third_place = format.third_place};
  switch (format.kind) {
    case FormatKind::double_round_robin:
      return round_robin(teams);
    case FormatKind::round_robin:
      return round_robin(teams, format.legs);
    case FormatKind::groups:
      return groups_then_knockout(teams, {.groups = format.groups,
                                          .qualifiers = format.qualifiers,
                                          .legs = format.legs,
                                          .knockout = {.third_place = format.third_place}});
    case FormatKind::knockout: {
      std::vector<TeamSource> seeds;
      for (int team = 0; team < teams; ++team)
        seeds.push_back({.kind = TeamSource::Kind::team, .index = team});
      return knockout(seeds, knockout_options);
    }
    case FormatKind::swiss:
    case FormatKind::ladder:
    case FormatKind::nightly:
      break;
  }
  return {};
}

}  // namespace mirocup::league
