// SPDX-License-Identifier: MIT
#include "tournaments/handin/staff_desk.hpp"

#include "system/file_lock.hpp"
#include "system/number_of.hpp"
#include "system/text.hpp"
#include "tournaments/handin/desk_html.hpp"
#include "tournaments/league/acts.hpp"
#include "tournaments/league/health.hpp"
#include "tournaments/league/roster.hpp"
#include "tournaments/publish/decision_view.hpp"
#include "tournaments/publish/grades.hpp"
#include "tournaments/publish/rounds.hpp"

#include <algorithm>
#include <map>

namespace mirocup::league {

namespace {

constexpr const char* staff_policy =
    "default-src 'none'; style-src 'self'; script-src 'self'; form-action 'self'; base-uri 'none'; "
    "frame-ancestors 'none'";

// Where the staff finds the legs of a team: its name follows.
const std::string staff_legs_path = "/hand-in?team=";

std::string jump_list(bool has_forms) {
  std::string links = "<nav aria-label=\"On this page\">";
  for (const auto& [target, text] : std::initializer_list<std::pair<std::string, const char*>>{
           {"#look", "To look at"},
           {"#schedule", "Schedule"},
           {"#notice", "Notice"},
           {"#decide", "Decide"},
           {"#teams", "Teams"},
           {"#decisions", "Decisions"},
           {"/hand-in/grades.csv", "Grades"}}) {
    if (!has_forms && (target == "#notice" || target == "#decide")) continue;
    links += "<a href=\"" + target + "\">" + text + "</a> ";
  }
  return links + "</nav>\n";
}

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

// The forms of the acts, each with its reason. `given` is what a form had before it was sent, so
// that nobody types it again, or the leg from whose replay a person comes.
class Forms {
 public:
  Forms(Html& html, const LeagueState& state, const Form& given)
      : html_(html), state_(state), given_(given) {
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
    if (const auto index = state_.find_fixture(value_of(given_, "fixture"))) {
      const Fixture& f = state_.fixtures[*index].fixture;
      if (f.has_both())
        html_.cell("p",
                   f.id() + ": " + state_.shown_name(f.home) + " – " + state_.shown_name(f.away));
    }
    open("rule", "Decide the score of a leg");
    fixture("rule");
    field("rule", "score", "Score, home:away", true, " placeholder=\"2:1\" size=\"8\"");
    close("rule");
    open("award", "Award a leg to a team, as if its opponent had forfeited");
    fixture("award");
    choice("award", "team", "Team", teams_);
    close("award");
    open("void", "Declare a leg void: it is played again");
    fixture("void");
    choice("void", "seed", "With", {{"new", "another seed"}, {"same", "the same seed"}});
    close("void");
    open("pause", "Pause a team: no leg of it is started");
    choice("pause", "team", "Team", teams_);
    close("pause");
    open("resume", "Let a paused team play again");
    choice("resume", "team", "Team", teams_);
    close("resume");
    open("withdraw", "Take a team out of the league");
    choice("withdraw", "team", "Team", teams_);
    choice("withdraw", "results", "Its results",
           {{"keep", "stay; its opponents win the legs that are left"},
            {"annul", "count for nothing"}});
    close("withdraw");
    open("freeze", "Stop taking entries, now or at a given time");
    field("freeze", "from", "Time (if empty: now)", false, " placeholder=\"2026-11-30T18:00:00\"");
    html_.raw(
        "<p><label><input type=\"checkbox\" name=\"lift\" value=\"yes\"> take entries again"
        "</label></p>\n");
    close("freeze");
    open("release", "Choose the rounds that the pages show");
    choice("release", "level", "For",
           {{"all", "everybody"},
            {"teams", "teams: each team reads its own digest"},
            {"hidden", "nobody"}});
    field("release", "through", "The last round that is shown", false,
          " placeholder=\"r3\" size=\"8\"");
    close("release");
    open("close", "End the league: no night follows, no entry is taken");
    close("close");
    open("undo", "Take a decision back");
    field("undo", "decision", "Number of the decision in the list", true,
          " type=\"number\" min=\"1\"");
    close("undo");
    open("people", "Set the name of a team that people see, and its members");
    choice("people", "team", "Team", teams_);
    field("people", "display", "Name", false);
    field("people", "members", "Members, with ; between them", false, " size=\"50\"");
    write();
    open("colour", "Give the mark beside a team's name a colour");
    choice("colour", "team", "Team", teams_);
    field("colour", "colour", "Colour (if empty: none)", false,
          " placeholder=\"#c03a2b\" size=\"8\" maxlength=\"7\"");
    write();
  }

