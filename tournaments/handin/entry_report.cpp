// SPDX-License-Identifier: MIT
#include "tournaments/handin/entry_report.hpp"

#include "record/json_fields.hpp"
#include "system/printable.hpp"
#include "tournaments/league/submission.hpp"

#include <algorithm>

namespace mirocup::league {

namespace {

using record::or_null;
using record::text_in;

constexpr std::size_t shown_lines = 50;      // of the beginning of a log, and of its end
constexpr std::size_t shown_bytes = 16'384;  // of each

// Returns the list at a key of an object; an empty list if the object has no such list.
const Json& list_in(const Json& object, const char* key) {
  static const Json none = Json::array();
  const auto found = object.find(key);
  return found != object.end() && found->is_array() ? *found : none;
}

// Returns the answer in lines: what was wrong, where, what to do and what plays; of a good entry
// the scores of its legs.
Json told_by(const Json& verdict, const std::string& plays) {
  Json lines = Json::array();
  if (!verdict.is_object()) return lines;
  for (const Json& check : list_in(verdict, "checks")) {
    if (text_in(check, "what").empty()) continue;
    return {"What: " + text_in(check, "what"), "Where: " + text_in(check, "where"),
            "Do: " + text_in(check, "cure"), "Plays: " + plays};
  }
  for (const Json& leg : list_in(verdict, "legs")) {
    const Json score = list_in(leg, "score");
    if (score.size() != 2) continue;
    const int own_goals = record::value_in(leg, "own_goals", 0);
    lines.push_back(score[0].dump() + " : " + score[1].dump() + " against " +
                    text_in(leg, "opponent") + " as " + text_in(leg, "colour") +
                    (own_goals > 0 ? ", own goals: " + std::to_string(own_goals) : ""));
  }
  return lines;
}

}  // namespace

std::optional<CheckStep> step_in(const Json& answer) {
  if (!answer.contains("step")) return std::nullopt;
  return CheckStep{.number = record::value_in(answer, "step", 0),
                   .of = record::value_in(answer, "of", 0),
                   .name = text_in(answer, "name")};
}

Result<Json> entry_report(system::Files& files, const Folder& folder, const HandedIn& handed,
                          int before, const CheckStep& step, bool is_whole) {
  Json report{{"entry", handed.entry}, {"team", handed.team}, {"state", to_string(handed.state)}};
  // The answer to a file of the host was told to the host.
  const std::string message = handed.is_network ? handed.message : "";
  if (!is_final(handed.state)) {
    report["reason"] = Json();
    report["message"] = Json();
  } else {
    MIROCUP_TRY(const Json verdict,
                handed.is_kept() ? read_verdict(files, folder, handed.team, handed.entry) : Json());
    const std::string reason = text_in(verdict, "reason");
    const bool has_reason = handed.state != HandInState::accepted;
    report["reason"] = has_reason ? or_null(reason.empty() ? message : reason) : Json();
    report["message"] = or_null(message);
    if (has_reason) {
      report["plays"] = handed.is_network && handed.plays > 0
                            ? "entry " + std::to_string(handed.plays) + " plays on"
                            : "nothing changes";
    }
    report["told"] = told_by(verdict, text_in(report, "plays"));
    if (is_whole && verdict.is_object()) {
      for (const char* key : {"checks", "notes", "timing", "peak_memory_bytes", "isolation"}) {
        if (verdict.contains(key)) report[key] = verdict[key];
      }
      report["log"] = shortened(text_in(verdict, "log"));
    }
  }
  if (!handed.is_network) return report;
  report["file"] = handed.file;
  report["sha256"] = handed.sha256;
  report["bytes"] = handed.bytes;
  report["handed_in"] = utc_text(handed.at);
  if (handed.is_late) report["late"] = true;
  if (handed.state == HandInState::queued) report["before"] = before;
  if (handed.state == HandInState::checking) {
    report["step"] = step.number == 0
                         ? Json()
                         : Json{{"number", step.number}, {"of", step.of}, {"name", step.name}};
  }
  return report;
}

std::string shortened(const std::string& log) {
  std::size_t first = 0;  // end of the beginning
  for (std::size_t line = 0; line < shown_lines && first != std::string::npos; ++line)
    first = log.find('\n', first == 0 ? 0 : first + 1);
  first = std::min({first, log.size(), shown_bytes});
  std::size_t last = log.size();  // begin of the end
  for (std::size_t line = 0; line < shown_lines && last != std::string::npos && last > 0; ++line)
    last = log.rfind('\n', last - 1);
  if (last == std::string::npos) last = 0;
  last = std::max(last, log.size() - std::min(log.size(), shown_bytes));
  if (last <= first) return system::printable(log, system::LineEnds::kept);
  return system::printable(log.substr(0, first), system::LineEnds::kept) + "\n[" +
         std::to_string(last - first) + " bytes are left out]\n" +
         system::printable(log.substr(last), system::LineEnds::kept);
}

}  // namespace mirocup::league
