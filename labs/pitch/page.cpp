// SPDX-License-Identifier: MIT
#include "labs/pitch/page.hpp"

#include "system/text.hpp"
#include "web/design/template.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace mirocup::pitch {

namespace {

using system::formatted;

constexpr std::array<const char*, predictors> colours{"var(--c0)", "var(--c2)", "var(--c3)",
                                                      "var(--c1)"};

// Returns the names of the predictors of a validation. The last one is there only with a peer.
std::vector<std::string> labels_of(const Validation& v) {
  std::vector<std::string> labels{"simulator", "straight on", "paper's model"};
  if (!v.peer.empty()) labels.push_back(v.peer);
  return labels;
}

std::string page_with(const std::string& title, const std::string& body) {
  return "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n<meta "
         "name=\"viewport\" "
         "content=\"width=device-width\"><title>" +
         system::html_escaped(title) + "</title>\n<style>" +
         std::string(web::design_file("design.css")) +
         "main { max-width: 1000px; margin: 0 auto; padding: 1rem; }\n"
         "table { border-collapse: collapse; } td, th { padding: .2rem .7rem; text-align: right; "
         "border-bottom: 1px solid var(--line); } td:first-child, th:first-child { text-align: "
         "left; }\n.row { display: flex; flex-wrap: wrap; gap: 1rem; } figure { margin: 0; }\n"
         ".worse { color: var(--lost); font-weight: 600; }\n"
         "svg text { fill: var(--soft); font-size: 11px; }\n"
         "</style></head><body><main>\n<h1>" +
         system::html_escaped(title) + "</h1>\n" + body + "</main></body></html>\n";
}

std::string kind_text(EventKind kind) {
  std::string text(to_string(kind));
  std::replace(text.begin(), text.end(), '_', ' ');
  return text;
}

// The bar of an estimate: the interval as a share of its value.
std::string bar_of(const Estimate& e) {
  const double scale = std::max(
      {std::abs(e.high - e.value), std::abs(e.value - e.low), 0.05 * std::abs(e.value), 1e-12});
  const auto x = [&](double v) { return 100.0 + 90.0 * (v - e.value) / scale; };
  return formatted(
      "<svg width=\"200\" height=\"16\" role=\"img\" aria-label=\"interval\"><path "
      "d=\"M%.1f 8H%.1f\" stroke=\"var(--c0)\" stroke-width=\"3\"/><circle cx=\"100\" "
      "cy=\"8\" r=\"4\" fill=\"var(--c0)\"/></svg>",
      x(e.low), x(e.high));
}

// Where one body was seen and predicted, 300 pixels wide, as the paper's Figure 7 shows it.
std::string picture_of(const Track& track) {
  Vec2 low = track.seen.front(), high = low;
  const auto widen = [&](const std::vector<Vec2>& points) {
    for (const Vec2& p : points) {
      low = {std::min(low.x(), p.x()), std::min(low.y(), p.y())};
      high = {std::max(high.x(), p.x()), std::max(high.y(), p.y())};
    }
  };
  widen(track.seen);
  widen(track.predicted[0]);
  const double size = std::max({high.x() - low.x(), high.y() - low.y(), 0.05}) * 1.15;
  const Vec2 middle = 0.5 * (low + high);
  const auto at = [&](const Vec2& p) {
    return formatted("%.1f %.1f", 150.0 + 300.0 * (p.x() - middle.x()) / size,
                     150.0 - 300.0 * (p.y() - middle.y()) / size);
  };
  std::string svg =
      "<svg width=\"300\" height=\"300\" viewBox=\"0 0 300 300\" class=\"card\" "
      "role=\"img\" aria-label=\"recorded and predicted\">";
  for (int k = predictors - 1; k >= 0; --k) {
    std::string path;
    for (const Vec2& p : track.predicted[k]) path += (path.empty() ? "M" : "L") + at(p);
    svg += "<path d=\"" + path + "\" fill=\"none\" stroke-width=\"2\" stroke=\"" + colours[k] +
           (k == 0 ? "\"/>" : "\" stroke-dasharray=\"4 3\"/>");
  }
  for (const Vec2& p : track.seen) {
    const std::string centre = at(p);
    const std::size_t space = centre.find(' ');
    svg += "<circle cx=\"" + centre.substr(0, space) + "\" cy=\"" + centre.substr(space + 1) +
           "\" r=\"2.5\" fill=\"var(--ink)\"/>";
  }
  svg += formatted(
      "<path d=\"M10 288h%.1f\" stroke=\"var(--ink)\"/><text x=\"10\" y=\"282\">5 cm"
      "</text></svg>",
      300.0 * 0.05 / size);
  return "<figure>" + svg + "<figcaption class=\"small\">" + kind_text(track.kind) + ": " +
         track.body +
         formatted(" simulated from %.2f s on; off by %.1f mm at the end", track.t,
                   1e3 * track.error) +
         "</figcaption></figure>\n";
}

std::string colour_key(const std::vector<std::string>& labels) {
  std::string text = "<p class=\"small\">Dots: recorded. ";
  for (std::size_t k = 0; k < labels.size(); ++k) {
    text += "<span style=\"color:" + std::string(colours[k]) + "\">&#9632;</span> " +
            system::html_escaped(labels[k]) + " ";
  }
  return text + "</p>\n";
}

// Calls visit(name, estimate, note) for each number, known or not.
template <class Visit>
void for_each_result(const Identified& r, Visit visit) {
  for (int u = 0; u < unknown_count; ++u) {
    visit(std::string(unknowns()[u].name), r.known[u], r.why_not[u]);
  }
  visit("deceleration of the ball at 0.5 m/s",
        r.has_deceleration ? std::optional<Estimate>(r.deceleration) : std::nullopt,
        std::string("the recordings need a ball that rolls freely"));
  visit("camera's noise, position, m", std::optional<Estimate>(r.position_noise), std::string());
  visit("camera's noise, heading, rad", std::optional<Estimate>(r.heading_noise), std::string());
}

std::string summary_of(const Identified& r) {
  return formatted(
      "The search explains %d windows of half a second; it leaves out %d windows, because no "
      "motion explains them. A picture misses %.1f %% of the bodies; %.1f %% were seen at wrong "
      "places.",
      r.windows, r.unexplained, 100.0 * r.unseen, 100.0 * r.outliers);
}

}  // namespace

