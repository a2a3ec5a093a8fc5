// SPDX-License-Identifier: MIT
//
// mirocup coach RECORD: until when the goals that a team conceded could have been prevented.
#include "programs/coach/page.hpp"
#include "programs/mirocup/commands.hpp"
#include "record/wilson.hpp"
#include "system/text.hpp"

#include <algorithm>
#include <map>

namespace mirocup::app {

namespace {

using coach::GoalStudy;
using system::formatted;

struct CoachOptions {
  std::vector<std::string> records;
  std::string team;                      // a colour, or a name
  std::optional<int> goal;               // the number of one goal
  std::string substitute;                // library or house team; "": striker and keeper
  match::ByTeam<std::string> libraries;  // of the teams of the record; "": not given
  bool trusted = false;
  bool all = false;  // the habits in all goals of all records
  bool json = false;
  std::string page;  // file; "": none
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
  coach::Cast cast;
  cast.team = from_string<Team>(options.team)
                  .value_or(record.teams[1].name == options.team ? Team::yellow : Team::blue);
  if (!from_string<Team>(options.team) && record.teams[index_of(cast.team)].name != options.team)
    return fail(Errc::input, "--team " + options.team +
                                 ": neither blue nor yellow, and no team of "
                                 "this name played the leg");
  for (const Team team : both_teams) {
    const record::TeamInfo& info = record.teams[index_of(team)];
    const std::string& given = options.libraries[index_of(team)];
    if (given.empty() && info.kind != record::TeamKind::house) continue;
    auto own = choose(options, given.empty() ? info.name : given);
    if (given.empty() && !own) continue;  // a house team that played under another name
    MIROCUP_TRY(cast.own[index_of(team)], std::move(own));
    cast.own[index_of(team)]->info.parameters = info.parameters;
  }
  MIROCUP_TRY(cast.stand_in, server::choose_team("navigator"));
  const bool is_given = !options.substitute.empty();
  MIROCUP_TRY(cast.substitute, choose(options, is_given ? options.substitute : "striker"));
  MIROCUP_TRY(auto keeper, server::choose_team("keeper"));
  if (!is_given) cast.keeper = std::move(keeper);
  return cast;
}

// The moment of the answer in the address of a replay page.
std::string link_of(const GoalStudy& study, double period) {
  return formatted(" (#t=%.3f)",
                   period * (study.prevention ? study.prevention->tick : study.first));
}

std::string text_of(const GoalStudy& study, double period) {
  const auto before = [&](std::uint32_t tick) {
    return formatted("%.2f s before", (study.tick - tick) * period);
  };
  std::string text =
      formatted("Goal %d, ", study.number) + in_words(study.clock) + link_of(study, period) + ": ";
  if (const auto& found = study.prevention) {
    const auto interval = record::wilson_interval(found->share.value(), found->share.futures);
    text += "until " + before(found->tick) +
            formatted(
                ", robot %d (%.1f m from the ball) could prevent it: %d of %d futures "
                "without a goal (%.0f to %.0f %%), %d of %d as the team played",
                found->robot, found->to_ball, found->share.without, found->share.futures,
                100.0 * interval.low, 100.0 * interval.high, found->as_played.without,
                found->as_played.futures);
  } else {
    text += "no robot alone could prevent it from " + before(study.first) + " on";
    if (study.hopeless == study.first) return text + '\n';
  }
  return text + "; from " + before(study.hopeless) + ", nobody could\n";
}

// The kind of a goal: who could prevent it, how early, and where the ball was then.
std::string habit_of(const GoalStudy& study, const match::Setup& setup) {
  if (!study.prevention) return "no robot alone could prevent it";
  const double seconds = (study.tick - study.prevention->tick) * setup.control_period;
  const double third =
      3.0 * study.prevention->ball.x() / field::make_field(setup.league).half_length;
  return formatted("robot %d could prevent it until %s s before, with the ball in the %s third",
                   study.prevention->robot,
                   seconds < 0.5   ? "less than 0.5"
                   : seconds < 1.5 ? "0.5 to 1.5"
                                   : "more than 1.5",
                   third < -1.0  ? "own"
                   : third > 1.0 ? "opponents'"
                                 : "middle");
}

record::Json json_of(const GoalStudy& study, const match::Setup& setup, const std::string& path) {
  const auto moment = [&](std::uint32_t tick) {
    return record::Json{{"tick", tick},
                        {"seconds_before", (study.tick - tick) * setup.control_period}};
  };
  record::Json json{{"number", study.number},
                    {"tick", study.tick},
                    {"clock", in_words(study.clock)},
                    {"first", moment(study.first)},
                    {"prevention", nullptr},
                    {"hopeless", moment(study.hopeless)},
                    {"decides", {{"blue", study.decides[0]}, {"yellow", study.decides[1]}}},
                    {"record", path},
                    {"habit", habit_of(study, setup)}};
  if (const auto& found = study.prevention) {
    const auto interval = record::wilson_interval(found->share.value(), found->share.futures);
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
    bool decides = true;
    for (const GoalStudy& goal : goals) decides = decides && goal.decides[index_of(team)];
    text += system::printable(record.teams[index_of(team)].name) +
            (decides ? " decides for its other robots, with its memory.\n"
                     : " is not at hand as it played: its other robots drive as recorded for "
                       "0.3 s, then navigator decides.\n");
  }
  return text;
}

// For each habit its goals: "leg.json goal 2".
using Habits = std::map<std::string, std::vector<std::string>>;

// Prints the three most frequent habits.
void print_habits(Habits habits, std::size_t goals) {
  for (int i = 0; i < 3 && !habits.empty(); ++i) {
    const auto most = std::max_element(
        habits.begin(), habits.end(),
        [](const auto& a, const auto& b) { return a.second.size() < b.second.size(); });
    std::cout << most->second.size() << " of " << goals << " goals: " << most->first << ": "
              << system::joined(most->second, ", ") << '\n';
    habits.erase(most);
  }
}

Result<int> run_coach(const CoachOptions& options) {
  if (options.records.size() > 1 && !options.all)
    return fail(Errc::input, "several records: give --all, which groups their goals");
  if (options.records.size() > 1 && !options.page.empty())
    return fail(Errc::input, "--output: a page shows the goals of one record");
  system::Disk disk;
  Habits habits;
  record::Json json{{"team", options.team}, {"goals", record::Json::array()}};
  for (const std::string& path : options.records) {
    MIROCUP_TRY(const auto record, record::load(disk, path));
    if (const auto differs = replay::verify(record.recording))
      return not_reproduced(path, record, *differs, "studied");
    MIROCUP_TRY(const auto cast, cast_of(options, record));
    const auto conceded = coach::goals_against(record.recording, cast.team).size();
    if (options.goal && static_cast<std::size_t>(*options.goal) > conceded)
      return fail(
          Errc::input,
          formatted("--goal %d: the team conceded %zu goals in ", *options.goal, conceded) + path);
    MIROCUP_TRY(const auto goals, coach::study_goals(record, cast, options.goal));
    const match::Setup& setup = record.recording.setup;
    std::vector<std::string> texts;
    for (const GoalStudy& goal : goals) {
      texts.push_back(text_of(goal, setup.control_period));
      json["goals"].push_back(json_of(goal, setup, path));
      habits[habit_of(goal, setup)].push_back(path + formatted(" goal %d", goal.number) +
                                              link_of(goal, setup.control_period));
    }
    const std::string others = text_of_others(record, goals);
    if (!options.all && !options.json && !goals.empty())
      std::cout << system::joined(texts, "") << others;
    if (options.page.empty()) continue;
    MIROCUP_TRY(const auto page, coach::page_of(record, cast, goals, texts, others));
    MIROCUP_TRY_VOID(disk.write(options.page, page));
  }
  if (options.json)
    print_json(json);
  else if (json["goals"].empty())
    std::cout << "The team conceded no goal.\n";
  else if (options.all)
    print_habits(habits, json["goals"].size());
  return exit_yes;
}

}  // namespace

void add_coach(system::Commands& commands) {
  const auto [command, o] = commands.add(
      run_coach, "coach", after_a_leg,
      "Find until when the goals against a team could have been prevented, and by which robot",
      {"mirocup coach leg.json --team blue",
       "mirocup coach leg.json --team blue --goal 2 --substitute mine.so --trusted",
       "mirocup coach leg.json --team blue -o goals.html",
       "mirocup coach --all legs/*.json --team mine"});
  command.option("RECORD", o.records, "Match record; several with --all").required();
  command.option("--team TEAM", o.team, "Team that conceded the goals: blue, yellow, or its name")
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
  command.flag("--all", o.all,
               "Group the goals of all records by who could prevent them, how early and where the "
               "ball was, and print the three most frequent groups");
  command.flag("--json", o.json, "Print the answer as one JSON object");
  command.option("-o,--output PAGE", o.page,
                 "Also write a page: each goal beside a future without it");
}

}  // namespace mirocup::app
