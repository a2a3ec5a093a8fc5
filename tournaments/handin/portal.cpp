// SPDX-License-Identifier: MIT
#include "tournaments/handin/portal.hpp"

#include "record/json_reader.hpp"
#include "system/text.hpp"
#include "tournaments/handin/progress.hpp"
#include "tournaments/handin/team_desk_page.hpp"
#include "tournaments/publish/site_file.hpp"
#include "web/http/form.hpp"

#include <array>
#include <limits>

namespace mirocup::league {

namespace {

constexpr int max_failures = 10;  // of the host, until a hand-in is void
constexpr int max_pins = 10;      // of a team in an hour
constexpr int max_spent = 2;      // checks that used up their time, until it is refused

// Returns the number in ?before=N, below which the entries of a list are.
tl::expected<int, web::Reply> before_of(const Call& call) {
  const std::string asked = call.request.asked("before");
  if (asked.empty()) return std::numeric_limits<int>::max();
  if (const auto number = number_of(asked)) return *number;
  return tl::unexpected(problem_reply(400, "?before=N is expected"));
}

// The way to the team's page from /hand-in/log-in and /hand-in/log-out.
web::Reply go_to_desk(const std::string& cookie) {
  return moved_to("../hand-in", cookie);
}

}  // namespace

Portal::Portal(system::Files& files, Folder folder, PortalLeague& league, PortalOptions options,
               Book book, system::FileLock lock)
    : lock_(std::move(lock)),
      state_(files, folder, league, std::move(options), std::move(book)),
      entries_(state_),
      uploads_(state_),
      staff_(files, folder, state_.options.now),
      friendlies_(state_),
      doorkeeper_(files, std::move(folder), state_.options.team_header) {}

std::span<const Portal::Route> Portal::routes() {
  using enum Who;
  using enum About;
  static constexpr std::array table{
      Route{"GET", "/api/v1/team", known, team_of_token, &Portal::about_team},
      Route{"GET", "/api/v1/entries", known, entries_of_team, &Portal::list_entries},
      Route{"PUT", "/api/v1/entries", team, api, &Portal::take},
      Route{"GET", "/api/v1/entries/*", known, entries_of_team, &Portal::show_entry},
      Route{"GET", "/api/v1/entries/*/events", known, entries_of_team, &Portal::tell_entry},
      Route{"PUT", "/api/v1/pin", team, api, &Portal::pin},
      Route{"GET", "/api/v1/legs", known, entries_of_team, &Portal::list_legs},
      Route{"GET", "/api/v1/legs/*/log", known, entries_of_team, &Portal::show_log},
      Route{"GET", "/api/v1/friendlies", team, api, &Portal::list_friendlies},
      Route{"POST", "/api/v1/friendlies", team, api, &Portal::ask_friendly},
      Route{"GET", "/api/v1/friendlies/*/*/*", team, api, &Portal::show_friendly},
      Route{"GET", "/hand-in", known, page, &Portal::desk},
      Route{"GET", "/hand-in/", everybody, page, &Portal::lead_to_desk},
      Route{"GET", "/hand-in/staff", known, page, &Portal::lead_to_desk},
      Route{"GET", "/hand-in/entries/*", known, page, &Portal::entry_page_of},
      Route{"GET", "/hand-in/entries/*/replay", known, page, &Portal::entry_replay},
      Route{"GET", "/hand-in/friendlies/*/*/*", team, page, &Portal::show_friendly},
      Route{"GET", "/hand-in/mark/*/replay", team, page, &Portal::mark_replay},
      Route{"GET", "/hand-in/replays/**", known, api, &Portal::own_replay},
      Route{"POST", "/hand-in/log-in", everybody, page, &Portal::log_in},
      Route{"POST", "/hand-in/log-out", everybody, page, &Portal::log_out},
      Route{"POST", "/hand-in/staff", staff, api, &Portal::act},
      Route{"GET", "/hand-in/grades.csv", grader, api, &Portal::grades},
  };
  return table;
}

Result<std::unique_ptr<Portal>> Portal::open(system::Files& files, const Folder& folder,
                                             PortalLeague& league, PortalOptions options,
                                             std::string* notice) {
  MIROCUP_TRY(auto lock, system::FileLock::try_acquire(folder.handing_in()));
  if (!lock) {
    return fail(Errc::unavailable,
                folder.path + ": another process takes hand-ins for this league already");
  }
  MIROCUP_TRY(auto book, Book::open(files, folder, notice));
  MIROCUP_TRY_VOID(files.make_folder(folder.entries(), system::Readers::owner).and_then([&] {
    return files.make_folder(folder.uploads(), system::Readers::owner);
  }));
  // Uploads that a killed server has left.
  MIROCUP_TRY_VOID(files.remove_unfinished(folder.uploads()));
  std::unique_ptr<Portal> portal(
      new Portal(files, folder, league, std::move(options), std::move(book), std::move(*lock)));
  MIROCUP_TRY_VOID(portal->follow_book());
  return portal;
}

// Does what processes that were killed have left undone of what the book says.
Result<void> Portal::follow_book() {
  MIROCUP_TRY(auto booking, Booking::begin(state_.files, state_.folder));
  const HandIns& hand_ins = state_.book.hand_ins();
  for (const std::string& team : hand_ins.teams()) {
    MIROCUP_TRY_VOID(booking.follow(hand_ins, team));
    int accepted = 0;  // entries of the host get no burst
    for (const auto& [number, handed] : hand_ins.of_team(team))
      if (handed.is_network && handed.state == HandInState::accepted) accepted = number;
    MIROCUP_TRY_VOID(friendlies_.entry_accepted(team, accepted));
  }
  return {};
}

web::Reply Portal::reply_of(const Route& route, const Call& call) {
  ReplyOrRefusal answer = (this->*route.answer)(call);
  return answer ? std::move(*answer) : std::move(answer.error());
}

std::optional<web::Reply> Portal::answer(const web::Request& request, const web::Body& body) {
  Call call{request, body};
  const Route* route = nullptr;
  std::vector<std::string_view> methods;  // of this path
  for (const Route& one : routes()) {
    auto parts = match_path(one.path, request.path);
    if (!parts) continue;
    methods.push_back(one.method);
    if (one.method != request.method && !(request.method == "HEAD" && one.method == "GET"))
      continue;
    route = &one;
    call.parts = std::move(*parts);
  }
  if (route != nullptr && route->who == Who::everybody) return reply_of(*route, call);
  // Below /api/, only those who are known learn what is there.
  const bool is_api = request.path.starts_with("/api/");
  if (route == nullptr && !is_api)
    return methods.empty() ? std::nullopt : std::optional(use_reply(request, methods));
  if (auto refusal = admit(call, route != nullptr && route->about == About::page)) return refusal;
  if (route == nullptr) {
    return methods.empty() ? problem_reply(404, "there is nothing of this name here")
                           : use_reply(request, methods);
  }
  if (auto refusal = refused_role(route->who, call.visitor)) return refusal;
  if (const auto fresh = refresh(); !fresh) return host_failed(fresh.error());
  if (auto refusal = name_team(call, route->about)) return refusal;
  web::Reply reply = reply_of(*route, call);
  if (!request.is_reading() && reply.status / 100 != 4) state_.league.note_own_write();
  reply.is_for_known = true;
  return reply;
}

// The host may have handed in a file, too.
Result<void> Portal::refresh() {
  const std::lock_guard lock(state_.mutex);
  return state_.book.refresh();
}

// Finds out who comes. Returns the reply to somebody who is not known.
std::optional<web::Reply> Portal::admit(Call& call, bool is_page) {
  const web::Request& request = call.request;
  const auto log_in_reply = [&request](int status, const std::string& why) {
    return desk_reply(status, log_in_page(why, web::root_of(request.path)));
  };
  const std::lock_guard lock(state_.mutex);
  if (is_page && !doorkeeper_.has_credentials(request)) return log_in_reply(200, "");
  const auto purpose = request.is_reading() ? Purpose::reading : Purpose::changing;
  auto known = doorkeeper_.admit(request, purpose, state_.options.now());
  if (!known && is_page) return log_in_reply(known.error().status, known.error().why);
  if (!known) return reply_to(known.error());
  call.visitor = std::move(*known);
  call.team = call.visitor.team;
  return std::nullopt;
}

// The staff names the team; a team reads its own entries only.
std::optional<web::Reply> Portal::name_team(Call& call, About about) {
  if (about == About::page && call.visitor.sees_all()) call.team = call.request.asked("team");
  if (about != About::entries_of_team && about != About::team_of_token) return std::nullopt;
  const std::string asked = call.request.asked("team");
  if (!call.visitor.sees_all() && !asked.empty() && asked != call.team)
    return problem_reply(403, "this token is for the entries of " + call.team + " only");
  if (call.visitor.sees_all()) call.team = asked;
  if (about == About::entries_of_team && !is_good_name(call.team))
    return problem_reply(400, "?team=NAME is expected");
  return std::nullopt;
}

ReplyOrRefusal Portal::lead_to_desk(const Call&) {
  return web::Reply{.status = 308, .headers = {{"Location", "../hand-in"}}};
}

ReplyOrRefusal Portal::desk(const Call& call) {
  const Visitor& known = call.visitor;
  if (const std::string team = call.request.asked("team"); known.sees_all() && !team.empty()) {
    if (!is_good_name(team)) return problem_reply(404, "there is no such team");
    return staff_.legs_of(known, team, state_.league.legs_of(Viewer::staff, team))
        .map_error(host_failed_for_staff);
  }
  if (known.sees_all()) {
    return staff_
        .page(known, {.done = number_of(call.request.asked("done")).value_or(0),
                      .given = {{"fixture", call.request.asked("fixture")},
                                {"leg", call.request.asked("leg")}}})
        .map_error(host_failed_for_staff);
  }
  MIROCUP_TRY(const int before, before_of(call));
  return team_page(known.team, before);
}

// The forms of the page of the staff.
ReplyOrRefusal Portal::act(const Call& call) {
  const auto form = web::read_form(call.body);
  if (!form) return problem_reply(400, "the form did not arrive completely, or is too long");
  auto reply = staff_.act(call.visitor, *form, web::root_of(call.request.path));
  ++state_.version;
  return reply.map_error(host_failed_for_staff);
}

ReplyOrRefusal Portal::grades(const Call&) {
  return staff_.grades().map_error(host_failed_for_staff);
}

// A team may see its leg before the public does, with its own thoughts. The staff names the team,
// as for the API, and sees the thoughts of both teams.
ReplyOrRefusal Portal::own_replay(const Call& call) {
  const bool sees_all = call.visitor.sees_all();
  for (const OwnLeg& leg : state_.league.legs_of(
           call.visitor.viewer(), sees_all ? call.request.asked("team") : call.visitor.team)) {
    if (leg.record.empty() || call.parts.front() != name_of_leg(leg) + ".html") continue;
    const std::string links = decides(call.visitor.role)
                                  ? "<p class=\"path\"><a href=\"" +
                                        system::html_escaped(web::root_of(call.request.path) +
                                                             StaffDesk::decision_path(leg)) +
                                        "\">Decide about this leg</a></p>"
                                  : "";
    if (auto page = state_.league.own_replay(name_of_leg(leg),
                                             sees_all ? record::of_both : own_side(leg), links))
      return replay_reply(std::move(page));
    // A leg of another version may go another way here: then its page is the one that is kept.
    return moved_to(web::root_of(call.request.path) + replay_page_of(leg.record));
  }
  return problem_reply(404, "your team has no leg of this name");
}

// Returns the whole report of the entry whose number is the first part of the path, or the reply
// that there is none.
tl::expected<Json, web::Reply> Portal::entry_of(const Call& call) {
  const bool is_named = is_good_name(call.team);
  const auto number = is_named ? number_of(call.parts.front()) : std::nullopt;
  MIROCUP_TRY(Json known,
              (number ? entries_.report(call.team, *number, true) : Json()).map_error(host_failed));
  if (!known.is_null()) return known;
  return tl::unexpected(problem_reply(
      404, is_named ? call.team + " has no entry of this number" : "?team=NAME is expected"));
}

ReplyOrRefusal Portal::entry_page_of(const Call& call) {
  MIROCUP_TRY(const Json entry, entry_of(call));
  return desk_reply(200, entry_page(entry, state_.league, web::root_of(call.request.path),
                                    call.visitor.sees_all()));
}

ReplyOrRefusal Portal::entry_replay(const Call& call) {
  MIROCUP_TRY(const Json entry, entry_of(call));
  if (!entry.contains("replay"))
    return problem_reply(404, call.team + " has no entry of this number");
  return replay_reply(
      state_.league.replay_of(state_.folder.gate_leg(call.team, *number_of(call.parts.front())),
                              record::of_nobody, web::root_of(call.request.path)));
}

// Returns what the host has released of a team's mark, that of the closing round if it has one;
// null if nothing is released. `home` is the folder of the league that has the records.
Json Portal::released_mark(const std::string& team) const {
  for (const Folder& league : {state_.folder.closing_round(), state_.folder}) {
    const auto text =
        state_.files.read(league.released_mark(team), {.max_size = system::size_limit::note});
    if (!text) continue;
    Json mark = record::parse_json(*text).value;
    if (!mark.is_object()) continue;
    mark["home"] = league.path;
    return mark;
  }
  return {};
}

// The replay of one of the legs that decide a team's mark.
ReplyOrRefusal Portal::mark_replay(const Call& call) {
  Json mark = released_mark(call.team);
  for (const Json& leg : mark["legs"]) {
    if (number_text(leg, "number", "%.0f") != call.parts.front()) continue;
    const std::string record = text_in(mark, "home") + "/" + text_in(leg, "record");
    return replay_reply(
        state_.league.replay_of(record, record::of_nobody, web::root_of(call.request.path)));
  }
  return problem_reply(404, "no leg of this number decides the mark of " + call.team);
}

ReplyOrRefusal Portal::team_page(const std::string& team, int before) {
  TeamDesk desk{.league = state_.league, .team = team};
  MIROCUP_TRY(Json page, entries_.reports(team, before).map_error(host_failed));
  desk.entries = std::move(page["entries"]);
  desk.older = std::move(page["older"]);
  desk.legs = own_legs_json(state_.files, state_.folder, state_.league.legs_of(Viewer::team, team),
                            state_.costs);
  desk.friendlies = friendlies_.list(team, state_.costs);
  desk.progress = progress(team, desk.friendlies);
  desk.opponents = friendlies_.opponents(team);
  {
    const std::lock_guard lock(state_.mutex);
    const HandIns& hand_ins = state_.book.hand_ins();
    desk.playing = hand_ins.playing(team);
    desk.is_pinned = desk.playing > 0 && desk.playing == hand_ins.pinned(team);
  }
  desk.mark = released_mark(team);
  desk.sheets = state_.league.sheets_of(team);
  const HandInTerms terms = state_.terms_of(team);
  desk.deadline = terms.deadline;
  desk.is_late = terms.is_late;
  desk.digest = state_.league.digest_of(team);
  return desk_reply(200, team_desk_page(desk));
}

Json Portal::progress(const std::string& team, const Json& friendlies) const {
  return progress_of(friendlies, [&](int entry) { return friendlies_.drills_of(team, entry); });
}

ReplyOrRefusal Portal::list_friendlies(const Call& call) {
  const Json friendlies = friendlies_.list(call.team, state_.costs);
  const Json progress = this->progress(call.team, friendlies);
  return json_reply(200, {{"team", call.team},
                          {"friendlies", friendlies},
                          {"progress", progress},
                          {"change", change_in_words(progress)},
                          {"opponents", friendlies_.opponents(call.team)}});
}

ReplyOrRefusal Portal::ask_friendly(const Call& call) {
  return friendlies_.ask(call.team, call.request.asked("opponent"));
}

ReplyOrRefusal Portal::show_friendly(const Call& call) {
  return friendlies_.show(call.team, std::string(call.parts[0]), call.parts[1], call.parts[2],
                          web::root_of(call.request.path));
}

ReplyOrRefusal Portal::list_entries(const Call& call) {
  MIROCUP_TRY(const int before, before_of(call));
  MIROCUP_TRY(const Json page, entries_.reports(call.team, before).map_error(host_failed));
  return json_reply(200, page);
}

ReplyOrRefusal Portal::show_entry(const Call& call) {
  MIROCUP_TRY(const Json entry, entry_of(call));
  return json_reply(200, entry);
}

ReplyOrRefusal Portal::tell_entry(const Call& call) {
  MIROCUP_TRY_VOID(entry_of(call));
  return entries_.events(call.team, *number_of(call.parts.front()));
}

ReplyOrRefusal Portal::take(const Call& call) {
  return uploads_.take(call.request, call.body, call.team);
}

// A team chooses the accepted entry that plays: its number, or "latest".
ReplyOrRefusal Portal::pin(const Call& call) {
  const std::string& team = call.team;
  const std::string asked = call.request.asked("entry");
  const auto entry = asked == "latest" ? std::optional(0) : number_of(asked);
  if (!entry) return problem_reply(400, "?entry=N or ?entry=latest is expected");
  MIROCUP_TRY(auto booking, Booking::begin(state_.files, state_.folder).map_error(host_failed));
  const std::lock_guard lock(state_.mutex);
  const std::int64_t now = state_.options.now();
  const HandIns& hand_ins = state_.book.hand_ins();
  // In a ladder each change of a version makes the host play new legs.
  if (hand_ins.pins_in_last_hour(team, now) >= max_pins) {
    return problem_reply(429, team + " has chosen its version " + std::to_string(max_pins) +
                                  " times in the last hour; choose again later");
  }
  MIROCUP_TRY(const auto why_not,
              booking.pin(state_.book, team, *entry, now).map_error(host_failed));
  if (!why_not.empty()) return problem_reply(409, why_not);
  ++state_.version;
  return json_reply(
      200, {{"pinned", *entry > 0 ? Json(*entry) : Json()}, {"playing", hand_ins.playing(team)}});
}

ReplyOrRefusal Portal::list_legs(const Call& call) {
  return json_reply(200,
                    {{"team", call.team},
                     {"legs", own_legs_json(state_.files, state_.folder,
                                            state_.league.legs_of(call.visitor.viewer(), call.team),
                                            state_.costs)}});
}

ReplyOrRefusal Portal::show_log(const Call& call) {
  // Only a leg of the team has a name that is looked for; no path comes from the request.
  for (const OwnLeg& leg : state_.league.legs_of(call.visitor.viewer(), call.team)) {
    if (leg.record.empty() || call.parts.front() != name_of_leg(leg)) continue;
    return log_reply(state_.files, log_path(state_.folder, leg));
  }
  return problem_reply(404, call.team + " has played no leg of this name");
}

ReplyOrRefusal Portal::log_in(const Call& call) {
  const auto form = web::read_form(call.body);
  const std::string root = web::root_of(call.request.path);
  if (!form) return desk_reply(400, log_in_page("the form did not arrive completely", root));
  const std::lock_guard lock(state_.mutex);
  const auto done =
      doorkeeper_.log_in(call.request, value_of(*form, "token"), state_.options.now());
  if (done) return go_to_desk(*done);
  const auto& [status, why, wait] = done.error();
  web::Reply reply = desk_reply(status, log_in_page(why, root));
  if (wait > 0) reply.headers.emplace_back("Retry-After", std::to_string(wait));
  return reply;
}

ReplyOrRefusal Portal::log_out(const Call& call) {
  const std::lock_guard lock(state_.mutex);
  return doorkeeper_.log_out(call.request).map(go_to_desk).map_error(reply_to);
}

ReplyOrRefusal Portal::about_team(const Call& call) {
  const Visitor& visitor = call.visitor;
  const std::lock_guard lock(state_.mutex);
  Json json{{"team", visitor.sees_all() ? Json() : Json(visitor.team)},
            {"staff", visitor.sees_all()},
            {"max_bytes", system::size_limit::entry},
            {"why_not", Json()}};
  if (visitor.sees_all()) return json_reply(200, json);
  const auto allowed = uploads_.expect_allowed(visitor.team, state_.terms_of(visitor.team));
  if (!allowed) json.update({{"why_not", allowed.error().why}, {"status", allowed.error().status}});
  return json_reply(200, json);
}

std::optional<HandedIn> Portal::begin_next() {
  const std::lock_guard lock(state_.mutex);
  const HandedIn* next = state_.book.hand_ins().next();
  if (next == nullptr) return std::nullopt;
  HandedIn begun = *next;
  state_.book.hand_ins().begin(begun.team, begun.entry,
                               source_kind_of(begun.file) == SourceKind::none
                                   ? HandInState::checking
                                   : HandInState::compiling);
  ++state_.version;
  return begun;
}

bool Portal::has_next() {
  const std::lock_guard lock(state_.mutex);
  return state_.book.hand_ins().next() != nullptr;
}

void Portal::set_step(const std::string& team, int entry, const CheckStep& step) {
  const std::lock_guard lock(state_.mutex);
  CheckStep& known = state_.steps[{team, entry}];
  if (known == step) return;
  known = step;
  if (step.number > 0) state_.book.hand_ins().begin(team, entry, HandInState::checking);
  ++state_.version;
}

Result<Submission> Portal::conclude(const std::string& team, int entry) {
  MIROCUP_TRY(auto verdict, read_verdict(state_.files, state_.folder, team, entry));
  if (verdict.is_null()) return fail(Errc::host, team + ": its check has left no verdict");
  MIROCUP_TRY(auto booking, Booking::begin(state_.files, state_.folder));
  const std::lock_guard lock(state_.mutex);
  MIROCUP_TRY_VOID(state_.book.refresh());
  auto done = booking.conclude(state_.book, team, entry, std::move(verdict), state_.options.now(),
                               state_.options.quota);
  MIROCUP_TRY_VOID(note_answer(team, entry));
  return done;
}

Result<void> Portal::close(const Answered& answer) {
  const std::lock_guard lock(state_.mutex);
  const auto written = state_.book.write(answer);
  MIROCUP_TRY_VOID(note_answer(answer.team, answer.entry));
  return written;
}

// Requires the mutex of the state. Without an answer the hand-in waits again.
Result<void> Portal::note_answer(const std::string& team, int entry) {
  state_.steps.erase({team, entry});
  ++state_.version;
  const HandedIn* handed = state_.book.hand_ins().find(team, entry);
  if (handed == nullptr || !is_final(handed->state)) {
    state_.book.hand_ins().wait_again(team, entry);
    return {};
  }
  state_.league.note_own_write();  // the team may have joined
  if (handed->state != HandInState::accepted) return {};
  // Before anybody is told, so that a team that has the answer finds its friendlies.
  return friendlies_.entry_accepted(team, entry);
}

Result<void> Portal::wait_again(const std::string& team, int entry, NoAnswer why, double seconds) {
  Answered answer{.team = team, .entry = entry, .at = state_.options.now()};
  int times = 0;
  {
    const std::lock_guard lock(state_.mutex);
    state_.book.hand_ins().wait_again(team, entry, why);
    state_.steps.erase({team, entry});
    ++state_.version;
    if (const auto* handed = state_.book.hand_ins().find(team, entry)) times = handed->times(why);
  }
  const std::string name = team + ": entry " + std::to_string(entry);
  if (why == NoAnswer::host_failed && times >= max_failures) {
    answer.message = name + " could not be checked, because this computer failed; hand it in again";
  } else if (why == NoAnswer::spent && times >= max_spent) {
    answer.state = HandInState::refused;
    answer.message = name + " was not accepted: its check took more than " +
                     std::to_string(static_cast<int>(seconds)) +
                     " s of processor time, and did so twice; let the team compute less while it "
                     "is loaded and in each tick";
  } else {
    return {};
  }
  MIROCUP_TRY_VOID(close(answer));
  return state_.files.remove(state_.folder.entry(team, entry));
}

std::optional<HandedIn> Portal::to_stop(const std::vector<RunningCheck>& running) {
  const std::lock_guard lock(state_.mutex);
  const HandedIn* stopped = state_.book.hand_ins().to_stop(running);
  return stopped == nullptr ? std::nullopt : std::optional(*stopped);
}

}  // namespace mirocup::league
