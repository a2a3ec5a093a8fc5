// SPDX-License-Identifier: MIT
#include "tournaments/handin/staff_desk.hpp"

#include "system/file_lock.hpp"
#include "system/markup.hpp"
#include "system/number_of.hpp"
#include "tournaments/handin/desk_html.hpp"
#include "tournaments/league/acts.hpp"
#include "tournaments/league/health.hpp"
#include "tournaments/league/roster.hpp"
#include "tournaments/publish/decision_view.hpp"
#include "tournaments/publish/grades.hpp"

#include <algorithm>
#include <map>

namespace mirocup::league {

namespace {

constexpr const char* staff_policy =
    "default-src 'none'; style-src 'self'; script-src 'self'; form-action 'self'; base-uri 'none'; "
    "frame-ancestors 'none'";

// Where the staff finds the legs of a team: its name follows.
const std::string staff_legs_path = "/hand-in?team=";

int number_in(const Form& form, const std::string& key) {
  return system::number_of<int>(value_of(form, key)).value_or(0);
}

// Returns the act that a form asks for; nothing if it names none.
std::optional<Act> act_of(const Form& form) {
  const auto kind = from_string<ActKind>(value_of(form, "act"));
  if (!kind) return std::nullopt;
  return Act{.kind = *kind,
             .fixture = value_of(form, "fixture"),
             .leg = number_in(form, "leg"),
             .has_all_legs = value_of(form, "leg") == "all",
             .team = value_of(form, "team"),
             .keeps_seed = value_of(form, "seed") == "same",
             .score = value_of(form, "score"),
             .results = value_of(form, "results"),
             .from = value_of(form, "from"),
             .is_lifted = !value_of(form, "lift").empty(),
             .level = value_of(form, "level"),
             .through = value_of(form, "through"),
             .decision = number_in(form, "decision"),
             .reason = value_of(form, "reason"),
             .by = value_of(form, "by"),
             .is_dry_run = value_of(form, "go") == "try"};
}

std::string attribute(std::string_view name, const std::string& value) {
  return " " + std::string(name) + "=\"" + system::html_escaped(value) + "\"";
}

// A text field with its label.
void field(Html& html, const std::string& act, const std::string& name, const std::string& label,
           bool is_needed, const std::string& more = "") {
  const std::string id = act + "-" + name;
  html.raw("<p><label" + attribute("for", id) + ">" + system::html_escaped(label) +
           "</label> <input" + attribute("id", id) + attribute("name", name) +
           (is_needed ? " required" : "") + more + "></p>\n");
}

void choice(Html& html, const std::string& act, const std::string& name, const std::string& label,
            const std::vector<std::pair<std::string, std::string>>& options) {
  const std::string id = act + "-" + name;
  html.raw("<p><label" + attribute("for", id) + ">" + system::html_escaped(label) +
           "</label> <select" + attribute("id", id) + attribute("name", name) + ">");
  for (const auto& [value, text] : options)
    html.raw("<option" + attribute("value", value) + ">" + system::html_escaped(text) +
             "</option>");
  html.raw("</select></p>\n");
}

// The forms of the acts, each with its reason.
class Forms {
 public:
  Forms(Html& html, const LeagueState& state) : html_(html) {
    for (int i = 0; i < static_cast<int>(state.teams.size()); ++i)
      teams_.emplace_back(state.name(i), state.shown_name(i));
    html_.raw("<datalist id=\"fixtures\">");
    for (const FixtureState& f : state.fixtures) {
      if (!f.fixture.has_both()) continue;
      html_.raw("<option" + attribute("value", f.fixture.id()) + ">" +
                system::html_escaped(state.shown_name(f.fixture.home) + " – " +
                                     state.shown_name(f.fixture.away)) +
                "</option>");
    }
    html_.raw("</datalist>\n");
  }

