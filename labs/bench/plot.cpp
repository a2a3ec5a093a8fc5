// SPDX-License-Identifier: MIT
//
// Work-precision plots: error upwards, cost to the right, both logarithmic; a line for each engine.
#include "labs/bench/report.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace mirocup::bench {

namespace {

constexpr double panel_width = 380.0, panel_height = 320.0;
constexpr double left = 62.0, right = 14.0, top = 34.0, bottom = 46.0;
constexpr int columns = 2;
constexpr double least_error = 1e-9;  // in the plot's unit; below, it is rounding

struct Style {
  const char* engine;
  const char* colour;
};
constexpr Style styles[] = {{"mirocup", "#c2185b"},
                            {"Box2D, all bullets", "#1565c0"},
                            {"Box2D, ball bullet", "#64b5f6"},
                            {"Chipmunk", "#2e7d32"},
                            {"ODE", "#ef6c00"},
                            {"MuJoCo", "#6d4c41"}};

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f", value);
  return text;
}

std::string power(int exponent) {
  if (exponent >= -2 && exponent <= 3) {
    char text[32];
    std::snprintf(text, sizeof text, "%g", std::pow(10.0, exponent));
    return text;
  }
  return "10<tspan dy=\"-4\" font-size=\"8\">" + std::to_string(exponent) + "</tspan>";
}

std::string text(double x, double y, const char* anchor, const std::string& content) {
  return "<text x=\"" + number(x) + "\" y=\"" + number(y) + "\" text-anchor=\"" + anchor + "\">" +
         content + "</text>\n";
}

std::string line(double x1, double y1, double x2, double y2) {
  return "<line x1=\"" + number(x1) + "\" y1=\"" + number(y1) + "\" x2=\"" + number(x2) +
         "\" y2=\"" + number(y2) + "\" stroke=\"#ddd\"/>\n";
}

// A range of whole decades that holds all values, and the place of a value in it.
class Scale {
 public:
  Scale(const std::vector<double>& values, double begin, double end) : begin_(begin), end_(end) {
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    low_ = static_cast<int>(std::floor(std::log10(*least)));
    high_ = std::max(low_ + 1, static_cast<int>(std::ceil(std::log10(*most))));
  }
  int low() const { return low_; }
  int high() const { return high_; }
  double at(double value) const {
    return begin_ + (std::log10(value) - low_) / (high_ - low_) * (end_ - begin_);
  }

 private:
  double begin_, end_;
  int low_ = 0, high_ = 1;
};

struct Point {
  const Row* row;
  double cost, error;
};

std::string panel(const Report& report, const Plot& plot) {
  std::vector<Point> points;
  std::vector<double> costs, errors;
  for (const Row& row : report.rows) {
    const double error = std::max(least_error, plot.error(report, row) / plot.error_unit);
    points.push_back({&row, report.cost(row, plot.scene), error});
    costs.push_back(points.back().cost);
    errors.push_back(error);
  }
  const Scale x(costs, left, panel_width - right);
  const Scale y(errors, panel_height - bottom, top);
  std::string svg =
      "<text x=\"" + number(left) + "\" y=\"20\" font-weight=\"bold\">" + plot.title + "</text>\n";
  for (int e = x.low(); e <= x.high(); ++e) {
    const double at = x.at(std::pow(10.0, e));
    svg += line(at, top, at, panel_height - bottom) +
           text(at, panel_height - bottom + 14.0, "middle", power(e));
  }
  const int every = y.high() - y.low() > 6 ? 2 : 1;
  for (int e = y.low(); e <= y.high(); e += every) {
    const double at = y.at(std::pow(10.0, e));
    svg += line(left, at, panel_width - right, at) + text(left - 5.0, at + 4.0, "end", power(e));
  }
  svg += text((left + panel_width) / 2.0, panel_height - 12.0, "middle", "microseconds a tick");
  svg += "<text transform=\"translate(14 " + number((top + panel_height - bottom) / 2.0) +
         ") rotate(-90)\" text-anchor=\"middle\">" + plot.error_name + "</text>\n";
  for (const Style& style : styles) {
    std::string path, dots;
    for (const Point& p : points) {
      if (p.row->contender.engine != style.engine) continue;
      const std::string px = number(x.at(p.cost)), py = number(y.at(p.error));
      path += (path.empty() ? "M" : "L") + px + " " + py;
      dots += "<circle cx=\"" + px + "\" cy=\"" + py + "\" r=\"3\" fill=\"" + style.colour +
              "\"><title>" + p.row->contender.engine + ", " + p.row->contender.point +
              "</title></circle>\n";
    }
    if (path.empty()) continue;
    svg += "<path d=\"" + path + "\" fill=\"none\" stroke=\"" + style.colour + "\"/>\n" + dots;
  }
  return svg;
}

std::string legend(const Report& report) {
  std::string svg =
      "<text x=\"" + number(left) + "\" y=\"20\" font-weight=\"bold\">Engines</text>\n";
  double y = 44.0;
  for (const Style& style : styles) {
    const bool is_there = std::any_of(report.rows.begin(), report.rows.end(), [&](const Row& row) {
      return row.contender.engine == style.engine;
    });
    if (!is_there) continue;
    svg += "<circle cx=\"" + number(left + 5.0) + "\" cy=\"" + number(y - 4.0) +
           "\" r=\"4\" fill=\"" + style.colour + "\"/>\n" +
           text(left + 16.0, y, "start", style.engine);
    y += 20.0;
  }
  y += 10.0;
  for (const char* note :
       {"A dot: a step of 0.5 to 33 ms; ours: a level of accuracy.",
        "Lower and further left is better.", "Errors of less than 1e-9 mm are drawn there."}) {
    svg += text(left, y, "start", note);
    y += 18.0;
  }
  return svg;
}

}  // namespace

std::string to_svg(const Report& report) {
  const std::size_t panels = plots().size() + 1;
  const auto place = [](std::size_t i, const std::string& content) {
    return "<g transform=\"translate(" + number(static_cast<double>(i % columns) * panel_width) +
           " " + number(static_cast<double>(i / columns) * panel_height) + ")\">\n" + content +
           "</g>\n";
  };
  const double rows = static_cast<double>((panels + columns - 1) / columns);
  std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " +
                    number(columns * panel_width) + " " + number(rows * panel_height) +
                    "\" font-family=\"sans-serif\" font-size=\"11\">\n"
                    "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n";
  for (std::size_t i = 0; i < plots().size(); ++i) svg += place(i, panel(report, plots()[i]));
  return svg + place(plots().size(), legend(report)) + "</svg>\n";
}

}  // namespace mirocup::bench
