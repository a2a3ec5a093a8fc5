// SPDX-License-Identifier: MIT
//
// mirocup coach RECORD: until when the goals that a team conceded could have been prevented.
#include "programs/coach/study.hpp"
#include "programs/mirocup/commands.hpp"
#include "system/text.hpp"

namespace mirocup::app {

namespace {

using coach::GoalStudy;
using system::formatted;

struct CoachOptions {
  std::string record;
  std::string team;                      // a colour
  std::optional<int> goal;               // the number of one goal
  std::string substitute;                // library or house team; "": striker and keeper
  match::ByTeam<std::string> libraries;  // of the teams of the record; "": not given
  bool trusted = false;
  bool json = false;
};

// A team in a sandbox cannot be copied with what it remembers.
Result<server::TeamChoice> choose(const CoachOptions& options, const std::string& text) {
  MIROCUP_TRY(auto choice, server::choose_team(text));
  if (choice.info.kind == record::TeamKind::house || options.trusted) return choice;
  return fail(Errc::input, text +
                               ": its futures are played in this process, without protection "
                               "from it; give --trusted if you trust it");
}

Result<coach::Cast> cast_of(const CoachOptions& options, const record::MatchRecord& record) {
  coach::Cast cast{.team = *from_string<Team>(options.team)};
  for (const Team team : both_teams) {
    const record::TeamInfo& info = record.teams[index_of(team)];
    const std::string& given = options.libraries[index_of(team)];
    if (given.empty() && info.kind != record::TeamKind::house) continue;
    MIROCUP_TRY(cast.own[index_of(team)], choose(options, given.empty() ? info.name : given));
    cast.own[index_of(team)]->info.parameters = info.parameters;
  }
  MIROCUP_TRY(cast.stand_in, server::choose_team("navigator"));
  const bool is_given = !options.substitute.empty();
  MIROCUP_TRY(cast.substitute, choose(options, is_given ? options.substitute : "striker"));
  if (!is_given) {
    MIROCUP_TRY(cast.keeper, server::choose_team("keeper"));
  }
  return cast;
}

std::string text_of(const GoalStudy& study, double period) {
  const auto before = [&](std::uint32_t tick) {
    return formatted("%.1f s before", (study.tick - tick) * period);
  };
  std::string text = formatted("Goal %d, ", study.number) + in_words(study.clock) + ": ";
  if (const auto& found = study.prevention) {
    const coach::Interval interval = coach::interval_of(found->share);
    text += "until " + before(found->tick) +
            formatted(
                ", robot %d (%.1f m from the ball) could prevent it: %d of %d futures "
                "without a goal (%.0f to %.0f %%), %d of %d as the team played",
                found->robot, found->to_ball, found->share.without, found->share.futures,
                100.0 * interval.low, 100.0 * interval.high, found->as_played.without,
                found->as_played.futures);
  } else {
    text += "no robot alone could prevent it from " + before(study.first) + " on";
  }
  return text + "; from " + before(study.hopeless) + ", nobody could\n";
}

record::Json json_of(const GoalStudy& study, double period) {
  const auto moment = [&](std::uint32_t tick) {
    return record::Json{{"tick", tick}, {"seconds_before", (study.tick - tick) * period}};
  };
  record::Json json{{"number", study.number},         {"tick", study.tick},
                    {"clock", in_words(study.clock)}, {"first", moment(study.first)},
                    {"prevention", nullptr},          {"hopeless", moment(study.hopeless)}};
  for (const Team team : both_teams)
    json["decides"][to_string(team)] = study.decides[index_of(team)];
  if (const auto& found = study.prevention) {
    const coach::Interval interval = coach::interval_of(found->share);
    json["prevention"] = moment(found->tick);
    json["prevention"].update({{"robot", found->robot},
                               {"to_ball", found->to_ball},
                               {"ball", {found->ball.x(), found->ball.y()}},
                               {"without_goal", found->share.without},
                               {"futures", found->share.futures},
                               {"low", interval.low},
                               {"high", interval.high},
                               {"as_played", found->as_played.without}});
  }
  return json;
}

// What the other robots do.
std::string text_of_others(const record::MatchRecord& record, const std::vector<GoalStudy>& goals) {
  std::string text;
  for (const Team team : both_teams) {
    const int i = index_of(team);
    const bool decides =
        std::all_of(goals.begin(), goals.end(), [&](const auto& goal) { return goal.decides[i]; });
    text += system::printable(record.teams[i].name) + " (" + std::string(to_string(team)) +
            (decides ? ") decides for its other robots, with its memory.\n"
                     : ") is not at hand as it played: its other robots drive as recorded for "
                       "0.3 s, then navigator decides.\n");
  }
  return text;
}

Result<int> run_coach(const CoachOptions& options) {
  system::Disk disk;
  MIROCUP_TRY(const auto record, record::load(disk, options.record));
  if (const auto differs = replay::verify(record.recording))
    return not_reproduced(options.record, record, *differs, "studied");
  MIROCUP_TRY(const auto cast, cast_of(options, record));
  const auto conceded = coach::goals_against(record.recording, cast.team).size();
  if (options.goal && static_cast<std::size_t>(*options.goal) > conceded)
    return fail(Errc::input, formatted("--goal %d: the ", *options.goal) + options.team +
                                 " team conceded " + std::to_string(conceded) + " goals in " +
                                 options.record);
  MIROCUP_TRY(const auto goals, coach::study_goals(record, cast, options.goal));
  const double period = record.recording.setup.control_period;
  if (options.json) {
    record::Json json{{"record", options.record}, {"team", options.team}};
    json["goals"] = record::Json::array();
    for (const auto& goal : goals) json["goals"].push_back(json_of(goal, period));
    print_json(json);
    return exit_yes;
  }
  for (const auto& goal : goals) std::cout << text_of(goal, period);
  std::cout << (goals.empty() ? "The " + options.team + " team conceded no goal.\n"
                              : text_of_others(record, goals));
  return exit_yes;
}

}  // namespace

void add_coach(system::Commands& commands) {
  const auto [command, o] = commands.add(
      run_coach, "coach", after_a_leg,
      "Find until when the goals against a team could have been prevented, and by which robot",
      {"mirocup coach leg.json --team blue",
       "mirocup coach leg.json --team blue --goal 2 --substitute mine.so --trusted"});
  command.option("RECORD", o.record, "Match record").required();
  command.option("--team", o.team, "Team that conceded the goals")
      .one_of(system::names_of<Team>())
      .required();
  command.option("--goal NUMBER", o.goal, "Only this one of the goals that the team conceded")
      .between(1, 1000);
  command.option("--substitute TEAM", o.substitute,
                 "Library or house team that decides for one robot (default: striker, and keeper "
                 "in the goal)");
  command.option("--blue LIBRARY", o.libraries[0], "Library of the blue team of the record");
  command.option("--yellow LIBRARY", o.libraries[1], "Library of the yellow team of the record");
  command.flag("--trusted", o.trusted,
               "Let the given libraries play in this process, without protection from them");
  command.flag("--json", o.json, "Print the answer as one JSON object");
}

}  // namespace mirocup::app
