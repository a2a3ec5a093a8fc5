// SPDX-License-Identifier: MIT
#include "tournaments/handin/portal.hpp"

#include "record/json_reader.hpp"
#include "system/printable.hpp"
#include "tournaments/handin/replies.hpp"
#include "tournaments/league/submission.hpp"
#include "web/http/form.hpp"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <set>

namespace mirocup::league {

namespace {

constexpr std::string_view entries_path = "/api/v1/entries";
constexpr std::string_view legs_path = "/api/v1/legs";
constexpr std::string_view friendlies_path = "/api/v1/friendlies";
constexpr std::string_view pin_path = "/api/v1/pin";
constexpr std::string_view replays_path = "/hand-in/friendlies";
constexpr std::string_view entry_pages_path = "/hand-in/entries/";
constexpr std::size_t max_file_name = 100;  // bytes
constexpr std::size_t max_form = 4096;      // bytes
constexpr int max_pins = 10;                // of a team in an hour
constexpr int max_failures = 10;            // of the host, until a hand-in is void
constexpr int max_spent = 2;                // checks that used up their time, until it is refused

constexpr const char* page_policy =
    "default-src 'none'; style-src 'self'; script-src 'self'; connect-src 'self'; "
    "form-action 'self'; base-uri 'none'; frame-ancestors 'none'";

web::Reply reply_to(const Refusal& refusal) {
  web::Reply reply = problem_reply(refusal.status, refusal.why);
  if (refusal.status == 401) reply.headers.emplace_back("WWW-Authenticate", "Bearer");
  if (refusal.wait > 0) reply.headers.emplace_back("Retry-After", std::to_string(refusal.wait));
  return reply;
}

web::Reply page_reply(int status, std::string html) {
  return {.status = status,
          .type = "text/html; charset=utf-8",
          .bytes = std::move(html),
          .headers = {{"Content-Security-Policy", page_policy}}};
}

web::Reply go_to(const std::string& path) {
  return {.status = 303, .bytes = "", .headers = {{"Location", path}}};
}

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

Portal::Portal(system::Files& files, Folder folder, PortalOptions options, HandInBook book,
               std::unique_ptr<FriendlyDesk> friendlies)
    : files_(files),
      folder_(folder),
      options_(std::move(options)),
      costs_(files, folder),
      staff_(files, folder, options_.now),
      friendlies_(std::move(friendlies)),
      book_(std::move(book)),
      doorkeeper_(files, std::move(folder), options_.team_header) {}

Result<std::unique_ptr<Portal>> Portal::open(system::Files& files, const Folder& folder,
                                             PortalOptions options, std::string* notice) {
  MIROCUP_TRY(auto book, HandInBook::open(files, folder, notice));
  MIROCUP_TRY_VOID(files.make_folder(folder.entries(), system::Readers::owner).and_then([&] {
    return files.make_folder(folder.uploads(), system::Readers::owner);
  }));
  // Uploads that a killed server has left.
  MIROCUP_TRY_VOID(files.remove_unfinished(folder.uploads()));
  MIROCUP_TRY(auto friendlies, FriendlyDesk::open(files, folder, options.friendlies, notice));
  std::unique_ptr<Portal> portal(
      new Portal(files, folder, std::move(options), std::move(book), std::move(friendlies)));
  MIROCUP_TRY_VOID(portal->finish_what_was_begun());
  return portal;
}

// What a server that died has written into one book and not yet into the next file.
Result<void> Portal::finish_what_was_begun() {
  const std::int64_t now = options_.now();
  for (const auto& [team, entry] : book_.pins()) {
    MIROCUP_TRY(const auto known, read_hand_ins(files_, folder_, team));
    if (known.pinned == entry) continue;
    MIROCUP_TRY_VOID(pin_entry(files_, folder_, team, entry, now));
  }
  for (const auto& [team, entry] : book_.queue().accepted()) {
    if (auto begun = friendlies_->entry_accepted(team, entry, now); !begun) return begun;
  }
  return {};
}

std::variant<Visitor, web::Reply> Portal::visitor(const web::Request& request, Purpose purpose) {
  const std::lock_guard lock(mutex_);
  const auto admitted = doorkeeper_.admit(request, purpose, options_.now());
  if (!admitted) return host_failed(admitted.error());
  if (const auto* refusal = std::get_if<Refusal>(&*admitted)) return reply_to(*refusal);
  return std::get<Visitor>(*admitted);
}

std::optional<web::Reply> Portal::answer(const web::Request& request, const web::Body& body) {
  const std::string& path = request.path;
  if (path.starts_with("/api/")) return api(request, body);
  if (path == "/hand-in/log-in" && request.method == "POST") return log_in(request, body);
  if (path == "/hand-in/log-out" && request.method == "POST") return log_out(request);
  if (path == "/hand-in/staff" || path == "/hand-in/grades.csv") return staff(request, body);
  if (path.starts_with(own_replays_path)) return own_replay(request);
  const bool is_replay = path.starts_with(replays_path);
  const bool is_entry = path.starts_with(entry_pages_path);
  if ((path != "/hand-in" && !is_replay && !is_entry) ||
      (request.method != "GET" && request.method != "HEAD"))
    return std::nullopt;
  {
    const std::lock_guard lock(mutex_);
    if (!doorkeeper_.has_credentials(request)) return page_reply(200, log_in_page(""));
  }
  const auto who = visitor(request, Purpose::reading);
  if (const auto* refusal = std::get_if<web::Reply>(&who)) {
    const auto error = Json::parse(refusal->bytes, nullptr, false);
    return page_reply(refusal->status, log_in_page(error.value("error", "")));
  }
  const Visitor& known = std::get<Visitor>(who);
  if (const std::string team = request.asked("team"); known.sees_all() && !team.empty()) {
    return is_good_name(team) ? staff_.legs_of(team, options_.legs(team))
                              : problem_reply(404, "there is no such team");
  }
  if (known.role == Role::tutor) return staff_.page(Role::tutor);
  if (known.role == Role::staff)
    return staff_.page(Role::staff, number_of(request.asked("done")).value_or(0));
  if (is_replay)
    return friendlies_->show(known.team, std::string_view(path).substr(replays_path.size()));
  if (is_entry)
    return entry_reply(known.team, std::string_view(path).substr(entry_pages_path.size()));
  return team_page(known.team);
}

// What only the staff may ask for: the forms of its page, and the grades.
web::Reply Portal::staff(const web::Request& request, const web::Body& body) {
  const bool is_act = request.method == "POST";
  const auto who = visitor(request, is_act ? Purpose::changing : Purpose::reading);
  if (const auto* refusal = std::get_if<web::Reply>(&who)) return *refusal;
  const Role role = std::get<Visitor>(who).role;
  if (role == Role::team) return problem_reply(403, "this is for the staff only");
  if (is_act && role == Role::tutor)
    return problem_reply(403, "a tutor's token reads what the staff reads, and decides nothing");
  if (!is_act) {
    return request.path == "/hand-in/grades.csv" ? staff_.grades()
                                                 : problem_reply(405, "a form is expected");
  }
  std::string form;
  const bool is_whole = body([&form](std::string_view part) {
    form += part;
    return form.size() <= max_form;
  });
  if (!is_whole) return problem_reply(400, "the form was not sent to its end, or is too long");
  web::Reply reply = staff_.act(form);
  ++version_;
  return reply;
}

// A leg of a team may be shown to it before the public sees it, with its own thoughts. The staff
// names the team, as for the API, and sees those of both.
web::Reply Portal::own_replay(const web::Request& request) {
  const auto who = visitor(request, Purpose::reading);
  if (const auto* refusal = std::get_if<web::Reply>(&who)) return *refusal;
  const Visitor& known = std::get<Visitor>(who);
  for (const OwnLeg& leg : options_.legs(known.sees_all() ? request.asked("team") : known.team)) {
    if (leg.record.empty() || !options_.replay ||
        request.path != std::string(own_replays_path) + name_of_leg(leg) + ".html")
      continue;
    auto page =
        options_.replay(name_of_leg(leg), known.sees_all() ? record::of_both : own_side(leg));
    if (!page) break;
    return {.status = 200, .type = "text/html; charset=utf-8", .bytes = std::move(*page)};
  }
  return problem_reply(404, "there is no leg of yours of this name");
}

// `rest` is what follows the path of all pages of entries.
web::Reply Portal::entry_reply(const std::string& team, std::string_view rest) {
  const std::size_t slash = std::min(rest.find('/'), rest.size());
  const auto number = number_of(rest.substr(0, slash));
  const std::string_view what = rest.substr(slash);
  const auto known = number ? report(team, *number, true) : Json();
  if (!known) return host_failed(known.error());
  const Json& entry = *known;
  if (!entry.is_null() && what.empty())
    return page_reply(200, entry_page(entry, options_.time_in_words));
  if (entry.is_null() || what != "/replay" || !entry.contains("replay"))
    return problem_reply(404, team + " has no entry of this number");
  auto page = options_.friendlies.replay(folder_.gate_leg(team, *number), record::of_nobody);
  if (!page) return problem_reply(503, "the replay cannot be made here");
  return {.status = 200, .type = "text/html; charset=utf-8", .bytes = std::move(*page)};
}

web::Reply Portal::team_page(const std::string& team) {
  TeamDesk desk;
  desk.team = team;
  auto entries = reports(team);
  if (!entries) return host_failed(entries.error());
  desk.entries = std::move(*entries);
  desk.legs = own_legs_json(files_, folder_, options_.legs(team), costs_);
  desk.friendlies = friendlies_->list(team, costs_);
  desk.opponents = friendlies_->opponents(team);
  const auto playing = playing_entry(files_, folder_, team);
  if (!playing) return host_failed(playing.error());
  desk.playing = *playing;
  const auto known = read_hand_ins(files_, folder_, team);
  if (!known) return host_failed(known.error());
  desk.is_pinned = known->pinned > 0 && known->pinned == desk.playing;
  desk.statistics = options_.statistics(team);
  desk.time_in_words = options_.time_in_words;
  desk.shown_name = options_.shown_name;
  if (options_.digest) desk.digest = options_.digest(team);
  return page_reply(200, team_desk_page(desk));
}

// A team may choose one of its accepted versions, as long as it may hand in.
web::Reply Portal::pin(const web::Request& request, const Visitor& visitor) {
  if (visitor.sees_all()) return problem_reply(403, "the staff's token pins no version");
  const std::string asked = request.asked("entry");
  const auto entry = asked == "latest" ? std::optional(0) : number_of(asked);
  if (!entry) return problem_reply(400, "?entry=N or ?entry=latest is expected");
  const std::lock_guard lock(mutex_);
  const std::int64_t now = options_.now();
  // In a ladder each change has legs of its own.
  if (book_.pins_in_last_hour(visitor.team, now) >= max_pins) {
    return problem_reply(429, visitor.team + " has chosen its version " + std::to_string(max_pins) +
                                  " times in the last hour; choose later");
  }
  const auto done = pin_entry(files_, folder_, visitor.team, *entry, now);
  if (!done) return host_failed(done.error());
  if (!done->empty()) return problem_reply(409, *done);
  if (auto written = book_.pin(visitor.team, *entry, now); !written)
    return host_failed(written.error());
  ++version_;
  const auto playing = playing_entry(files_, folder_, visitor.team);
  if (!playing) return host_failed(playing.error());
  return json_reply(200, {{"pinned", *entry > 0 ? Json(*entry) : Json()}, {"playing", *playing}});
}

web::Reply Portal::friendly_reply(const web::Request& request, const Visitor& visitor) {
  if (visitor.sees_all()) return problem_reply(403, "the staff's token plays no friendlies");
  const std::string_view rest = std::string_view(request.path).substr(friendlies_path.size());
  if (request.method == "POST" && rest.empty())
    return friendlies_->ask(visitor.team, request.asked("opponent"), options_.now());
  if (request.method != "GET" && request.method != "HEAD")
    return problem_reply(405, "there is nothing of this name here");
  if (!rest.empty()) return friendlies_->show(visitor.team, rest);
  return json_reply(200, {{"team", visitor.team},
                          {"friendlies", friendlies_->list(visitor.team, costs_)},
                          {"opponents", friendlies_->opponents(visitor.team)}});
}

web::Reply Portal::api(const web::Request& request, const web::Body& body) {
  const bool is_reading = request.method == "GET" || request.method == "HEAD";
  const auto who = visitor(request, is_reading ? Purpose::reading : Purpose::changing);
  if (const auto* refusal = std::get_if<web::Reply>(&who)) return *refusal;
  const Visitor& known = std::get<Visitor>(who);
  const std::string_view path = request.path;
  if (path == entries_path && request.method == "PUT") return take(request, body, known);
  if (path == pin_path && request.method == "PUT") return pin(request, known);
  if (path.starts_with(friendlies_path)) return friendly_reply(request, known);

  // The staff names the team; a team reads its own entries only.
  std::string team = request.asked("team");
  if (team.empty()) team = known.team;
  if (!known.sees_all() && team != known.team)
    return problem_reply(403, "this token is for the entries of " + known.team + " only");
  if (path == "/api/v1/team" && is_reading) return json_reply(200, about(known));
  const bool is_leg = path.starts_with(legs_path);
  if (!is_reading || (!is_leg && !path.starts_with(entries_path)))
    return problem_reply(is_reading ? 404 : 405, "there is nothing of this name here");
  if (!is_good_name(team)) return problem_reply(400, "?team=NAME is expected");
  if (is_leg) return leg_reply(team, path.substr(legs_path.size()));
  std::string_view rest = path.substr(entries_path.size());
  if (rest.empty()) {
    const auto entries = reports(team);
    if (!entries) return host_failed(entries.error());
    return json_reply(200, {{"team", team}, {"entries", *entries}});
  }
  if (!rest.starts_with("/")) return problem_reply(404, "there is nothing of this name here");
  rest.remove_prefix(1);
  const std::size_t slash = std::min(rest.find('/'), rest.size());
  const auto entry = number_of(rest.substr(0, slash));
  const std::string_view what = rest.substr(slash);
  const auto known_entry = entry ? report(team, *entry, true) : Json();
  if (!known_entry) return host_failed(known_entry.error());
  if (known_entry->is_null() || (what != "" && what != "/events"))
    return problem_reply(404, team + " has no entry of this number");
  return what.empty() ? json_reply(200, *known_entry) : events(team, *entry);
}

// `rest` is what follows the path of all legs.
web::Reply Portal::leg_reply(const std::string& team, std::string_view rest) {
  constexpr std::string_view log_end = "/log";
  const auto legs = options_.legs(team);
  if (rest.empty())
    return json_reply(200,
                      {{"team", team}, {"legs", own_legs_json(files_, folder_, legs, costs_)}});
  if (rest.starts_with("/") && rest.ends_with(log_end)) {
    rest.remove_prefix(1);
    // Only a leg of the team has a name that is looked for; no path comes from the request.
    for (const OwnLeg& leg : legs) {
      if (leg.record.empty() || rest != name_of_leg(leg) + std::string(log_end)) continue;
      const std::string path = log_path(folder_, leg);
      const auto log = files_.read_if_there(path, {.max_size = system::size_limit::log});
      if (!log) return host_failed(log.error());
      return {.status = 200, .bytes = system::printable(log->value_or(""), system::LineEnds::kept)};
    }
  }
  return problem_reply(404, team + " has played no leg of this name");
}

web::Reply Portal::log_in(const web::Request& request, const web::Body& body) {
  std::string form;
  const bool is_whole = body([&form](std::string_view part) {
    form += part;
    return form.size() <= max_form;
  });
  if (!is_whole) return page_reply(400, log_in_page("the form was not sent to its end"));
  const std::lock_guard lock(mutex_);
  std::multimap<std::string, std::string> values;
  web::add_form_values(form, values);
  const auto token = values.find("token");
  const auto done =
      doorkeeper_.log_in(request, token != values.end() ? token->second : "", options_.now());
  if (!done) return page_reply(503, log_in_page("this server cannot do that now; try again later"));
  if (const auto* refusal = std::get_if<Refusal>(&*done)) {
    web::Reply reply = page_reply(refusal->status, log_in_page(refusal->why));
    if (refusal->wait > 0) reply.headers.emplace_back("Retry-After", std::to_string(refusal->wait));
    return reply;
  }
  web::Reply reply = go_to("/hand-in");
  reply.headers.emplace_back("Set-Cookie", std::get<std::string>(*done));
  return reply;
}

web::Reply Portal::log_out(const web::Request& request) {
  const std::lock_guard lock(mutex_);
  const auto done = doorkeeper_.log_out(request);
  if (!done) return host_failed(done.error());
  if (const auto* refusal = std::get_if<Refusal>(&*done)) return reply_to(*refusal);
  web::Reply reply = go_to("/hand-in");
  reply.headers.emplace_back("Set-Cookie", std::get<std::string>(*done));
  return reply;
}

// Requires mutex_. Returns the reply to a team that hands in more than it may, or too late.
std::optional<web::Reply> Portal::refused_now(const std::string& team) {
  const std::int64_t now = options_.now();
  if (const std::string why = options_.why_not(team, utc_text(now)); !why.empty())
    return problem_reply(403, why);
  if (const int waiting = book_.queue().unanswered(team); waiting >= options_.max_waiting) {
    return problem_reply(429, std::to_string(waiting) + " files of " + team +
                                  " wait for their checks; hand in when they are answered");
  }
  auto known = read_hand_ins(files_, folder_, team);
  if (!known) return host_failed(known.error());
  int tries = tries_in_last_hour(*known, now, {});
  for (const WaitingHandIn* handed : book_.queue().of_team(team)) {
    if (!is_final(handed->state) && find_try(*known, handed->entry) == nullptr) ++tries;
  }
  if (tries < options_.quota.tries_per_hour) return std::nullopt;
  return problem_reply(429, team + " has had " + std::to_string(options_.quota.tries_per_hour) +
                                " tries in the last hour; hand it in later");
}

// Counts an upload of a team while it lasts.
struct Portal::Upload {
  Portal& portal;
  const std::string& team;
  bool is_counted = false;

