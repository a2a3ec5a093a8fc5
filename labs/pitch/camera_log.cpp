// SPDX-License-Identifier: MIT
#include "labs/pitch/camera_log.hpp"

#include "core/base/math.hpp"
#include "core/base/random.hpp"
#include "core/field/field.hpp"
#include "core/replay/playback.hpp"
#include "record/json_reader.hpp"
#include "system/files.hpp"
#include "system/number_of.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace mirocup::pitch {

namespace {

using record::JsonReader;
using Json = nlohmann::ordered_json;

constexpr std::string_view recording_schema = "mirocup/recording/1";
constexpr double max_length = 100.0;  // m
constexpr double max_time = 1e7;      // s
constexpr double max_speed = 1e6;     // rad/s
constexpr double max_angle = 1e6;     // rad
constexpr std::size_t max_columns = 1 + 2 + 2 * 5 * max_robots_per_team;

Error too_many_pictures(const std::string& where, std::size_t most) {
  return {Errc::input, where + ": a recording has at most " + std::to_string(most) +
                           " pictures; cut it into several files"};
}

RobotLeague league_of(int robots) {
  return robots <= 3 ? RobotLeague::small : robots <= 5 ? RobotLeague::middle : RobotLeague::large;
}

// The first line.
void read_header(const JsonReader& json, CameraLog& recording) {
  if (!json.expect_object({"schema", "period", "robots", "pitch", "league"})) return;
  json.expect_schema(recording_schema);
  recording.robots = json.at("robots").integer<int>(0, max_robots_per_team);
  recording.league = league_of(recording.robots);
  json.read_if_present("league", recording.league);
  if (const auto period = json.find("period")) recording.period = period->number(1e-4, 10.0);
  if (const auto pitch = json.find("pitch")) {
    recording.pitch = pitch->is_string() ? pitch->text() : pitch->at("name").text();
  }
}

std::optional<SeenPose> read_pose(const JsonReader& json) {
  if (json.is_null() || !json.expect_array(3, 3)) return std::nullopt;
  return SeenPose{
      {json.at(0).number(-max_length, max_length), json.at(1).number(-max_length, max_length)},
      json.at(2).number(-max_angle, max_angle)};
}

void read_commands(const JsonReader& json, int robots, Frame& frame) {
  if (!json.expect_object({"blue", "yellow"})) return;
  for (const Team team : both_teams) {
    const auto given = json.find(std::string(to_string(team)));
    if (!given) continue;
    for (const JsonReader& wheels : given->elements(0, static_cast<std::size_t>(robots))) {
      if (!wheels.expect_array(2, 2)) return;
      frame.commands[index_of(team)].push_back(
          {wheels.at(0).number(-max_speed, max_speed), wheels.at(1).number(-max_speed, max_speed)});
    }
    frame.commands[index_of(team)].resize(static_cast<std::size_t>(robots));
  }
}

Frame read_frame(const JsonReader& json, int robots) {
  Frame frame;
  if (!json.expect_object({"t", "ball", "blue", "yellow", "commands"})) return frame;
  frame.t = json.at("t").number(-max_time, max_time);
  if (const auto ball = json.find("ball"); ball && ball->expect_array(2, 2)) {
    frame.ball = Vec2{ball->at(0).number(-max_length, max_length),
                      ball->at(1).number(-max_length, max_length)};
  }
  for (const Team team : both_teams) {
    auto& seen = frame.robots[index_of(team)];
    if (const auto given = json.find(std::string(to_string(team)))) {
      for (const JsonReader& pose : given->elements(0, static_cast<std::size_t>(robots))) {
        seen.push_back(read_pose(pose));
      }
    }
    seen.resize(static_cast<std::size_t>(robots));
  }
  if (const auto commands = json.find("commands")) read_commands(*commands, robots, frame);
  return frame;
}

// Calls visit(line, number) for each line that is not empty; stops when it returns false.
template <class Visit>
void for_each_line(std::string_view text, Visit visit) {
  int number = 0;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    ++number;
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    if (line.find_first_not_of(" \t") == std::string_view::npos) continue;
    if (!visit(line, number)) return;
  }
}

Result<CameraLog> checked(CameraLog recording) {
  std::stable_sort(recording.frames.begin(), recording.frames.end(),
                   [](const Frame& a, const Frame& b) { return a.t < b.t; });
  if (recording.frames.size() < 2) {
    return fail(Errc::input, recording.path + ": a recording has at least two pictures");
  }
  return recording;
}

}  // namespace

double CameraLog::usual_period() const {
  std::vector<double> steps;
  for (std::size_t i = 1; i < frames.size(); ++i) {
    if (const double step = frames[i].t - frames[i - 1].t; step > 0.0) steps.push_back(step);
  }
  if (steps.empty()) return period.value_or(0.033);
  std::nth_element(steps.begin(), steps.begin() + steps.size() / 2, steps.end());
  return steps[steps.size() / 2];
}