  void all() {
    open("rule", "Decide the score of a leg");
    fixture("rule");
    field(html_, "rule", "score", "Score, home:away", true, " placeholder=\"2:1\" size=\"8\"");
    close("rule");
    open("award", "Give a leg to a team, as by a forfeit");
    fixture("award");
    choice(html_, "award", "team", "Team", teams_);
    close("award");
    open("void", "Declare a leg void: it is played again");
    fixture("void");
    choice(html_, "void", "seed", "With", {{"new", "another seed"}, {"same", "the same seed"}});
    close("void");
    open("pause", "Pause a team: no leg of it is started");
    choice(html_, "pause", "team", "Team", teams_);
    close("pause");
    open("resume", "Let a paused team play on");
    choice(html_, "resume", "team", "Team", teams_);
    close("resume");
    open("withdraw", "Take a team out of the league");
    choice(html_, "withdraw", "team", "Team", teams_);
    choice(html_, "withdraw", "results", "Its results",
           {{"keep", "stay; the others win what is left"}, {"annul", "count for nothing"}});
    close("withdraw");
    open("freeze", "Take no entries from a time on");
    field(html_, "freeze", "from", "Time, empty for now", false,
          " placeholder=\"2026-11-30T18:00:00\"");
    html_.raw(
        "<p><label><input type=\"checkbox\" name=\"lift\" value=\"yes\"> take entries again"
        "</label></p>\n");
    close("freeze");
    open("release", "Say which rounds the pages show");
    choice(html_, "release", "level", "For",
           {{"all", "everybody"}, {"teams", "teams: each its own digest"}, {"hidden", "nobody"}});
    field(html_, "release", "through", "The last round that is shown", false,
          " placeholder=\"r3\" size=\"8\"");
    close("release");
    open("close", "End the league: no night follows, no entry is taken");
    close("close");
    open("undo", "Take a decision back");
    field(html_, "undo", "decision", "Its number in the list", true, " type=\"number\" min=\"1\"");
    close("undo");
    open("people", "Say by what name people know a team, and who is in it");
    choice(html_, "people", "team", "Team", teams_);
    field(html_, "people", "display", "Name", false);
    field(html_, "people", "members", "Members, with ; between them", false, " size=\"50\"");
    write();
    open("colour", "Give a team the colour of the mark beside its name");
    choice(html_, "colour", "team", "Team", teams_);
    field(html_, "colour", "colour", "Colour, empty for none", false,
          " placeholder=\"#c03a2b\" size=\"8\" maxlength=\"7\"");
    write();
  }

 private:
  void open(const std::string& act, const std::string& title) {
    html_.raw("<details class=\"act\"><summary>" + system::html_escaped(title) +
              "</summary>\n<form class=\"desk\" method=\"post\" action=\"/hand-in/staff\"><input "
              "type=\"hidden\" "
              "name=\"act\"" +
              attribute("value", act) + ">\n");
  }

  void write() {
    html_.raw("<p><button name=\"go\" value=\"do\">Write</button></p></form></details>\n");
  }

  void fixture(const std::string& act) {
    field(html_, act, "fixture", "Fixture", true,
          " list=\"fixtures\" placeholder=\"r3-f1\" size=\"12\"");
    choice(html_, act, "leg", "Leg", {{"1", "1"}, {"2", "2"}, {"3", "3"}, {"all", "all legs"}});
  }

  void close(const std::string& act) {
    field(html_, act, "reason", "Reason, which is published", true,
          " size=\"50\" maxlength=\"300\"");
    field(html_, act, "by", "Who decides", false);
    html_.raw(
        "<p><button name=\"go\" value=\"try\">Try: what would change</button> <button "
        "name=\"go\" value=\"do\">Decide</button></p></form></details>\n");
  }