 private:
  // What a form of this act had in a field; a leg that is given is meant by each act on legs.
  std::string given(const std::string& act, const std::string& name) const {
    const std::string whose = value_of(given_, "act");
    return whose.empty() || whose == act ? value_of(given_, name) : "";
  }

  // A text field with its label.
  void field(const std::string& act, const std::string& name, const std::string& label,
             bool is_needed, const std::string& more = "") {
    const std::string id = act + "-" + name;
    html_.raw("<p><label" + attribute("for", id) + ">" + system::html_escaped(label) +
              "</label> <input" + attribute("id", id) + attribute("name", name) +
              attribute("value", given(act, name)) + (is_needed ? " required" : "") + more +
              "></p>\n");
  }

  void choice(const std::string& act, const std::string& name, const std::string& label,
              const std::vector<std::pair<std::string, std::string>>& options) {
    const std::string id = act + "-" + name;
    html_.raw("<p><label" + attribute("for", id) + ">" + system::html_escaped(label) +
              "</label> <select" + attribute("id", id) + attribute("name", name) + ">");
    for (const auto& [value, text] : options)
      html_.raw("<option" + attribute("value", value) +
                (value == given(act, name) ? " selected>" : ">") + system::html_escaped(text) +
                "</option>");
    html_.raw("</select></p>\n");
  }

  void open(const std::string& act, const std::string& title) {
    const bool is_on_leg = act == "rule" || act == "award" || act == "void";
    const bool is_given =
        value_of(given_, "act") == act || (is_on_leg && !given(act, "fixture").empty());
    html_.raw("<details class=\"act\"" + std::string(is_given ? " open" : "") + "><summary>" +
              system::html_escaped(title) +
              "</summary>\n<form class=\"desk\" method=\"post\" action=\"/hand-in/staff\"><input "
              "type=\"hidden\" "
              "name=\"act\"" +
              attribute("value", act) + ">\n");
  }

  void write() {
    html_.raw("<p><button name=\"go\" value=\"do\">Write</button></p></form></details>\n");
  }

  void fixture(const std::string& act) {
    field(act, "fixture", "Fixture", true, " list=\"fixtures\" placeholder=\"r3-f1\" size=\"12\"");
    choice(act, "leg", "Leg", {{"1", "1"}, {"2", "2"}, {"3", "3"}, {"all", "all legs"}});
  }

  void close(const std::string& act) {
    field(act, "reason", "Reason, which is published", true, " size=\"50\" maxlength=\"300\"");
    field(act, "by", "Who decides", false);
    html_.raw(
        "<p><button name=\"go\" value=\"try\">Try: what would change</button> <button "
        "name=\"go\" value=\"do\">Decide</button></p></form></details>\n");
  }

