// SPDX-License-Identifier: MIT
#include "tournaments/handin/staff_desk.hpp"

#include "system/file_lock.hpp"
#include "system/number_of.hpp"
#include "system/text.hpp"
#include "tournaments/handin/replies.hpp"
#include "tournaments/handin/team_desk_page.hpp"
#include "tournaments/league/acts.hpp"
#include "tournaments/league/book.hpp"
#include "tournaments/league/health.hpp"
#include "tournaments/league/roster.hpp"
#include "tournaments/publish/front_page.hpp"
#include "tournaments/publish/grades.hpp"
#include "tournaments/publish/page_values.hpp"
#include "tournaments/publish/rounds.hpp"

namespace mirocup::league {

namespace {

int number_in(const Form& form, const std::string& key) {
  return system::number_of<int>(value_of(form, key)).value_or(0);
}

// Returns the act that a form asks for; nothing if it names none.
std::optional<Act> act_of(const Form& form) {
  const bool is_extension = value_of(form, "act") == "extend";
  const auto kind = from_string<ActKind>(is_extension ? "freeze" : value_of(form, "act"));
  if (!kind) return std::nullopt;
  return Act{.kind = *kind,
             .fixture = value_of(form, "fixture"),
             .leg = number_in(form, "leg"),
             .has_all_legs = value_of(form, "leg") == "all",
             .team = value_of(form, "team"),
             .keeps_seed = value_of(form, "seed") == "same",
             .score = value_of(form, "score"),
             .results = value_of(form, "results"),
             .except = is_extension ? value_of(form, "team") : "",
             .from = value_of(form, "from"),
             .is_lifted = !value_of(form, "lift").empty(),
             .level = value_of(form, "level"),
             .through = value_of(form, "through"),
             .decision = number_in(form, "decision"),
             .reason = value_of(form, "reason"),
             .by = value_of(form, "by"),
             .is_dry_run = value_of(form, "go") == "try"};
}

// The values of the forms of the acts. A form shows again what it had before it was sent, and the
// answer; each act on legs means the leg from whose replay a person comes.
Json forms_values(const LeagueState& state, const StaffDesk::Shown& shown,
                  const std::string& person) {
  const Form& given = shown.given;
  Json values{{"root", shown.root},
              {"person", person},
              {"max_notice", max_notice},
              {"notice", state.notice},
              {"fixtures", Json::array()}};
  for (const FixtureState& f : state.fixtures) {
    if (!f.fixture.has_both()) continue;
    const std::string id = f.fixture.id();
    const std::string teams =
        state.shown_name(f.fixture.home) + " – " + state.shown_name(f.fixture.away);
    values["fixtures"].push_back({{"id", id}, {"teams", teams}});
    if (id == value_of(given, "fixture")) values["meant"] = id + ": " + teams;
  }
  const std::string sent = value_of(given, "act");
  for (const std::string act : {"rule", "award", "void", "pause", "resume", "withdraw", "freeze",
                                "extend", "release", "close", "undo", "people"}) {
    const bool is_meant = sent.empty() || sent == act;
    const bool is_on_leg = act == "rule" || act == "award" || act == "void";
    const bool is_open =
        sent == act || (is_on_leg && is_meant && !value_of(given, "fixture").empty());
    Json form{{"act", act},
              {"is_open", is_open},
              {"is_private", act == "extend"},
              {"said", sent == act ? shown.said : ""},
              {"role", shown.status < 400 ? "status" : "alert"},
              {"given", Json::object()}};
    for (const auto& [name, value] : is_meant ? given : Form()) {
      if (form["given"].contains(name)) continue;
      form["given"][name] = value;
      form["chosen"][name][value] = true;
    }
    for (int i = 0; i < static_cast<int>(state.teams.size()); ++i)
      form["teams"].push_back(
          {{"name", state.name(i)},
           {"is_chosen", state.name(i) == record::text_in(form["given"], "team")},
           {"shown", state.shown_name(i)}});
    values[act] = form;
  }
  return values;
}

// What was played last, what comes, and until when entries are taken.
void add_schedule(Json& values, const LeagueState& state, const SheetDeadlines& sheets) {
  const std::string& frozen = state.frozen_from();
  values["entries"] = frozen.empty() ? "Entries are taken as the format allows"
                                     : "Deadline for entries: " + shown_time(state.file, frozen);
  values["deadlines"] = Json::array();
  auto extensions = state.file.extensions;
  for (const auto& [team, until] : state.extensions) extensions[team] = until;
  for (const auto& [team, until] : extensions)
    values["deadlines"].push_back(state.shown_name_of(team) + " may hand in until " +
                                  shown_time(state.file, until));
  for (const auto& [sheet, deadline] : sheets) {
    std::string line = "Sheet " + sheet + ": until " + shown_time(state.file, deadline.until);
    if (deadline.grace != deadline.until)
      line += ", with grace until " + shown_time(state.file, deadline.grace);
    for (const auto& [team, until] : deadline.extensions)
      line += "; " + state.shown_name_of(team) + " until " + shown_time(state.file, until);
    values["deadlines"].push_back(line);
  }
  if (!state.nights.empty())
    values["night"] = "Night " + std::to_string(state.nights.back().number) + " began at " +
                      shown_time(state.file, state.nights.back().at);
  constexpr int most = 6;  // rounds
  int left = 0;
  const Overview o = overview(state);
  values["rounds"] = Json::array();
  for (const RoundView& round : rounds_of(o)) {
    if (round.decided == round.legs && !round.fixtures.empty()) continue;
    if (++left <= most)
      values["rounds"].push_back({{"page", round.page()},
                                  {"title", round.title},
                                  {"decided", round.decided},
                                  {"legs", round.legs}});
  }
  values["end"] = left > most       ? "and " + std::to_string(left - most) + " more rounds"
                  : left > 0        ? ""
                  : state.is_closed ? "The league is closed"
                  : state.file.format.kind == FormatKind::nightly
                      ? "The next night begins when league nightly is started"
                      : "Nothing is left to play";
}

// The staff reads the names of people in an anonymous league, too.
std::string name_of(const RosterRow& row) {
  return row.people.display.empty() ? row.team : row.people.display;
}

Json teams_values(const LeagueState& state, const std::vector<RosterRow>& rows) {
  Json teams = Json::array();
  for (const RosterRow& row : rows) {
    std::vector<std::string> about = row.people.members;
    if (!row.people.display.empty()) about.insert(about.begin(), row.team);
    std::string answer = row.was_accepted ? "" : row.message;
    for (const std::string& note : row.notes) answer += (answer.empty() ? "" : " ") + note + ".";
    if (!row.same_as.empty())
      answer += (answer.empty() ? "" : " ") + std::string("The same file as ") +
                system::joined(row.same_as, ", ") + ".";
    teams.push_back(
        {{"team", row.team},
         {"name", name_of(row)},
         {"about", system::joined(about, " · ")},
         {"handed_in", row.handed_in.empty() ? "" : shown_time(state.file, row.handed_in)},
         {"state", row.state() + row.standing()},
         {"answer", answer}});
  }
  return teams;
}

// The teams that something is said of.
Json attention_values(const std::vector<RosterRow>& rows) {
  Json missing = Json::array(), refused = Json::array(), same = Json::array(),
       noted = Json::array();
  for (const RosterRow& row : rows) {
    if (row.status == TeamStatus::withdrawn) continue;
    const auto add = [&row](Json& teams) {
      teams.push_back({{"team", row.team}, {"name", name_of(row)}, {"is_next", !teams.empty()}});
    };
    if (row.is_missing()) add(missing);
    if (row.was_refused()) add(refused);
    if (!row.same_as.empty()) add(same);
    if (!row.notes.empty()) add(noted);
  }
  return {{{"what", "Not handed in:"}, {"teams", missing}},
          {{"what", "Last hand-in refused:"}, {"teams", refused}},
          {{"what", "With notes, see the table:"}, {"teams", noted}},
          {{"what", "The same file as another team, see the table:"}, {"teams", same}}};
}

Result<void> set_people(system::Files& files, const LeagueStore& store, const Form& form) {
  return change_people(files, store.folder(), store.state(), value_of(form, "team"),
                       [&form](People& one) {
                         one.display = value_of(form, "display");
                         one.members = members_of(value_of(form, "members"));
                       })
      .map([](const People&) {});
}

// A form ends its lines with two characters.
Result<void> set_notice(system::Files& files, const Folder& folder, std::string text) {
  std::erase(text, '\r');
  MIROCUP_TRY(const auto lock, system::FileLock::acquire(folder.lock()));
  return write_notice(files, folder, text);
}

}  // namespace

Result<web::Reply> StaffDesk::page(const Visitor& reader, const Shown& shown) const {
  const bool has_forms = decides(reader.role);
  MIROCUP_TRY(const auto store, LeagueStore::open(files_, folder_));
  MIROCUP_TRY(const auto book, Book::open(files_, folder_));
  MIROCUP_TRY(const auto rows, roster(files_, store, book.hand_ins()));
  const LeagueState& state = store.state();
  MIROCUP_TRY(const auto sheets, read_sheet_deadlines(files_, folder_, state.file));
  MIROCUP_TRY(const auto health, league::health(files_, store, book.hand_ins(), now_()));
  const std::string last = last_leg_at(store.journal());
  Json decisions = decisions_values(state);
  for (Json& one : decisions) one["is_new"] = one["number"] == shown.done;
  const Json forms = forms_values(state, shown, reader.person);
  const auto sent = forms.find(value_of(shown.given, "act"));
  Json values{{"has_forms", has_forms},
              {"root", shown.root},
              {"sees_grades", sees_grades(reader.role)},
              {"said", sent != forms.end() && sent->is_object() ? "" : shown.said},
              {"done", shown.done > 0 ? Json(shown.done) : Json()},
              {"played", state.played()},
              {"legs", state.legs()},
              {"last_leg", last.empty() ? "" : shown_time(state.file, last)},
              {"problems", health.problems},
              {"attention", attention_values(rows)},
              {"forms", has_forms ? filled_page("staff_forms.html", forms) : ""},
              {"teams", teams_values(state, rows)},
              {"decisions", decisions}};
  add_schedule(values, state, sheets);
  return desk_reply(shown.status,
                    desk_page("Staff", filled_page("staff.html", values), shown.root));
}

std::string StaffDesk::decision_path(const OwnLeg& leg) {
  return "hand-in?fixture=" + leg.fixture + "&leg=" + std::to_string(leg.leg) + "#decide";
}

Result<web::Reply> StaffDesk::legs_of(const Visitor& reader, const std::string& team,
                                      const std::vector<OwnLeg>& legs) const {
  MIROCUP_TRY(const auto store, LeagueStore::open(files_, folder_));
  const LeagueState& state = store.state();
  Json rows = Json::array();
  for (auto leg = legs.rbegin(); leg != legs.rend(); ++leg) {
    Json row{{"fixture", leg->fixture},
             {"leg", leg->leg},
             {"opponent", state.shown_name_of(leg->opponent)},
             {"score", std::to_string(leg->goals) + " : " + std::to_string(leg->against)},
             {"fault", leg->own_fault.value_or("")},
             {"decide", decides(reader.role) ? decision_path(*leg) : ""}};
    if (!leg->record.empty()) {
      const std::string name = name_of_leg(*leg);
      const bool is_drawn =
          record::has_thoughts(files_, folder_.path + "/" + leg->record, record::of_both);
      row["what"] = is_drawn ? "replay with thoughts" : "replay";
      row["replay"] = std::string(own_replays_path.substr(1)) + name + ".html?team=" + team;
      row["log"] = "api/v1/legs/" + name + "/log?team=" + team;
    }
    rows.push_back(row);
  }
  MIROCUP_TRY(const auto book, Book::open(files_, folder_));
  Json entries = Json::array();
  for (const auto& [number, handed] : book.hand_ins().of_team(team))
    entries.push_back(
        {{"number", number},
         {"team", team},
         {"state", handed.is_late && handed.is_accepted() ? "late" : to_string(handed.state)}});
  return desk_reply(
      200, desk_page("Legs of " + state.shown_name_of(team),
                     filled_page("staff_legs.html", {{"entries", entries}, {"legs", rows}})));
}

Result<web::Reply> StaffDesk::act(const Visitor& visitor, const Form& values,
                                  const std::string& root) const {
  MIROCUP_TRY(auto store, LeagueStore::open(files_, folder_));
  const std::string act = value_of(values, "act");
  const auto refused = [&](const std::string& why) {
    return page(visitor, {.said = why, .status = 400, .given = values, .root = root});
  };
  if (act == "people" || act == "notice") {
    if (const auto set = act == "notice" ? set_notice(files_, folder_, value_of(values, "text"))
                                         : set_people(files_, store, values);
        !set)
      return refused(set.error().what);
    return moved_to(root + "hand-in");
  }
  auto wanted = act_of(values);
  if (wanted && !visitor.person.empty()) wanted->by = visitor.person;
  if (!wanted) return refused("The form does not say what to decide.");
  const auto lines = perform(files_, store, *wanted, now_());
  if (!lines) return refused(lines.error().what);
  // Before the start a decision changes league.json, and has no number.
  if (wanted->is_dry_run || !store.state().is_started)
    return page(visitor, {.said = system::joined(*lines, "; "), .given = values, .root = root});
  return moved_to(root + "hand-in?done=" + std::to_string(store.state().decisions.size()) +
                  "#decisions");
}

Result<web::Reply> StaffDesk::grades() const {
  MIROCUP_TRY(const auto store, LeagueStore::open(files_, folder_));
  MIROCUP_TRY(const auto people, everybody(files_, store));
  MIROCUP_TRY(auto file, league::grades(overview(store.state()), people, "", ""));
  return web::Reply{.status = 200,
                    .type = "text/csv; charset=utf-8",
                    .bytes = std::move(file.bytes),
                    .headers = {{"Content-Disposition", "attachment; filename=\"grades.csv\""}}};
}

}  // namespace mirocup::league
