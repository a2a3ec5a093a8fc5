// SPDX-License-Identifier: MIT
#include "tournaments/handin/entries.hpp"

#include "record/json_reader.hpp"

#include <iterator>
#include <vector>

namespace mirocup::league {

namespace {

// A file of the host is shown as soon as it is an entry.
bool is_shown(const HandedIn& handed) {
  return handed.is_network || handed.is_kept();
}

}  // namespace

Result<Json> Entries::report(const std::string& team, int entry, bool is_whole) {
  HandedIn handed;
  int before = 0;
  CheckStep step;
  {
    const std::lock_guard lock(state_.mutex);
    const HandedIn* found = state_.book.hand_ins().find(team, entry);
    if (found == nullptr || !is_shown(*found)) return Json();
    handed = *found;
    before = state_.book.hand_ins().before(team, entry);
    if (const auto known = state_.steps.find({team, entry}); known != state_.steps.end())
      step = known->second;
  }
  MIROCUP_TRY(Json json, entry_report(state_.files, state_.folder, handed, before, step, is_whole));
  if (is_whole && state_.files.exists(state_.folder.gate_leg(team, entry)))
    json["replay"] = std::string(entry_pages_path) + std::to_string(entry) + "/replay";
  return json;
}

Result<Json> Entries::reports(const std::string& team, int before) {
  std::vector<int> numbers;  // the latest first, and one more, which says that there are older ones
  {
    const std::lock_guard lock(state_.mutex);
    const auto& known = state_.book.hand_ins().of_team(team);
    for (auto at = std::make_reverse_iterator(known.lower_bound(before));
         at != known.rend() && numbers.size() <= listed_entries; ++at) {
      if (is_shown(at->second)) numbers.push_back(at->first);
    }
  }
  Json page{{"team", team}, {"entries", Json::array()}, {"older", Json()}};
  if (numbers.size() > listed_entries) {
    numbers.pop_back();
    page["older"] = numbers.back();
  }
  for (const int number : numbers) {
    MIROCUP_TRY(Json one, report(team, number, false));
    page["entries"].push_back(std::move(one));
  }
  return page;
}

web::Reply Entries::events(const std::string& team, int entry) {
  web::Reply reply;
  reply.events = [this, team, entry, seen = std::uint64_t{0},
                  told = std::string()]() mutable -> web::EventBatch {
    const std::uint64_t version = state_.version;
    if (version == seen) return {};
    seen = version;
    const auto known = report(team, entry, true);
    if (!known) return {};
    const Json& now = *known;
    std::string text = "event: state\ndata: " + record::json_text(now) + "\n\n";
    if (text == told) return {};
    told = text;
    const auto state = from_string<HandInState>(record::text_in(now, "state"));
    return {std::move(text), !state || is_final(*state)};
  };
  return reply;
}

}  // namespace mirocup::league
