// SPDX-License-Identifier: MIT
#include "tournaments/handin/entry_report.hpp"

#include "record/json_reader.hpp"
#include "system/printable.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <vector>

namespace mirocup::league {

namespace {

using record::or_null;
using record::text_in;

constexpr std::string_view step_mark = "step ";
constexpr std::size_t shown_lines = 50;      // of the beginning of a log, and of its end
constexpr std::size_t shown_bytes = 16'384;  // of each

// Reads a number at the beginning of the text, and removes it.
std::optional<int> take_number(std::string_view& text) {
  int number = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
  if (read.ec != std::errc()) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(read.ptr - text.data()));
  return number;
}

CheckStep read_step(std::string_view line) {
  constexpr std::string_view of_mark = " of ";
  constexpr std::string_view name_mark = ": ";
  CheckStep step;
  const auto number = take_number(line);
  if (!number || !line.starts_with(of_mark)) return {};
  line.remove_prefix(of_mark.size());
  const auto of = take_number(line);
  if (!of || !line.starts_with(name_mark)) return {};
  step.number = *number;
  step.of = *of;
  step.name = line.substr(name_mark.size());
  return step;
}

// The verdict of an entry whose check has ended; null if there is none.
Result<Json> verdict_of(system::Files& files, const Folder& folder, const std::string& team,
                        int entry) {
  if (!files.exists(folder.entry_file(team, entry))) return Json();
  const std::string path = folder.verdict(team, entry);
  MIROCUP_TRY(const auto text, files.read_if_there(path, {.max_size = system::size_limit::note}));
  if (!text) return Json();
  return record::read_json<Json>(*text, path, Errc::damaged, [](const record::JsonReader& json) {
    return json.expect_object() ? json.json() : Json();
  });
}

// Returns what follows the reason of a refusal in its message: "entry 10 plays on".
std::string plays_on(const std::string& message, const std::string& reason) {
  const std::size_t at = message.find(reason);
  const std::size_t end = at == std::string::npos ? at : at + reason.size() + 2;
  return end < message.size() ? message.substr(end) : "nothing changes";
}

// Returns the answer in lines: what was wrong, where, what to do and what plays; of a good entry
// the scores of its legs.
Json told_by(const Json& verdict, const std::string& plays) {
  Json lines = Json::array();
  if (!verdict.is_object()) return lines;
  for (const Json& check : verdict.value("checks", Json::array())) {
    if (text_in(check, "what").empty()) continue;
    return {"What: " + text_in(check, "what"), "Where: " + text_in(check, "where"),
            "Do: " + text_in(check, "cure"), "Plays: " + plays};
  }
  for (const Json& leg : verdict.value("legs", Json::array())) {
    const Json score = leg.value("score", Json::array());
    if (score.size() != 2) continue;
    const int own_goals = leg.value("own_goals", 0);
    lines.push_back(score[0].dump() + " : " + score[1].dump() + " against " +
                    text_in(leg, "opponent") + " as " + text_in(leg, "colour") +
                    (own_goals > 0 ? ", own goals: " + std::to_string(own_goals) : ""));
  }
  return lines;
}

}  // namespace

CheckStep last_step(std::string_view output) {
  // A line without its end is still being written.
  const std::size_t end = output.rfind('\n');
  if (end == std::string_view::npos) return {};
  output = output.substr(0, end);
  while (true) {
    const std::size_t begin = output.rfind('\n');
    const std::string_view line =
        begin == std::string_view::npos ? output : output.substr(begin + 1);
    if (line.starts_with(step_mark)) return read_step(line.substr(step_mark.size()));
    if (begin == std::string_view::npos) return {};
    output = output.substr(0, begin);
  }
}

Result<Json> entry_report(system::Files& files, const Folder& folder, const std::string& team,
                          int entry, const WaitingHandIn* waiting, int before,
                          const CheckStep& step, bool is_whole) {
  const bool is_stored = files.exists(folder.entry_file(team, entry));
  if (waiting == nullptr && !is_stored) return Json();
  Json report{{"entry", entry}, {"team", team}};
  if (waiting != nullptr && !is_final(waiting->state)) {
    report["state"] = to_string(waiting->state);
    report["reason"] = Json();
    report["message"] = Json();
  } else {
    const auto read = verdict_of(files, folder, team, entry);
    if (!read) return read;
    const Json& verdict = *read;
    MIROCUP_TRY(const auto is_accepted, is_accepted_entry(files, folder, team, entry));
    report["state"] = to_string(waiting != nullptr         ? waiting->state
                                : is_stored && is_accepted ? HandInState::accepted
                                                           : HandInState::refused);
    const std::string message = waiting != nullptr ? waiting->message : "";
    const std::string reason = text_in(verdict, "reason");
    const bool has_reason = report["state"] != to_string(HandInState::accepted);
    report["reason"] = has_reason ? or_null(reason.empty() ? message : reason) : Json();
    report["message"] = or_null(message);
    if (has_reason) report["plays"] = plays_on(message, reason);
    report["told"] = told_by(verdict, report.value("plays", ""));
    if (is_whole && verdict.is_object()) {
      for (const char* key : {"checks", "notes", "timing", "peak_memory_bytes", "isolation"}) {
        if (verdict.contains(key)) report[key] = verdict[key];
      }
      report["log"] = shortened(text_in(verdict, "log"));
    }
  }
  if (waiting == nullptr) return report;
  report["file"] = waiting->file;
  report["sha256"] = waiting->sha256;
  report["bytes"] = waiting->bytes;
  report["handed_in"] = utc_text(waiting->at);
  if (waiting->state == HandInState::queued) report["before"] = before;
  if (waiting->state == HandInState::checking) {
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