  Html& html_;
  std::vector<std::pair<std::string, std::string>> teams_;
};

std::string joined_with(const std::vector<std::string>& words, const char* between) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
  return text;
}

void teams_table(Html& html, const LeagueFile& file, const std::vector<RosterRow>& rows) {
  html.open_table();
  html.row("th", {"Team", "Name", "Members", "Handed in", "State", "Plays with", "Answer"});
  for (const RosterRow& row : rows) {
    html.open("tr");
    html.open("th");
    html.link(staff_legs_path + row.team, row.team);
    html.close("th");
    html.cell("td", row.people.display);
    html.cell_of("small", joined_with(row.people.members, "; "));
    html.cell("td", row.handed_in.empty() ? "" : shown_time(file, row.handed_in));
    std::string state = row.state();
    if (row.status == TeamStatus::paused) state += ", paused: " + row.why;
    if (row.status == TeamStatus::withdrawn) state += ", has withdrawn";
    if (!row.has_joined) state += ", not in the league";
    html.cell("td", state);
    html.cell("td", row.playing_entry > 0 ? "entry " + std::to_string(row.playing_entry)
                    : row.last_accepted > 0
                        ? "entry " + std::to_string(row.last_accepted) + ", next"
                        : "");
    std::string answer = row.was_accepted ? "" : row.message;
    if (!row.same_as.empty())
      answer += (answer.empty() ? "" : " ") + std::string("The same file as ") +
                joined_with(row.same_as, ", ") + ".";
    html.cell_of("words", answer);
    html.close("tr");
  }
  html.close_table();
}

void attention(Html& html, const std::vector<RosterRow>& rows, const Health& health) {
  std::vector<std::string> missing;
  std::vector<std::string> refused;
  std::vector<std::string> same;
  for (const RosterRow& row : rows) {
    if (row.status == TeamStatus::withdrawn) continue;
    if (row.last_entry == 0 && row.handed_in.empty()) missing.push_back(row.team);
    if (!row.handed_in.empty() && !row.was_accepted && row.has_ended) refused.push_back(row.team);
    for (const std::string& other : row.same_as) {
      if (row.team < other) same.push_back(row.team + " and " + other);
    }
  }
  html.open("ul");
  for (const std::string& problem : health.problems) html.cell("li", problem);
  html.cell("li", "Not handed in: " + (missing.empty() ? "nobody" : joined_with(missing, ", ")));
  html.cell("li",
            "Last hand-in refused: " + (refused.empty() ? "nobody" : joined_with(refused, ", ")));
  html.cell("li", "The same file: " + (same.empty() ? "nobody" : joined_with(same, ", ")));
  html.close("ul");
}

void decisions_list(Html& html, const LeagueState& state, int done) {
  const auto views = decision_views(state);
  if (views.empty()) {
    html.cell("p", "Nothing was decided yet.");
    return;
  }
  html.open_table();
  html.row("th", {"No.", "When", "Who", "What", "Why", ""});
  for (const DecisionView& d : views) {
    html.open(d.number == done ? "tr class=\"chosen\"" : "tr");
    html.cell_of("number", std::to_string(d.number));
    html.cell("td", d.at.empty() ? "" : shown_time(state.file, d.at));
    html.cell("td", d.by);
    html.cell("td", d.what);
    html.cell("td", d.why);
    html.cell_of("small", d.undoing);
    html.close("tr");
  }
  html.close_table();
}

web::Reply staff_reply(int status, std::string html) {
  return {.status = status,
          .type = "text/html; charset=utf-8",
          .bytes = std::move(html),
          .headers = {{"Content-Security-Policy", staff_policy}, {"Cache-Control", "no-store"}}};
}

// The host is told the reason, so the staff is, too.
web::Reply broken(const Error& error) {
  return {.status = 503, .bytes = error.what + "\n"};
}

Result<void> set_people(system::Files& files, const LeagueStore& store, const Form& form) {
  const std::string team = value_of(form, "team");
  if (!store.state().find_team(team)) return fail(Errc::input, "there is no team " + team);
  MIROCUP_TRY(const auto lock, system::FileLock::acquire(store.folder().lock()));
  MIROCUP_TRY(auto people, read_people(files, store.folder()));
  People& one = people[team];
  if (value_of(form, "act") == "colour") {
    if (auto set = set_colour(one, value_of(form, "colour")); !set) return set;
    return write_people(files, store.folder(), people);
  }
  one.display = value_of(form, "display");
  one.members = members_of(value_of(form, "members"));
  if (const std::string why = objection_to(one); !why.empty()) return fail(Errc::input, why);
  if (const std::string other = looks_like(people, store.state(), team, one.display);
      !one.display.empty() && !other.empty())
    return fail(Errc::input, other + " is called so already");
  return write_people(files, store.folder(), people);
}

}  // namespace