std::string page_of(const Identified& r, const std::string& title) {
  std::string body = "<p>" + summary_of(r) +
                     "</p>\n<table><tr><th>number</th><th>value</th><th>95 % "
                     "from</th><th>to</th><th></th></tr>\n";
  for_each_result(r, [&](const std::string& name, const std::optional<Estimate>& e,
                         const std::string& why) {
    body += "<tr><td>" + name + "</td>";
    if (e) {
      body += formatted("<td>%.5g</td><td>%.5g</td><td>%.5g</td><td>", e->value, e->low, e->high) +
              bar_of(*e) + "</td></tr>\n";
    } else {
      body += "<td colspan=\"4\">not known: " + system::html_escaped(why) + "</td></tr>\n";
    }
  });
  return page_with(title, body + "</table>\n");
}

std::string text_of_result(const Identified& r) {
  std::string text;
  for_each_result(
      r, [&](const std::string& name, const std::optional<Estimate>& e, const std::string& why) {
        text += formatted("%-36s", name.c_str());
        text += e ? formatted("%11.5g   %11.5g to %-11.5g\n", e->value, e->low, e->high)
                  : "   not known: " + why + "\n";
      });
  return text + summary_of(r) + "\n";
}

std::string page_of(const Validation& v, const std::string& title) {
  std::string body = formatted(
      "<p>Root mean square of the prediction's errors in mm, by the number of pictures ahead (one "
      "each %.4g s), without the camera's noise of %.2f mm. Errors of the simulator that are "
      "larger than a yardstick's are marked.</p>\n",
      v.period, 1e3 * v.noise);
  for (std::size_t kind = 0; kind < v.cells.size(); ++kind) {
    if (v.cells[kind].front().count + v.cells[kind].back().count == 0) continue;
    body += "<h2>" + kind_text(static_cast<EventKind>(kind)) +
            "</h2>\n<table><tr><th>pictures ahead</th>";
    for (const int h : horizons) body += formatted("<th>%d</th>", h);
    body += "</tr>\n";
    const std::vector<std::string> labels = labels_of(v);
    for (std::size_t k = 0; k < labels.size(); ++k) {
      body += "<tr><td>" + system::html_escaped(labels[k]) + "</td>";
      for (const ErrorCell& cell : v.cells[kind]) {
        const bool is_worse =
            k == 0 && std::any_of(cell.beats_simulator.begin(), cell.beats_simulator.end(),
                                  [](bool beats) { return beats; });
        body += is_worse ? "<td class=\"worse\">" : "<td>";
        body += cell.count == 0 ? "-" : formatted("%.1f", 1e3 * cell.rms[k]);
        body += "</td>";
      }
      body += "</tr>\n";
    }
    body += "<tr><td class=\"small\">predictions</td>";
    for (const ErrorCell& cell : v.cells[kind]) body += formatted("<td>%d</td>", cell.count);
    body += "</tr></table>\n";
  }
  body += "<h2>Where a yardstick is better</h2>\n<ul>\n";
  for (const std::string& o : v.objections) body += "<li>" + system::html_escaped(o) + "</li>\n";
  if (v.objections.empty()) body += "<li>nowhere in these recordings</li>\n";
  body += "</ul>\n<h2>Recorded and predicted</h2>\n" + colour_key(labels_of(v)) +
          "<div class=\"row\">\n";
  for (const Track& track : v.examples) body += picture_of(track);
  return page_with(title, body + "</div>\n");
}

std::string text_of_result(const Validation& v) {
  std::string text = formatted(
      "errors in mm, without the camera's noise of %.2f mm, by the number of pictures ahead (one "
      "picture each %.4g s): ",
      1e3 * v.noise, v.period);
  for (const int h : horizons) text += formatted("%d ", h);
  text += "\n";
  for (std::size_t kind = 0; kind < v.cells.size(); ++kind) {
    if (v.cells[kind].front().count + v.cells[kind].back().count == 0) continue;
    const std::vector<std::string> labels = labels_of(v);
    for (std::size_t k = 0; k < labels.size(); ++k) {
      text += formatted("%-18s%-14s", k == 0 ? kind_text(static_cast<EventKind>(kind)).c_str() : "",
                        labels[k].c_str());
      for (const ErrorCell& cell : v.cells[kind]) {
        text += cell.count == 0 ? "        -" : formatted("%9.2f", 1e3 * cell.rms[k]);
      }
      if (k == 0) {
        text += "   of";
        for (const ErrorCell& cell : v.cells[kind]) text += formatted(" %d", cell.count);
      }
      text += "\n";
    }
  }
  for (const std::string& o : v.objections) text += o + "\n";
  return text;
}

}  // namespace mirocup::pitch
