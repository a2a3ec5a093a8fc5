// SPDX-License-Identifier: MIT
#include "tournaments/handin/entries.hpp"

#include "record/json_reader.hpp"

#include <algorithm>
#include <set>

namespace mirocup::league {

Result<Json> Entries::report(const std::string& team, int entry, bool is_whole) {
  std::optional<WaitingHandIn> waiting;
  int before = 0;
  CheckStep step;
  {
    const std::lock_guard lock(state_.mutex);
    if (const WaitingHandIn* found = state_.book.queue().find(team, entry)) waiting = *found;
    before = waiting ? state_.book.queue().before(team, entry) : 0;
    if (const auto found = state_.steps.find({team, entry}); found != state_.steps.end())
      step = found->second;
  }
  const WaitingHandIn* known = waiting ? &*waiting : nullptr;
  auto json = entry_report(state_.files, state_.folder, team, entry, known, before, step, is_whole);
  if (is_whole && json && !json->is_null() &&
      state_.files.exists(state_.folder.gate_leg(team, entry)))
    (*json)["replay"] = std::string(entry_pages_path) + std::to_string(entry) + "/replay";
  return json;
}

Result<Json> Entries::reports(const std::string& team, int before) {
  MIROCUP_TRY(const auto stored, entries_of(state_.files, state_.folder, team));
  std::set<int> numbers(stored.begin(), std::lower_bound(stored.begin(), stored.end(), before));
  {
    const std::lock_guard lock(state_.mutex);
    // One more, which says that there are older ones.
    for (const auto* handed : state_.book.queue().latest_of(team, listed_entries + 1, before))
      numbers.insert(handed->entry);
  }
  Json page{{"team", team}, {"entries", Json::array()}, {"older", Json()}};
  for (auto number = numbers.rbegin(); number != numbers.rend(); ++number) {
    if (page["entries"].size() == listed_entries) {
      page["older"] = *std::prev(number);
      break;
    }
    MIROCUP_TRY(Json one, report(team, *number, false));
    if (!one.is_null()) page["entries"].push_back(std::move(one));
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