Result<CameraLog> parse_recording(std::string_view text, const std::string& path,
                                  std::size_t most_pictures) {
  CameraLog recording;
  recording.path = path;
  std::optional<Error> error;
  bool is_first = true;
  for_each_line(text, [&](std::string_view line, int number) {
    const std::string where = path + ", line " + std::to_string(number);
    const auto read =
        record::read_json<bool>(line, where, Errc::input, [&](const JsonReader& json) {
          if (is_first) {
            read_header(json, recording);
          } else {
            recording.frames.push_back(read_frame(json, recording.robots));
          }
          return true;
        });
    is_first = false;
    if (!read) {
      error = read.error();
    } else if (recording.frames.size() > most_pictures) {
      error = too_many_pictures(where, most_pictures);
    }
    return !error.has_value();
  });
  if (error) return tl::unexpected(*error);
  if (is_first) return fail(Errc::input, path + ": it is empty");
  return checked(std::move(recording));
}

namespace {

// Stops behind the first field that is too many.
std::vector<std::string> fields_of(std::string_view line) {
  std::vector<std::string> fields(1);
  for (const char c : line) {
    if (c == ',') {
      if (fields.size() > max_columns) break;
      fields.emplace_back();
    } else if (c != ' ' && c != '\t') {
      fields.back() += c;
    }
  }
  return fields;
}

// A column: of a robot, or of the ball (team "ball").
struct Column {
  std::string team;
  int robot = 0;
  std::string what;  // x, y, heading, left, right; t
};

std::optional<Column> column_of(const std::string& name) {
  if (name == "t") return Column{"", 0, "t"};
  if (name == "ball_x" || name == "ball_y") return Column{"ball", 0, name.substr(5)};
  for (const std::string team : {"blue", "yellow"}) {
    if (!name.starts_with(team)) continue;
    const std::size_t bar = name.find('_');
    if (bar == std::string::npos) return std::nullopt;
    const auto robot = system::number_of<int>(name.substr(team.size(), bar - team.size()));
    Column column{team, robot.value_or(-1), name.substr(bar + 1)};
    const bool is_known = column.what == "x" || column.what == "y" || column.what == "heading" ||
                          column.what == "left" || column.what == "right";
    if (column.robot < 0 || column.robot >= max_robots_per_team || !is_known) return std::nullopt;
    return column;
  }
  return std::nullopt;
}

// The numbers of one line by team, robot and name.
using Cells = std::map<std::string, double>;

Frame frame_of(const Cells& cells, int robots) {
  const auto cell = [&](const std::string& key) -> std::optional<double> {
    const auto found = cells.find(key);
    return found == cells.end() ? std::nullopt : std::optional<double>(found->second);
  };
  Frame frame;
  frame.t = cell("0t").value_or(0.0);
  if (const auto x = cell("ball0x"), y = cell("ball0y"); x && y) frame.ball = Vec2{*x, *y};
  for (const Team team : both_teams) {
    const int i = index_of(team);
    frame.robots[i].resize(robots);
    for (int r = 0; r < robots; ++r) {
      const std::string who = std::string(to_string(team)) + std::to_string(r);
      const auto x = cell(who + "x"), y = cell(who + "y"), heading = cell(who + "heading");
      if (x && y && heading) frame.robots[i][r] = SeenPose{{*x, *y}, *heading};
      const auto left = cell(who + "left"), right = cell(who + "right");
      if (!left || !right) continue;
      frame.commands[i].resize(robots);
      frame.commands[i][r] = {*left, *right};
    }
  }
  return frame;
}

}  // namespace

Result<CameraLog> parse_csv(std::string_view text, const std::string& path,
                            std::size_t most_pictures) {
  CameraLog recording;
  recording.path = path;
  std::vector<Column> columns;
  std::optional<Error> error;
  for_each_line(text, [&](std::string_view line, int number) {
    const std::string where = path + ", line " + std::to_string(number) + ": ";
    const std::vector<std::string> fields = fields_of(line);
    if (columns.empty()) {
      for (const std::string& name : fields) {
        const auto column = column_of(name);
        if (!column) {
          error = Error{Errc::input, where + "there is no column \"" + name.substr(0, 40) +
                                         "\"; names are t, ball_x, blue0_x, yellow1_heading, "
                                         "blue0_left, …"};
          return false;
        }
        if (column->team != "ball")
          recording.robots = std::max(recording.robots, column->robot + 1);
        columns.push_back(*column);
      }
      if (columns.size() > max_columns) {
        error = Error{Errc::input, where + "at most " + std::to_string(max_columns) +
                                       " columns are expected, one for each name"};
        return false;
      }
      return true;
    }
    if (fields.size() != columns.size()) {
      error = Error{Errc::input, where + std::to_string(columns.size()) +
                                     " fields are expected, not " + std::to_string(fields.size())};
      return false;
    }
    Cells cells;
    for (std::size_t i = 0; i < fields.size(); ++i) {
      if (fields[i].empty()) continue;
      const auto value = system::number_of<double>(fields[i]);
      if (!value) {
        error = Error{Errc::input, where + "\"" + fields[i].substr(0, 40) + "\" is no number"};
        return false;
      }
      cells[columns[i].team + std::to_string(columns[i].robot) + columns[i].what] = *value;
    }
    recording.frames.push_back(frame_of(cells, recording.robots));
    if (recording.frames.size() > most_pictures)
      error = too_many_pictures(path + ", line " + std::to_string(number), most_pictures);
    return !error.has_value();
  });
  if (error) return tl::unexpected(*error);
  recording.league = league_of(recording.robots);
  return checked(std::move(recording));
}