web::Reply StaffDesk::page(Role reader, int done, const std::string& said, int status) const {
  const bool has_forms = reader == Role::staff;
  const auto store = LeagueStore::open(files_, folder_);
  if (!store) return broken(store.error());
  const auto rows = roster(files_, *store);
  if (!rows) return broken(rows.error());
  const auto health = league::health(files_, *store, now_());
  if (!health) return broken(health.error());
  const LeagueState& state = store->state();
  Html html;
  log_out_button(html);
  if (!has_forms) html.cell("p", "This token reads what the staff reads, and decides nothing.");
  if (!said.empty()) html.raw("<p role=\"alert\">" + system::html_escaped(said) + "</p>\n");
  if (done > 0)
    html.raw("<p role=\"status\">Decision " + std::to_string(done) + " is written.</p>\n");
  html.open("ul");
  html.cell("li", std::to_string(state.played()) + " of " + std::to_string(state.legs()) +
                      " legs are decided, " + std::to_string(state.nights.size()) + " nights");
  if (const std::string at = last_leg_at(store->journal()); !at.empty())
    html.cell("li", "The last leg was played at " + shown_time(state.file, at));
  const std::string frozen = state.freeze ? *state.freeze : state.file.freeze;
  html.cell("li", frozen.empty() ? "Entries are taken as the format allows"
                                 : "No entry is taken from " + shown_time(state.file, frozen));
  if (state.is_closed) html.cell("li", "The league is closed");
  html.close("ul");
  next_card(html, "To look at");
  attention(html, *rows, *health);
  next_card(html, "Teams");
  teams_table(html, state.file, *rows);
  html.raw("<p><a href=\"/hand-in/grades.csv\">Grades (CSV)</a></p>\n");
  if (has_forms) {
    next_card(html, "Decide");
    Forms(html, state).all();
  }
  next_card(html, "Decisions");
  decisions_list(html, state, done);
  return staff_reply(status, desk_page("Staff", html));
}

web::Reply StaffDesk::legs_of(const std::string& team, const std::vector<OwnLeg>& legs) const {
  Html html;
  html.raw("<p><a href=\"/hand-in\">Back to the staff page</a></p>\n");
  if (legs.empty()) html.cell("p", "No leg of it is decided, or there is no such team.");
  html.open_table();
  html.row("th", {"Leg", "Opponent", "Result", "Replay", "Log", "Own fault"});
  for (auto leg = legs.rbegin(); leg != legs.rend(); ++leg) {
    html.open("tr");
    html.cell("th", leg->fixture + ", leg " + std::to_string(leg->leg));
    html.cell("td", leg->opponent);
    html.cell("td", std::to_string(leg->goals) + " : " + std::to_string(leg->against));
    if (leg->record.empty()) {
      html.cell("td", "");
      html.cell("td", "");
    } else {
      const std::string name = name_of_leg(*leg);
      const bool is_drawn =
          record::has_thoughts(files_, folder_.path + "/" + leg->record, record::of_both);
      html.link_cell(std::string(own_replays_path) + name + ".html?team=" + team,
                     is_drawn ? "replay with thoughts" : "replay");
      html.link_cell("/api/v1/legs/" + name + "/log?team=" + team, "log");
    }
    html.cell_of("small", leg->own_fault.value_or(""));
    html.close("tr");
  }
  html.close_table();
  return staff_reply(200, desk_page("Legs of " + team, html));
}

web::Reply StaffDesk::act(const Form& values) const {
  auto store = LeagueStore::open(files_, folder_);
  if (!store) return broken(store.error());
  const std::string act = value_of(values, "act");
  if (act == "people" || act == "colour") {
    if (const auto set = set_people(files_, *store, values); !set)
      return page(Role::staff, 0, set.error().what, 400);
    return {.status = 303, .bytes = "", .headers = {{"Location", "/hand-in"}}};
  }
  const auto wanted = act_of(values);
  if (!wanted) return page(Role::staff, 0, "The form names no act.", 400);
  const auto lines = perform(files_, *store, *wanted, now_());
  if (!lines) return page(Role::staff, 0, lines.error().what, 400);
  if (wanted->is_dry_run) return page(Role::staff, 0, joined_with(*lines, "; "));
  return {.status = 303,
          .bytes = "",
          .headers = {
              {"Location", "/hand-in?done=" + std::to_string(store->state().decisions.size())}}};
}

web::Reply StaffDesk::grades() const {
  const auto store = LeagueStore::open(files_, folder_);
  if (!store) return broken(store.error());
  const auto people = everybody(files_, *store);
  if (!people) return broken(people.error());
  auto file = league::grades(overview(store->state()), *people, "", "");
  if (!file) return broken(file.error());
  return {.status = 200,
          .type = "text/csv; charset=utf-8",
          .bytes = std::move(file->bytes),
          .headers = {{"Content-Disposition", "attachment; filename=\"grades.csv\""},
                      {"Cache-Control", "no-store"}}};
}

}  // namespace mirocup::league