  // Requires the mutex of the portal.
  bool begin() {
    int& running = portal.uploads_[team];
    if (running >= portal.options_.max_uploads) return false;
    ++running;
    return is_counted = true;
  }
  ~Upload() {
    if (!is_counted) return;
    const std::lock_guard lock(portal.mutex_);
    if (--portal.uploads_[team] == 0) portal.uploads_.erase(team);
  }
};

web::Reply Portal::take(const web::Request& request, const web::Body& body,
                        const Visitor& visitor) {
  if (visitor.sees_all()) return problem_reply(403, "the staff's token hands in for no team");
  const std::string& team = visitor.team;
  const std::string coding = request.header("content-encoding");
  if (!coding.empty() && coding != "identity")
    return problem_reply(415, "send the file as it is, without Content-Encoding");
  if (request.headers.contains("content-length") && request.headers.contains("transfer-encoding"))
    return problem_reply(400, "two lengths are given");
  const std::string length = request.header("content-length");
  if (length == "0") return problem_reply(400, "the file is empty");
  std::uint64_t announced = 0;
  const auto read = std::from_chars(length.data(), length.data() + length.size(), announced);
  if (announced > system::size_limit::entry || read.ec == std::errc::result_out_of_range)
    return problem_reply(413, too_large());
  Upload upload{*this, team};
  {
    const std::lock_guard lock(mutex_);
    if (auto refused = refused_now(team)) return std::move(*refused);
    if (!upload.begin())
      return problem_reply(429, team + " is sending other files already; wait for their end");
  }
  auto file = system::IncomingFile::begin(folder_.uploads() + "/upload");
  if (!file) return host_failed(file.error());
  Result<void> added;
  const bool is_whole = body([&](std::string_view part) {
    if (file->size() + part.size() > system::size_limit::entry) {
      added = fail(Errc::input, too_large());
    } else {
      added = file->add(part);
    }
    return added.has_value();
  });
  if (!added && added.error().code == Errc::input) return problem_reply(413, added.error().what);
  if (!added) return host_failed(added.error());
  if (!is_whole || (!length.empty() && file->size() != announced))
    return problem_reply(400, "the file did not arrive to its end; send it again");
  if (file->size() == 0) return problem_reply(400, "the file is empty");
  const auto sha256 = file->finish();
  if (!sha256) return host_failed(sha256.error());
  return keep(visitor, file_name_of(request.asked("name")), *file, *sha256);
}

web::Reply Portal::keep(const Visitor& visitor, const std::string& name, system::IncomingFile& file,
                        const std::string& sha256) {
  const std::string& team = visitor.team;
  const auto taken = [](int entry) {
    const std::string url = std::string(entries_path) + "/" + std::to_string(entry);
    return json_reply(202, {{"entry", entry}, {"events", url + "/events"}, {"url", url}});
  };
  const std::lock_guard lock(mutex_);
  // The same bytes again are the same hand-in, for example if the reply to the first was lost.
  const auto own = book_.queue().of_team(team);
  if (!own.empty() && own.back()->sha256 == sha256 && own.back()->state != HandInState::void_)
    return taken(own.back()->entry);
  if (auto refused = refused_now(team)) return std::move(*refused);
  WaitingHandIn handed{
      .team = team, .file = name, .sha256 = sha256, .bytes = file.size(), .at = options_.now()};
  const auto entry =
      book_.take(std::move(handed), [&file](const std::string& path) { return file.keep(path); });
  if (!entry) return host_failed(entry.error());
  ++version_;
  return taken(*entry);
}

web::Reply Portal::events(const std::string& team, int entry) {
  web::Reply reply{.is_for_known = true};
  reply.events = [this, team, entry, seen = std::uint64_t{0},
                  told = std::string()]() mutable -> web::EventBatch {
    const std::uint64_t version = version_;
    if (version == seen) return {};
    seen = version;
    const auto known = report(team, entry, true);
    if (!known) return {};
    const Json& now = *known;
    std::string text = "event: state\ndata: " + record::json_text(now) + "\n\n";
    if (text == told) return {};
    told = text;
    const auto state =
        now.is_null() ? std::nullopt : from_string<HandInState>(now["state"].get<std::string>());
    return {std::move(text), !state || is_final(*state)};
  };
  return reply;
}

Result<Json> Portal::report(const std::string& team, int entry, bool is_whole) {
  std::optional<WaitingHandIn> waiting;
  int before = 0;
  CheckStep step;
  {
    const std::lock_guard lock(mutex_);
    if (const WaitingHandIn* found = book_.queue().find(team, entry)) waiting = *found;
    before = waiting ? book_.queue().before(team, entry) : 0;
    if (const auto found = steps_.find({team, entry}); found != steps_.end()) step = found->second;
  }
  const WaitingHandIn* known = waiting ? &*waiting : nullptr;
  auto json = entry_report(files_, folder_, team, entry, known, before, step, is_whole);
  if (is_whole && json && !json->is_null() && files_.exists(folder_.gate_leg(team, entry)))
    (*json)["replay"] = std::string(entry_pages_path) + std::to_string(entry) + "/replay";
  return json;
}

// Returns the summaries of all entries of a team, the latest first.
Result<Json> Portal::reports(const std::string& team) {
  MIROCUP_TRY(const auto entries, entries_of(files_, folder_, team));
  std::set<int> numbers(entries.begin(), entries.end());
  {
    const std::lock_guard lock(mutex_);
    for (const WaitingHandIn* handed : book_.queue().of_team(team)) numbers.insert(handed->entry);
  }
  Json list = Json::array();
  for (auto number = numbers.rbegin(); number != numbers.rend(); ++number) {
    auto one = report(team, *number, false);
    if (!one) return one;
    if (!one->is_null()) list.push_back(std::move(*one));
  }
  return list;
}

Json Portal::about(const Visitor& visitor) {
  const std::lock_guard lock(mutex_);
  Json json{{"team", visitor.sees_all() ? Json() : Json(visitor.team)},
            {"staff", visitor.sees_all()},
            {"max_bytes", system::size_limit::entry},
            {"why_not", Json()}};
  if (visitor.sees_all()) return json;
  const auto refused = refused_now(visitor.team);
  if (!refused) return json;
  json["why_not"] = Json::parse(refused->bytes, nullptr, false).value("error", "");
  json["status"] = refused->status;
  return json;
}

std::optional<WaitingHandIn> Portal::begin_next() {
  const std::lock_guard lock(mutex_);
  const WaitingHandIn* next = book_.queue().next();
  if (next == nullptr) return std::nullopt;
  WaitingHandIn begun = *next;
  book_.begin(begun.team, begun.entry,
              source_kind_of(begun.file) == SourceKind::none ? HandInState::checking
                                                             : HandInState::compiling);
  ++version_;
  return begun;
}

bool Portal::has_next() {
  const std::lock_guard lock(mutex_);
  return book_.queue().next() != nullptr;
}

void Portal::set_step(const std::string& team, int entry, const CheckStep& step) {
  const std::lock_guard lock(mutex_);
  CheckStep& known = steps_[{team, entry}];
  if (known == step) return;
  known = step;
  if (step.number > 0) book_.begin(team, entry, HandInState::checking);
  ++version_;
}

Result<void> Portal::close(const std::string& team, int entry, HandInState state,
                           const std::string& message) {
  {
    const std::lock_guard lock(mutex_);
    auto answered = book_.answer(team, entry, state, message, options_.now());
    steps_.erase({team, entry});
    if (!answered) book_.wait_again(team, entry);
    ++version_;
    if (!answered) return answered;
  }
  // If the server dies here, the next one begins the burst.
  if (state != HandInState::accepted) return {};
  return friendlies_->entry_accepted(team, entry, options_.now());
}

Result<void> Portal::wait_again(const std::string& team, int entry, NoAnswer why, double seconds) {
  int times = 0;
  {
    const std::lock_guard lock(mutex_);
    book_.wait_again(team, entry, why);
    steps_.erase({team, entry});
    ++version_;
    if (const auto* handed = book_.queue().find(team, entry)) times = handed->times(why);
  }
  const std::string name = team + ": entry " + std::to_string(entry);
  Result<void> closed;
  if (why == NoAnswer::host_failed && times >= max_failures) {
    closed =
        close(team, entry, HandInState::void_,
              name + " could not be checked, which is this computer's fault; hand it in again");
  } else if (why == NoAnswer::spent && times >= max_spent) {
    closed = close(team, entry, HandInState::refused,
                   name + " was not accepted: its check took more than " +
                       std::to_string(static_cast<int>(seconds)) +
                       " s of processor time, and did so twice; let the team compute less while it "
                       "is loaded and in each tick");
  } else {
    return {};
  }
  if (!closed) return closed;
  // Its files have no verdict, by which entries are counted and removed later.
  (void)files_.remove(folder_.library(team, entry));
  (void)files_.remove(folder_.source(team, entry));
  return {};
}

std::optional<WaitingHandIn> Portal::to_stop(const std::vector<RunningCheck>& running) {
  const std::lock_guard lock(mutex_);
  const WaitingHandIn* stopped = book_.queue().to_stop(running);
  return stopped == nullptr ? std::nullopt : std::optional(*stopped);
}

}  // namespace mirocup::league