Result<CameraLog> read_recording(const std::string& path) {
  MIROCUP_TRY(const auto text, system::Disk().read_named(path, std::uint64_t{256} << 20));
  return path.ends_with(".csv") ? parse_csv(text, path) : parse_recording(text, path);
}

std::string print_recording(const CameraLog& recording) {
  std::string text =
      record::json_text(Json{{"schema", recording_schema},
                             {"period", recording.period ? Json(*recording.period) : Json()},
                             {"robots", recording.robots},
                             {"pitch", recording.pitch.empty() ? Json() : Json(recording.pitch)},
                             {"league", to_string(recording.league)}}) +
      "\n";
  for (const Frame& frame : recording.frames) {
    Json line{{"t", frame.t}};
    line["ball"] = frame.ball ? Json{frame.ball->x(), frame.ball->y()} : Json();
    Json commands = Json::object();
    for (const Team team : both_teams) {
      const std::string name(to_string(team));
      Json& poses = line[name] = Json::array();
      for (const auto& pose : frame.robots[index_of(team)]) {
        poses.push_back(pose ? Json{pose->position.x(), pose->position.y(), pose->heading}
                             : Json());
      }
      if (frame.commands[index_of(team)].empty()) continue;
      for (const auto& w : frame.commands[index_of(team)]) {
        commands[name].push_back(Json{w.left, w.right});
      }
    }
    if (!commands.empty()) line["commands"] = commands;
    text += record::json_text(line) + "\n";
  }
  return text;
}

namespace {

// Returns a normally distributed number (Box and Muller).
double normal(Random& random) {
  const double u = 1.0 - random.uniform();
  return std::sqrt(-2.0 * std::log(u)) * std::cos(2.0 * pi * random.uniform());
}

}  // namespace

void look_through(const CameraNoise& noise, CameraLog& recording) {
  Random random(noise.seed);
  const field::Field field = field::make_field(recording.league);
  const auto anywhere = [&] {
    return Vec2{random.uniform(-field.half_length, field.half_length),
                random.uniform(-field.half_width, field.half_width)};
  };
  const auto noisy = [&](const Vec2& at) {
    const double x = at.x() + noise.position * normal(random);
    return Vec2{x, at.y() + noise.position * normal(random)};
  };
  for (Frame& frame : recording.frames) {
    if (frame.ball) {
      const double lot = random.uniform();
      const Vec2 seen = lot < noise.outliers ? anywhere() : noisy(*frame.ball);
      frame.ball = lot >= 1.0 - noise.gaps ? std::nullopt : std::optional<Vec2>(seen);
    }
    for (auto& team : frame.robots) {
      for (auto& pose : team) {
        if (!pose) continue;
        const double lot = random.uniform();
        if (lot < noise.outliers) {
          pose = SeenPose{anywhere(), random.uniform(-pi, pi)};
        } else {
          pose->position = noisy(pose->position);
          pose->heading += noise.heading * normal(random);
        }
        if (lot >= 1.0 - noise.gaps) pose.reset();
      }
    }
  }
}

namespace {

Frame frame_of(const match::Leg& leg, const match::ByTeam<match::DrivenCommand>& answers,
               bool drives) {
  const match::Snapshot now = leg.snapshot();
  const int robots = leg.field().robots_per_team;
  Frame frame;
  frame.t = now.time;
  frame.ball = now.ball.position;
  for (int team = 0; team < 2; ++team) {
    for (int i = 0; i < robots; ++i) {
      const match::ObservedRobot& robot = now.robots[team][i];
      frame.robots[team].push_back(SeenPose{robot.position, robot.heading});
      frame.commands[team].push_back(drives ? answers[team].speeds(i)
                                            : simulator::WheelSpeeds{0.0, 0.0});
    }
  }
  return frame;
}

}  // namespace

Result<CameraLog> as_seen(const replay::Recording& leg, const std::string& path) {
  replay::Playback playback(leg);
  CameraLog recording;
  recording.path = path;
  recording.league = leg.setup.league;
  recording.robots = playback.leg().field().robots_per_team;
  recording.period = leg.setup.control_period;
  recording.pitch = leg.setup.pitch_name;
  do {
    // Answers take effect one tick later.
    const bool drives = playback.leg().snapshot().state == match::State::PLAY;
    recording.frames.push_back(frame_of(playback.leg(), playback.leg().answers(), drives));
  } while (!playback.leg().is_over() && playback.advance());
  if (const auto& other = playback.divergence()) {
    return fail(Errc::damaged, path + ": it cannot be played again: tick " +
                                   std::to_string(other->tick) + ": " + other->what);
  }
  return recording;
}

}  // namespace mirocup::pitch
