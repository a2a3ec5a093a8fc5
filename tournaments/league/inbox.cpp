// SPDX-License-Identifier: MIT
#include "tournaments/league/inbox.hpp"

#include "system/users.hpp"

#include <algorithm>
#include <array>
#include <map>

namespace mirocup::league {

namespace {

// A library, or a team in Python: the check tells them apart by what is in them.
constexpr std::array<std::string_view, 2> ends_of_entries{".so", ".py"};

struct Waiting {
  std::string path;
  std::string team;
  int turn = 0;  // the number of files of the same user before it
};

// Returns the users whose files are the host's own word; nobody if only the host can write there.
Result<std::vector<uid_t>> trusted_in(const std::string& inbox) {
  MIROCUP_TRY(const auto writers, system::writers_of(inbox));
  const std::vector<uid_t> host{0, system::this_user()};
  const bool is_the_hosts = std::find(host.begin(), host.end(), writers.owner) != host.end();
  if (is_the_hosts && !writers.others_write) return std::vector<uid_t>{};
  return std::vector<uid_t>{host[0], host[1], writers.owner};
}

// Returns the files of the inbox in the order in which they are taken.
Result<std::vector<Waiting>> waiting_in(system::Files& files, const std::string& inbox) {
  MIROCUP_TRY(const auto names, files.names_in(inbox));
  std::vector<Waiting> all;
  std::map<uid_t, int> turns;
  for (const std::string& name : names) {
    const auto end = std::find_if(ends_of_entries.begin(), ends_of_entries.end(),
                                  [&name](std::string_view e) { return name.ends_with(e); });
    if (end == ends_of_entries.end()) continue;
    const std::string path = inbox + "/" + name;
    const auto owner = system::owner_of(path);
    if (!owner && !files.exists(path)) continue;  // removed since
    if (!owner) return fail(Errc::unavailable, path + " cannot be examined");
    all.push_back(
        {.path = path, .team = name.substr(0, name.size() - end->size()), .turn = turns[*owner]++});
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const Waiting& a, const Waiting& b) { return a.turn < b.turn; });
  return all;
}

}  // namespace

Result<void> submit_inbox(system::Files& files, const Folder& folder, const std::string& inbox,
                          std::int64_t now, const InboxListener& tell, const Quota& quota) {
  MIROCUP_TRY(const auto trusted, trusted_in(inbox));
  MIROCUP_TRY(const auto all, waiting_in(files, inbox));
  for (const Waiting& file : all) {
    const std::string team = is_good_name(file.team) ? file.team : "";
    const auto done = submit(files, folder,
                             {.team = file.team,
                              .path = file.path,
                              .at = now,
                              .is_from_inbox = true,
                              .trusted = trusted},
                             quota);
    if (!done && done.error().code == Errc::interrupted) return tl::unexpected(done.error());
    if (!done || done->is_news) tell(file.path, team, done);
  }
  return {};
}

}  // namespace mirocup::league
