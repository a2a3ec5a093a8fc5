// SPDX-License-Identifier: MIT
#include "tournaments/handin/uploads.hpp"

#include "system/printable.hpp"

#include <charconv>

namespace mirocup::league {

namespace {

constexpr std::string_view entries_path = "/api/v1/entries";
constexpr std::size_t max_file_name = 100;  // bytes

// Returns the name of a file without its folder, as it may be printed.
std::string file_name_of(const std::string& given) {
  const std::size_t slash = given.find_last_of("/\\");
  std::string name =
      system::printable(slash == std::string::npos ? given : given.substr(slash + 1));
  if (name.size() > max_file_name) {
    name.resize(max_file_name);
    name = system::printable(name);  // a character may have been cut
  }
  return name.empty() ? "strategy.so" : name;
}

std::string too_large() {
  return "the file is larger than " + std::to_string(system::size_limit::entry >> 20) + " MiB";
}

}  // namespace

tl::expected<void, Refusal> Uploads::expect_allowed(const std::string& team,
                                                    const HandInTerms& terms) {
  if (!terms.why_not.empty()) return refused(403, terms.why_not);
  const HandIns& hand_ins = state_.book.hand_ins();
  if (const int waiting = hand_ins.waiting(team); waiting >= state_.options.max_waiting)
    return refused(429,
                   std::to_string(waiting) + " files of " + team +
                       " wait for their checks; hand in again when one of these has its answer");
  const int most = state_.options.quota.tries_per_hour;
  if (hand_ins.tries_in_last_hour(team, state_.options.now()) < most) return {};
  return refused(
      429, team + " has had " + std::to_string(most) + " tries in the last hour; hand it in later");
}

// Counts an upload of a team while it lasts.
struct Uploads::Running {
  Uploads& uploads;
  const std::string& team;
  bool is_counted = false;

  // Requires the mutex of the state.
  bool begin() {
    int& running = uploads.running_[team];
    if (running >= uploads.state_.options.max_uploads) return false;
    ++running;
    return is_counted = true;
  }
  ~Running() {
    if (!is_counted) return;
    const std::lock_guard lock(uploads.state_.mutex);
    if (--uploads.running_[team] == 0) uploads.running_.erase(team);
  }
};

ReplyOrRefusal Uploads::take(const web::Request& request, const web::Body& body,
                             const std::string& team) {
  if (request.header("content-type").starts_with("multipart/"))
    return problem_reply(400, "this is a form (curl -F): send the file itself (curl -T FILE)");
  const std::string length = request.header("content-length");
  if (length == "0") return problem_reply(400, "the file is empty");
  std::uint64_t announced = 0;
  const auto read = std::from_chars(length.data(), length.data() + length.size(), announced);
  if (announced > system::size_limit::entry || read.ec == std::errc::result_out_of_range)
    return problem_reply(413, too_large());
  Running upload{*this, team};
  {
    const std::lock_guard lock(state_.mutex);
    MIROCUP_TRY_VOID(expect_allowed(team, state_.terms_of(team)).map_error(reply_to));
    if (!upload.begin())
      return problem_reply(429,
                           team + " is sending other files already; wait until they have arrived");
  }
  MIROCUP_TRY(
      auto file,
      system::IncomingFile::begin(state_.folder.uploads() + "/upload").map_error(host_failed));
  Result<void> added;
  const bool is_whole = body([&](std::string_view part) {
    const bool fits = file.size() + part.size() <= system::size_limit::entry;
    added = fits ? file.add(part) : fail(Errc::input, too_large());
    return added.has_value();
  });
  if (!added && added.error().code == Errc::input) return problem_reply(413, added.error().what);
  if (!added) return host_failed(added.error());
  if (!is_whole || (!length.empty() && file.size() != announced))
    return problem_reply(400, "the file did not arrive completely; send it again");
  if (file.size() == 0) return problem_reply(400, "the file is empty");
  MIROCUP_TRY(const auto sha256, file.finish().map_error(host_failed));
  return keep(team, file_name_of(request.asked("name")), file, sha256);
}

ReplyOrRefusal Uploads::keep(const std::string& team, const std::string& name,
                             system::IncomingFile& file, const std::string& sha256) {
  const auto taken = [](int entry) {
    const std::string url = std::string(entries_path) + "/" + std::to_string(entry);
    return json_reply(202, {{"entry", entry}, {"events", url + "/events"}, {"url", url}});
  };
  const std::lock_guard lock(state_.mutex);
  const HandInTerms terms = state_.terms_of(team);
  // The same bytes again are the same hand-in, for example if the reply to the first was lost. If
  // they came late and now come in time, they are another.
  const HandIns& hand_ins = state_.book.hand_ins();
  const HandedIn* last = hand_ins.find(team, hand_ins.last_number(team));
  if (last != nullptr && last->is_network && last->sha256 == sha256 &&
      last->state != HandInState::void_ && (!last->is_late || terms.is_late))
    return taken(last->entry);
  MIROCUP_TRY_VOID(expect_allowed(team, terms).map_error(reply_to));
  HandedIn handed{.team = team,
                  .file = name,
                  .sha256 = sha256,
                  .bytes = file.size(),
                  .at = state_.options.now(),
                  .is_network = true,
                  .is_late = terms.is_late};
  const auto store = [&file](const std::string& path) { return file.keep(path); };
  MIROCUP_TRY(const int entry, state_.book.take(std::move(handed), store).map_error(host_failed));
  ++state_.version;
  return taken(entry);
}

}  // namespace mirocup::league
