// SPDX-License-Identifier: MIT
#include "labs/tune/tuning_file.hpp"
#include "system/text.hpp"

#include <algorithm>

namespace mirocup::league {

namespace {

constexpr double plot_left = 70.0;  // px, of the plots
constexpr double plot_width = 520.0;
constexpr double plot_height = 110.0;
constexpr double plot_gap = 50.0;

std::string digits_of(double number) {
  return system::formatted("%.4g", number);
}

std::string pixel(double number) {
  return system::formatted("%.1f", number);
}

// A line with a band of twice `half_width` around it.
struct Plot {
  std::string title;
  double low = 0.0;  // of the axis
  double high = 1.0;
  std::vector<double> values;
  std::vector<double> half_width;
};

std::string text_at(double x, double y, const std::string& anchor, const std::string& text) {
  return "<text x=\"" + pixel(x) + "\" y=\"" + pixel(y) + "\" text-anchor=\"" + anchor + "\">" +
         text + "</text>\n";
}

std::string plot_svg(const Plot& plot, double top) {
  const double last = std::max<double>(static_cast<double>(plot.values.size()) - 1.0, 1.0);
  const double range = plot.high > plot.low ? plot.high - plot.low : 1.0;
  const auto point = [&](std::size_t i, double value) {
    const double y = plot_height * (plot.high - std::clamp(value, plot.low, plot.high)) / range;
    return pixel(plot_left + plot_width * static_cast<double>(i) / last) + "," + pixel(top + y) +
           " ";
  };
  std::string line;
  std::string band;
  for (std::size_t i = 0; i < plot.values.size(); ++i) {
    line += point(i, plot.values[i]);
    band += point(i, plot.values[i] + plot.half_width[i]);
  }
  for (std::size_t i = plot.values.size(); i-- > 0;) {
    band += point(i, plot.values[i] - plot.half_width[i]);
  }
  return text_at(plot_left, top - 8.0, "start", plot.title) +
         text_at(plot_left - 6.0, top + 10.0, "end", digits_of(plot.high)) +
         text_at(plot_left - 6.0, top + plot_height, "end", digits_of(plot.low)) + "<path d=\"M" +
         pixel(plot_left) + "," + pixel(top) + " v" + pixel(plot_height) + " h" +
         pixel(plot_width) + "\" class=\"axis\"/>\n<polygon points=\"" + band +
         "\" class=\"band\"/>\n" + "<polyline points=\"" + line + "\" class=\"line\"/>\n";
}

std::vector<Plot> plots_of(const TuningOptions& options, const std::vector<Generation>& course) {
  std::vector<Plot> plots(1);
  Plot& goals = plots.front();
  goals.title = "goal difference a leg, mean of the candidates; band: error of one candidate";
  for (const Generation& g : course) {
    goals.values.push_back(g.goals);
    goals.half_width.push_back(g.error);
    goals.low = std::min(goals.low, g.goals - g.error);
    goals.high = std::max(goals.high, g.goals + g.error);
  }
  for (std::size_t i = 0; i < options.parameters.size(); ++i) {
    const TunedParameter& p = options.parameters[i];
    Plot& plot = plots.emplace_back();
    plot.title = p.name + "; band: spread of the candidates";
    plot.low = p.low;
    plot.high = p.high;
    for (const Generation& g : course) {
      plot.values.push_back(g.mean[i]);
      plot.half_width.push_back(g.deviation[i]);
    }
  }
  return plots;
}

}  // namespace

std::string course_svg(const TuningOptions& options, const std::vector<Generation>& course) {
  const std::vector<Plot> plots = plots_of(options, course);
  const double total = static_cast<double>(plots.size()) * (plot_height + plot_gap) + plot_gap;
  std::string svg =
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " +
      pixel(plot_left + plot_width + 30.0) + " " + pixel(total) +
      "\" font-family=\"sans-serif\" font-size=\"12\">\n<style>.axis{fill:none;stroke:#888}"
      ".band{fill:#06c;opacity:.2}.line{fill:none;stroke:#06c;stroke-width:2}</style>\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n";
  double top = plot_gap * 0.7;
  for (const Plot& plot : plots) {
    svg += plot_svg(plot, top);
    top += plot_height + plot_gap;
  }
  return svg +
         text_at(plot_left + plot_width, top - plot_gap + 18.0, "end",
                 std::to_string(course.size()) + " generations") +
         "</svg>\n";
}

}  // namespace mirocup::league