  Html& html_;
  const LeagueState& state_;
  const Form& given_;
  std::vector<std::pair<std::string, std::string>> teams_;
};

// The form of what everybody reads at the top of the front page.
void notice_form(Html& html, const std::string& notice) {
  html.raw(
      "<form class=\"desk\" method=\"post\" action=\"/hand-in/staff\"><input type=\"hidden\" "
      "name=\"act\" value=\"notice\">\n<p><label for=\"text\">The notice stands at the top of the "
      "front page. An empty notice is not shown.</label></p>\n<p><textarea id=\"text\" "
      "name=\"text\" rows=\"3\"" +
      attribute("maxlength", std::to_string(max_notice)) + ">" + system::html_escaped(notice) +
      "</textarea></p>\n<p><button>Write</button></p></form>\n");
}

// What was played last, what comes, and until when entries are taken.
void schedule(Html& html, const LeagueState& state) {
  html.open("ul");
  const std::string& frozen = state.frozen_from();
  html.cell("li", frozen.empty()
                      ? "Entries are taken as the format allows"
                      : "From " + shown_time(state.file, frozen) + " on, no entry is taken");
  if (!state.nights.empty())
    html.cell("li", "Night " + std::to_string(state.nights.back().number) + " began at " +
                        shown_time(state.file, state.nights.back().at));
  constexpr int most = 6;  // rounds
  int left = 0;
  const Overview o = overview(state);
  for (const RoundView& round : rounds_of(o)) {
    if (round.decided == round.legs && !round.fixtures.empty()) continue;
    if (++left > most) continue;
    html.open("li");
    html.link("/" + round.page(), round.title);
    html.cell("small", " " + std::to_string(round.decided) + " of " + std::to_string(round.legs) +
                           " legs are decided");
    html.close("li");
  }
  if (left > most) html.cell("li", "and " + std::to_string(left - most) + " more rounds");
  if (left == 0 && state.is_closed) html.cell("li", "The league is closed");
  if (left == 0 && !state.is_closed)
    html.cell("li", state.file.format.kind == FormatKind::nightly
                        ? "The next night begins when league nightly is started"
                        : "Nothing is left to play");
  html.close("ul");
}

std::string state_in_words(const RosterRow& row) {
  std::string words = row.state();
  if (row.status == TeamStatus::paused) words += ", paused: " + row.why;
  if (row.status == TeamStatus::withdrawn) return words + ", has withdrawn";
  if (!row.has_joined) words += ", not in the league";
  if (row.playing_entry > 0)
    return words + ", plays with entry " + std::to_string(row.playing_entry);
  return row.last_accepted > 0 ? words + ", entry " + std::to_string(row.last_accepted) + " next"
                               : words;
}

// The staff reads the names of people in an anonymous league, too.
void link_to_team(Html& html, const RosterRow& row) {
  html.link(staff_legs_path + row.team, row.people.display.empty() ? row.team : row.people.display);
}

void teams_table(Html& html, const LeagueState& state, const std::vector<RosterRow>& rows) {
  html.open_table();
  html.row("th", {"Team", "Handed in", "State", "Answer"});
  for (const RosterRow& row : rows) {
    html.open("tr");
    html.open("th class=\"words\"");
    link_to_team(html, row);
    std::string about = row.people.display.empty() ? "" : row.team;
    for (const std::string& member : row.people.members)
      about += (about.empty() ? "" : " · ") + member;
    html.cell("small", about);
    html.close("th");
    html.cell("td", {row.handed_in.empty() ? "" : shown_time(state.file, row.handed_in), "words"});
    html.cell("td", {state_in_words(row), "words"});
    std::string answer = row.was_accepted ? "" : row.message;
    if (!row.same_as.empty())
      answer += (answer.empty() ? "" : " ") + std::string("The same file as ") +
                system::joined(row.same_as, ", ") + ".";
    html.cell("td", {answer, "words"});
    html.close("tr");
  }
  html.close_table();
}

// A line with the teams that something is said of, each with a link to its legs.
void teams_line(Html& html, const char* what, const std::vector<const RosterRow*>& teams) {
  html.open("li");
  html.raw(what);
  for (const RosterRow* row : teams) {
    html.raw(row == teams.front() ? " " : "· ");
    link_to_team(html, *row);
  }
  if (teams.empty()) html.raw(" nobody");
  html.close("li");
}

void attention(Html& html, const std::vector<RosterRow>& rows, const Health& health) {
  std::vector<const RosterRow*> missing, refused, same;
  for (const RosterRow& row : rows) {
    if (row.status == TeamStatus::withdrawn) continue;
    if (row.last_entry == 0 && row.handed_in.empty()) missing.push_back(&row);
    if (!row.handed_in.empty() && !row.was_accepted && row.has_ended) refused.push_back(&row);
    if (!row.same_as.empty()) same.push_back(&row);
  }
  html.open("ul");
  for (const std::string& problem : health.problems) html.cell("li", problem);
  teams_line(html, "Not handed in:", missing);
  teams_line(html, "Last hand-in refused:", refused);
  teams_line(html, "The same file as another team, see the table:", same);
  html.close("ul");
}

void decisions_list(Html& html, const LeagueState& state, int done) {
  const auto views = decision_views(state);
  if (views.empty()) {
    html.cell("p", "No person has decided anything yet.");
    return;
  }
  html.open_table();
  html.row("th", {"No.", "When", "Who", "What", "Why", ""});
  for (const DecisionView& d : views) {
    html.open(d.number == done ? "tr class=\"chosen\"" : "tr");
    html.cell("td", {std::to_string(d.number), "number"});
    html.cell("td", d.at.empty() ? "" : shown_time(state.file, d.at));
    html.cell("td", d.by);
    html.cell("td", d.what);
    html.cell("td", d.why);
    html.cell("td", {d.undoing, "small"});
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
    return fail(Errc::input, other + " has this name already");
  return write_people(files, store.folder(), people);
}

// A form ends its lines with two characters.
Result<void> set_notice(system::Files& files, const Folder& folder, std::string text) {
  std::erase(text, '\r');
  MIROCUP_TRY(const auto lock, system::FileLock::acquire(folder.lock()));
  return write_notice(files, folder, text);
}

}  // namespace

web::Reply StaffDesk::page(Role reader, const Shown& shown) const {
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
  if (!shown.said.empty())
    html.raw("<p role=\"alert\">" + system::html_escaped(shown.said) + "</p>\n");
  if (shown.done > 0)
    html.raw("<p role=\"status\">Decision " + std::to_string(shown.done) + " is written.</p>\n");
  html.raw(jump_list(has_forms));
  html.open("ul");
  html.cell("li", std::to_string(state.played()) + " of " + std::to_string(state.legs()) +
                      " legs are decided");
  if (const std::string at = last_leg_at(store->journal()); !at.empty())
    html.cell("li", "The last leg was played at " + shown_time(state.file, at));
  html.close("ul");
  next_card(html, "To look at", "look");
  attention(html, *rows, *health);
  next_card(html, "Schedule", "schedule");
  schedule(html, state);
  if (has_forms) {
    next_card(html, "Notice to the class", "notice");
    notice_form(html, state.notice);
    next_card(html, "Decide", "decide");
    Forms(html, state, shown.given).all();
  }
  next_card(html, "Teams", "teams");
  teams_table(html, state, *rows);
  html.raw("<p><a href=\"/hand-in/grades.csv\">Grades (CSV)</a></p>\n");
  next_card(html, "Decisions", "decisions");
  decisions_list(html, state, shown.done);
  return staff_reply(shown.status, desk_page("Staff", html));
}

std::string StaffDesk::decision_path(const OwnLeg& leg) {
  return "/hand-in?fixture=" + leg.fixture + "&leg=" + std::to_string(leg.leg) + "#decide";
}

web::Reply StaffDesk::legs_of(Role reader, const std::string& team,
                              const std::vector<OwnLeg>& legs) const {
  const auto store = LeagueStore::open(files_, folder_);
  if (!store) return broken(store.error());
  const LeagueState& state = store->state();
  Html html;
  html.raw("<p><a href=\"/hand-in\">Back to the staff page</a></p>\n");
  if (legs.empty()) html.cell("p", "No leg of this team is decided, or there is no such team.");
  html.open_table();
  html.row("th", {"Leg", "Opponent", "Result", "Replay", "Log", "Own fault", "Decision"});
  for (auto leg = legs.rbegin(); leg != legs.rend(); ++leg) {
    html.open("tr");
    html.cell("th", leg->fixture + ", leg " + std::to_string(leg->leg));
    html.cell("td", state.shown_name_of(leg->opponent));
    html.cell("td", std::to_string(leg->goals) + " : " + std::to_string(leg->against));
    if (leg->record.empty()) {
      html.cell("td", "");
      html.cell("td", "");
    } else {
      const std::string name = name_of_leg(*leg);
      const bool is_drawn =
          record::has_thoughts(files_, folder_.path + "/" + leg->record, record::of_both);
      html.cell("td", {is_drawn ? "replay with thoughts" : "replay", "",
                       std::string(own_replays_path) + name + ".html?team=" + team});
      html.cell("td", {"log", "", "/api/v1/legs/" + name + "/log?team=" + team});
    }
    html.cell("td", {leg->own_fault.value_or(""), "small"});
    const std::string decision = reader == Role::staff ? decision_path(*leg) : "";
    html.cell("td", {decision.empty() ? "" : "decide", "", decision});
    html.close("tr");
  }
  html.close_table();
  return staff_reply(200, desk_page("Legs of " + state.shown_name_of(team), html));
}

web::Reply StaffDesk::act(const Form& values) const {
  auto store = LeagueStore::open(files_, folder_);
  if (!store) return broken(store.error());
  const std::string act = value_of(values, "act");
  const auto refused = [&](const std::string& why) {
    return page(Role::staff, {.said = why, .status = 400, .given = values});
  };
  if (act == "people" || act == "colour" || act == "notice") {
    if (const auto set = act == "notice" ? set_notice(files_, folder_, value_of(values, "text"))
                                         : set_people(files_, *store, values);
        !set)
      return refused(set.error().what);
    return {.status = 303, .bytes = "", .headers = {{"Location", "/hand-in"}}};
  }
  const auto wanted = act_of(values);
  if (!wanted) return refused("The form does not say what to decide.");
  const auto lines = perform(files_, *store, *wanted, now_());
  if (!lines) return refused(lines.error().what);
  if (wanted->is_dry_run)
    return page(Role::staff, {.said = system::joined(*lines, "; "), .given = values});
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
