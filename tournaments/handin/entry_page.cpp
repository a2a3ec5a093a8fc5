// SPDX-License-Identifier: MIT
#include "record/json_fields.hpp"
#include "tournaments/handin/team_desk_page.hpp"
#include "tournaments/publish/page_values.hpp"

namespace mirocup::league {

namespace {

void add_word(Json& check) {
  const Json passed = check.contains("passed") ? check["passed"] : Json();
  check["word"] = !passed.is_boolean() ? "not reached" : passed == true ? "ok" : "no";
  check["style"] = !passed.is_boolean() ? "small" : passed == true ? "accepted" : "refused";
}

Json timing_rows(const Json& entry) {
  const Json& timing = entry["timing"];
  constexpr double bytes_in_mib = 1 << 20;
  const Json memory{{"memory", record::value_in(entry, "peak_memory_bytes", 0.0) / bytes_in_mib}};
  Json rows;
  for (const auto& [what, value] : {
           std::pair("Slowest tick", number_text(timing, "slowest_tick_ms", "%.2f ms")),
           std::pair("Mean tick", number_text(timing, "mean_tick_ms", "%.3f ms")),
           std::pair("Start", number_text(timing, "start_ms", "%.1f ms")),
           std::pair("Memory", number_text(memory, "memory", "%.0f MiB")),
       })
    rows.push_back({{"what", what}, {"value", value}});
  return rows;
}

}  // namespace

std::string entry_page(const Json& entry, PortalLeague& league, const std::string& root,
                       bool is_for_staff) {
  Json values = entry;
  values["root"] = root;
  values["query"] = is_for_staff ? "?team=" + text_in(entry, "team") : "";
  if (entry.contains("replay")) values["replay"] = root + text_in(entry, "replay").substr(1);
  const std::string message = text_in(entry, "message");
  values["answer"] = message.empty() ? text_in(entry, "reason") : message;
  values["when"] = league.time_in_words(text_in(entry, "handed_in"));
  values["has_checks"] = entry.contains("checks");
  if (entry.contains("checks"))
    for (Json& check : values["checks"])
      if (check.is_object()) add_word(check);
  if (entry.contains("timing")) values["times"] = {{"rows", timing_rows(entry)}};
  return desk_page("Entry " + number_text(entry, "entry", "%.0f"),
                   filled_page("entry.html", values), root);
}

}  // namespace mirocup::league
