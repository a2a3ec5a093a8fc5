// SPDX-License-Identifier: MIT
#include "web/picture.hpp"

#include "web/markings.hpp"
#include "web/page_parts.hpp"

#include <cmath>
#include <numbers>
#include <string_view>

namespace mirocup::web {

namespace {

constexpr double margin = 0.04;   // m of wall around the floor
constexpr double max_lift = 0.2;  // m; a ball that moves further in a tick was placed

std::string attribute(std::string_view name, const std::string& value) {
  return " " + std::string(name) + "=\"" + value + "\"";
}

std::string path_element(const std::string& css_class, const std::string& data) {
  return "<path" + attribute("class", css_class) + attribute("d", data) + "/>\n";
}

std::string translated(const Vec2& position) {
  return "translate(" + millimetres(position.x()) + " " + millimetres(-position.y()) + ")";
}

std::string robot(Team team, int number, const match::ObservedRobot& state, double side) {
  const std::string half = millimetres(-side / 2.0);
  const std::string edge = millimetres(side);
  const std::string degrees =
      std::to_string(-std::lround(state.heading * 180.0 / std::numbers::pi));
  // A bright strip along the front edge shows the heading.
  const double front = side / 2.0;
  const std::string strip = SvgPath()
                                .polygon({{0.60 * front, 0.72 * front},
                                          {0.86 * front, 0.72 * front},
                                          {0.86 * front, -0.72 * front},
                                          {0.60 * front, -0.72 * front}})
                                .text();
  return "<g" + attribute("class", "robot " + std::string(to_string(team))) +
         attribute("transform", translated(state.position)) + "><g" +
         attribute("transform", "rotate(" + degrees + ")") + "><rect" + attribute("x", half) +
         attribute("y", half) + attribute("width", edge) + attribute("height", edge) +
         attribute("rx", millimetres(side / 8.0)) + "/>" + path_element("front", strip) +
         "</g><text" + attribute("dy", millimetres(side / 5.0)) + ">" + std::to_string(number) +
         "</text></g>\n";
}

std::string trail(const Moment& moment) {
  SvgPath path;
  std::vector<Vec2> points = moment.trail;
  points.push_back(moment.scene.ball.position);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool goes_on = i > 0 && (points[i] - points[i - 1]).norm() < max_lift;
    goes_on ? path.line_to(points[i]) : path.move_to(points[i]);
  }
  return path_element("trail", path.text());
}

}  // namespace

std::string picture_style() {
  return "<style>\n" + std::string(asset("picture.css")) + "</style>\n";
}

std::string picture(const field::Field& field, const simulator::Parameters& parameters,
                    const Moment& moment) {
  const double width = 2.0 * (field.half_length + field.goal_depth + margin);
  const double height = 2.0 * (field.half_width + margin);
  const Markings marks = markings(field);
  std::string svg =
      "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" aria-label=\"Field\"" +
      attribute("class", "field") +
      attribute("viewBox", millimetres(-width / 2.0) + " " + millimetres(-height / 2.0) + " " +
                               millimetres(width) + " " + millimetres(height)) +
      ">\n" + picture_style();
  svg += "<rect class=\"wall\"" + attribute("x", millimetres(-width / 2.0)) +
         attribute("y", millimetres(-height / 2.0)) + attribute("width", millimetres(width)) +
         attribute("height", millimetres(height)) + "/>\n";
  svg += path_element("ground", marks.ground);
  for (const End end : both_ends) {
    const Team defender = end == End::left ? moment.scene.left : opponent_of(moment.scene.left);
    svg +=
        path_element("goal " + std::string(to_string(end)) + " " + std::string(to_string(defender)),
                     marks.goals[index_of(end)]);
  }
  svg += path_element("lines", marks.lines) + path_element("spots", marks.spots);
  svg += trail(moment);
  for (const Team team : both_teams) {
    for (int i = 0; i < field.robots_per_team; ++i) {
      svg += robot(team, i, moment.scene.robots[index_of(team)][i], parameters.robot_side);
    }
  }
  svg += "<circle class=\"ball\"" + attribute("r", millimetres(parameters.ball_radius)) +
         attribute("transform", translated(moment.scene.ball.position)) + "/>\n</svg>\n";
  return svg;
}

std::string picture(const match::Leg& leg) {
  return picture(leg.field(), leg.setup().parameters, {leg.snapshot(), {}});
}

}  // namespace mirocup::web
