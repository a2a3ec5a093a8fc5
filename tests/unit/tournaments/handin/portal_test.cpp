// SPDX-License-Identifier: MIT
//
// The desk without a network: each route with no, a wrong, another team's, an expired and a revoked
// token, from another site, with a cookie after log-out and with a forged header of a proxy. What
// strangers send over the network: tests/security/portal.py.
// Catches a private answer for the wrong one, a change that another site has made a browser send,
// and a hand-in without a limit.
#include "tournaments/handin/portal.hpp"

#include "record/answer.hpp"
#include "tests/support/is_ok.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/unit/tournaments/kept_entry.hpp"
#include "tests/unit/tournaments/small_league.hpp"
#include "tournaments/handin/team_desk_page.hpp"
#include "web/http/server.hpp"

#include <gtest/gtest.h>

#include <filesystem>

namespace mirocup::league {
namespace {

constexpr std::int64_t opening = 1'795'000'000;  // s since 1970
const std::string host = "league.example";
const std::string own_origin = "http://league.example";

using Query = std::multimap<std::string, std::string>;

web::Request get(const std::string& path) {
  web::Request request{.method = "GET", .path = path, .address = "10.0.0.1"};
  request.headers.emplace("host", host);
  return request;
}

web::Request with(web::Request request, const std::string& name, const std::string& value) {
  request.headers.emplace(name, value);
  return request;
}

// What a page shows besides the leg.
std::string names_of(const record::Whose& whose) {
  return std::string(whose[0] ? ", blue's thoughts" : "") + (whose[1] ? ", yellow's thoughts" : "");
}

class Desk : public testing::Test, public PortalLeague {
 protected:
  Desk() {
    TokenList list;
    const std::string now = utc_text(opening);
    alpha_ = list.add("alpha", now, "");
    beta_ = list.add("beta", now, "");
    expired_ = list.add("alpha", utc_text(opening - 10), utc_text(opening - 1));
    revoked_ = list.add("gone", now, "");
    list.revoke(Role::team, "gone", "", now);
    staff_ = list.add_for(Role::staff, "", now, "");
    EXPECT_TRUE(write_tokens(disk_, folder_, list));
    write_league();
    open();
  }

  void write_league() {
    const LeagueFile file = league_file_of({"alpha", "beta"}, {}, "submitted");
    EXPECT_TRUE(disk_.write(folder_.config(), print_league_file(file)));
  }

  int playing(const std::string& team) {
    return Book::open(disk_, folder_)->hand_ins().playing(team);
  }

  void open() {
    portal_.reset();
    PortalOptions options;
    options.now = [this] { return now_; };
    options.house = {"keeper", "striker"};
    auto portal = Portal::open(disk_, folder_, *this, std::move(options), nullptr);
    ASSERT_TRUE(test_support::is_ok(portal));
    portal_ = std::move(*portal);
  }

  HandInTerms hand_in_terms(const std::string&, const std::string&) override { return terms_; }
  std::vector<OwnLeg> legs_of(Viewer viewer, const std::string& team) override {
    viewers_.insert(viewer);
    return team == "alpha" ? legs_ : std::vector<OwnLeg>();
  }
  std::optional<std::string> own_replay(const std::string& name, const record::Whose& whose,
                                        const std::string& links) override {
    return "replay of " + name + names_of(whose) + links;
  }
  std::optional<std::string> replay_of(const std::string&, const record::Whose& whose,
                                       const std::string&) override {
    return "the replay" + names_of(whose);
  }
  std::string time_in_words(const std::string& utc) override { return "<local> " + utc; }
  std::map<std::string, int> booked_entries() override { return entries_; }
  std::vector<std::string> neighbours_of(const std::string&) override { return neighbours_; }
  bool has_drills() const override { return true; }
  void note_own_write() override { ++writes_; }

  web::Reply ask(web::Request request, const std::string& body = "") {
    is_body_read_ = false;
    web::apply({}, request);
    const auto reply = portal_->answer(request, [&](const auto& take) {
      is_body_read_ = true;
      return take(std::string_view(body));
    });
    return reply.value_or(web::Reply{.status = 404});
  }

  static web::Request api(const std::string& path, const std::string& token,
                          const std::string& method = "GET", Query query = {}) {
    web::Request request = get(path);
    request.method = method;
    request.query = std::move(query);
    return token.empty() ? request : with(request, "authorization", "Bearer " + token);
  }

  static web::Request put(const std::string& token) {
    return api("/api/v1/entries", token, "PUT", {{"name", "team.so"}});
  }

  static web::Request post(const std::string& path, const std::string& origin) {
    return with(api(path, "", "POST"), "origin", origin);
  }

  // Logs in and returns the header "Cookie" of the browser.
  std::string log_in(const std::string& token) {
    const web::Reply reply = ask(post("/hand-in/log-in", own_origin), "token=" + token);
    EXPECT_EQ(reply.status, 303);
    for (const auto& [name, value] : reply.headers) {
      if (name != "Set-Cookie") continue;
      EXPECT_NE(value.find("; HttpOnly"), std::string::npos);
      EXPECT_NE(value.find("; SameSite=Strict"), std::string::npos);
      return value.substr(0, value.find(';'));
    }
    ADD_FAILURE() << "no cookie";
    return "";
  }

  // Releases a mark of alpha in a league.
  void release(const Folder& league, const std::string& mark) {
    std::filesystem::create_directories(league.marks());
    const Json leg{{"number", 1}, {"opponent", "chaser"}, {"score", "2 : 1"}, {"record", "x.json"}};
    const Json json{{"mark", mark}, {"low", "2.10"}, {"high", "1.30"}, {"legs", {leg}}};
    ASSERT_TRUE(disk_.write(league.released_mark("alpha"), json.dump()));
  }

  std::string desk_of(const std::string& token) {
    return ask(with(get("/hand-in"), "cookie", log_in(token))).bytes;
  }

  static Json json_of(const web::Reply& reply) { return Json::parse(reply.bytes, nullptr, false); }

  // Gives alpha one leg, in yellow.
  const OwnLeg& play_leg(const std::string& opponent) {
    OwnLeg leg;
    leg.fixture = "r1-f1";
    leg.opponent = opponent;
    leg.record = "records/r1-f1-1-1.json";
    leg.colour = "yellow";
    legs_ = {leg};
    std::filesystem::create_directories(temporary_ / "records");
    return legs_[0];
  }

  test_support::TemporaryFolder temporary_;
  system::Disk disk_;
  Folder folder_{temporary_ / "."};
  std::int64_t now_ = opening;
  HandInTerms terms_;
  std::vector<OwnLeg> legs_;            // of alpha
  std::set<Viewer> viewers_;            // for whom legs were asked
  int writes_ = 0;                      // that the portal has told
  std::map<std::string, int> entries_;  // that play
  std::vector<std::string> neighbours_;
  std::string alpha_, beta_, expired_, revoked_, staff_;
  std::unique_ptr<Portal> portal_;
  bool is_body_read_ = false;
};

// Catches a check that gives way and then counts as one that the host has spoiled, and a file that
// keeps a processor busy with check after check, at the host's cost.
TEST_F(Desk, ChecksAgainWhatHadNoAnswerSoOftenAsTheReasonAllows) {
  struct Try {
    NoAnswer why;
    int checks;
    const char* state;
    const char* message;
  };
  const Try tries[]{{NoAnswer::spent, 2, "refused", "40 s of processor time, and did so twice"},
                    {NoAnswer::host_failed, 10, "void", ""},
                    {NoAnswer::gave_way, 20, "queued", ""}};
  int entry = 0;
  for (const auto& [why, checks, state, message] : tries) {
    ASSERT_EQ(json_of(ask(put(alpha_), state))["entry"], ++entry);
    int begun = 0;
    for (; begun < 20 && portal_->begin_next(); ++begun)
      ASSERT_TRUE(portal_->wait_again("alpha", entry, why, 40.0));
    EXPECT_EQ(begun, checks) << state;
    const Json told = json_of(ask(api("/api/v1/entries/" + std::to_string(entry), alpha_)));
    EXPECT_EQ(told["state"], state);
    EXPECT_NE(told.dump().find(message), std::string::npos) << told;
  }
  EXPECT_FALSE(disk_.exists(folder_.library("alpha", 1))) << "its bytes would stay for ever";
  EXPECT_EQ(json_of(ask(put(alpha_), "void"))["entry"], 4) << "the same bytes may come again";
}

// A request of one route. All of alpha: nobody else may get its answer.
struct Route {
  const char* method;
  const char* path;
  Query query = {};
  bool is_page = false;  // asks for the token in HTML
};

const std::vector<Route> private_routes{
    {"GET", "/api/v1/team"},
    {"GET", "/api/v1/entries"},
    {"GET", "/api/v1/entries/1"},
    {"GET", "/api/v1/entries/1/events"},
    {"PUT", "/api/v1/entries", {{"name", "team.so"}}},
    {"PUT", "/api/v1/pin", {{"entry", "1"}}},
    {"PUT", "/api/v1/pin", {{"entry", "latest"}}},
    {"GET", "/api/v1/legs"},
    {"GET", "/api/v1/legs/r1-f1-1-1/log"},
    {"GET", "/api/v1/friendlies"},
    {"POST", "/api/v1/friendlies", {{"opponent", "house:striker"}}},
    {"GET", "/api/v1/friendlies/alpha/1/log"},
    {"GET", "/api/v1/friendlies/alpha/1/replay"},
    {"GET", "/api/v1/anything"},
    {"DELETE", "/api/v1/entries/1"},
    {"HEAD", "/api/v1/entries/1"},
    {"GET", "/hand-in", {}, true},
    {"GET", "/hand-in/staff", {}, true},
    {"GET", "/hand-in/entries/1", {}, true},
    {"GET", "/hand-in/entries/1/replay", {}, true},
    {"GET", "/hand-in/friendlies/alpha/1/replay", {}, true},
    {"GET", "/hand-in/mark/1/replay", {}, true},
};

// Catches a new route without an entry in the test of wrong visitors, or open to everybody.
TEST(Routes, AreAllPrivateButThoseThatLogInAndOut) {
  int open = 0;
  for (const Portal::Route& route : Portal::routes()) {
    if (route.who == Who::everybody) {
      ++open;
      EXPECT_TRUE(route.path == "/hand-in/log-in" || route.path == "/hand-in/log-out" ||
                  route.path == "/hand-in/")
          << route.path;
      continue;
    }
    const bool is_staffs = route.who == Who::staff || route.who == Who::grader;
    const bool is_replay = route.path == "/hand-in/replays/**";
    bool is_tried = is_staffs || is_replay;  // staff_desk_test.cpp, ShowsALeg...
    for (const Route& one : private_routes)
      is_tried = is_tried || (one.method == route.method && match_path(route.path, one.path));
    EXPECT_TRUE(is_tried) << route.method << " " << route.path;
  }
  EXPECT_EQ(open, 3);
}

TEST_F(Desk, TakesAFileAndSaysWhatBecomesOfIt) {
  const web::Reply taken = ask(put(alpha_), "ELF");
  ASSERT_EQ(taken.status, 202) << taken.bytes;
  EXPECT_EQ(json_of(taken)["entry"], 1);
  EXPECT_EQ(json_of(taken)["events"], "/api/v1/entries/1/events");
  ASSERT_EQ(ask(put(beta_), "other").status, 202);
  Json state = json_of(ask(api("/api/v1/entries/1", beta_)));
  EXPECT_EQ(state["state"], "queued");
  EXPECT_EQ(state["before"], 1);
  EXPECT_EQ(state["team"], "beta");

  const auto next = portal_->begin_next();
  ASSERT_TRUE(next);
  EXPECT_EQ(next->team, "alpha");
  EXPECT_EQ(next->file, "team.so");
  EXPECT_EQ(*disk_.read(folder_.library("alpha", 1), {.max_size = 100}), "ELF");
  portal_->set_step("alpha", 1, {3, 10, "entry"});
  state = json_of(ask(api("/api/v1/entries/1", alpha_)));
  EXPECT_EQ(state["state"], "checking");
  EXPECT_EQ(state["step"]["number"], 3);
  ASSERT_TRUE(portal_->close({"alpha", 1, HandInState::refused, "alpha: entry 1: no"}));
  state = json_of(ask(api("/api/v1/entries/1", alpha_)));
  EXPECT_EQ(state["state"], "refused");
  EXPECT_EQ(state["reason"], "alpha: entry 1: no");
  EXPECT_EQ(json_of(ask(api("/api/v1/entries", alpha_)))["entries"].size(), 1u);
}

TEST_F(Desk, TellsEventsUntilTheAnswer) {
  ASSERT_EQ(ask(put(alpha_), "ELF").status, 202);
  const web::Reply reply = ask(api("/api/v1/entries/1/events", alpha_));
  ASSERT_TRUE(reply.events);
  EXPECT_NE(reply.events().text.find("\"state\":\"queued\",\"reason\":null"), std::string::npos);
  EXPECT_EQ(reply.events().text, "") << "nothing has changed";
  ASSERT_TRUE(portal_->begin_next());
  portal_->set_step("alpha", 1, {2, 10, "complete"});
  const web::EventBatch step = reply.events();
  EXPECT_NE(step.text.find("\"number\":2"), std::string::npos) << step.text;
  EXPECT_FALSE(step.is_last);
  ASSERT_TRUE(portal_->close({"alpha", 1, HandInState::accepted, "alpha: entry 1 was accepted"}));
  const web::EventBatch last = reply.events();
  EXPECT_TRUE(last.is_last);
  EXPECT_NE(last.text.find("was accepted"), std::string::npos);
}

// Each route with each wrong visitor. Catches one route that forgets to ask who comes.
TEST_F(Desk, GivesNoRouteToTheWrongVisitor) {
  ASSERT_EQ(ask(put(alpha_), "the_secret_of_alpha").status, 202);
  ASSERT_TRUE(portal_->begin_next());
  ASSERT_TRUE(portal_->close({"alpha", 1, HandInState::refused, "the_secret_of_alpha"}));
  play_leg("the_secret_of_alpha");
  release(folder_, "the_secret_of_alpha");
  const std::string ended = log_in(alpha_);
  ASSERT_EQ(ask(with(post("/hand-in/log-out", own_origin), "cookie", ended)).status, 303);
  const std::string cookie = log_in(alpha_);
  const std::string book = *disk_.read(folder_.hand_in_book(), {.max_size = 1 << 20});

  struct WrongVisitor {
    const char* name;
    std::function<web::Request(web::Request)> dress;
    bool may_read = false;  // the right one, but a change comes from another site
    bool is_other_team = false;
  };
  const auto bearer = [](const std::string& token) {
    return
        [token](web::Request r) { return with(std::move(r), "authorization", "Bearer " + token); };
  };
  const std::vector<WrongVisitor> visitors{
      {"none", [](web::Request r) { return r; }},
      {"wrong", bearer(std::string(26, 'A'))},
      {"expired", bearer(expired_)},
      {"revoked", bearer(revoked_)},
      {"another team", bearer(beta_), false, true},
      {"after log-out",
       [&](web::Request r) {
         return with(with(std::move(r), "cookie", ended), "origin", own_origin);
       }},
      {"forged team", [](web::Request r) { return with(std::move(r), "x-team", "alpha"); }},
      {"forged cookie",
       [&](web::Request r) {
         const std::string name = cookie.substr(0, cookie.find('=') + 1);
         return with(with(std::move(r), "cookie", name + std::string(26, 'A')), "origin",
                     own_origin);
       }},
      {"another site",
       [&](web::Request r) {
         return with(with(std::move(r), "cookie", cookie), "origin", "http://evil.example");
       },
       true},
      {"no origin", [&](web::Request r) { return with(std::move(r), "cookie", cookie); }, true},
  };
  for (const Route& route : private_routes) {
    const std::string method = route.method;
    const bool is_change = method != "GET" && method != "HEAD";
    for (const WrongVisitor& visitor : visitors) {
      SCOPED_TRACE(method + " " + route.path + ": " + visitor.name);
      if (visitor.may_read && !is_change) continue;
      const web::Reply reply = ask(visitor.dress(api(route.path, "", method, route.query)), "ELF");
      const std::string shown = reply.events ? reply.events().text : reply.bytes;
      EXPECT_EQ(shown.find("the_secret_of_alpha"), std::string::npos) << shown;
      EXPECT_EQ(shown.find("the replay"), std::string::npos);
      now_ += 1000;                         // wrong tokens are forgotten
      if (visitor.is_other_team) continue;  // it may do the same for itself
      const int expected = visitor.may_read ? 403 : 401;
      // The page that asks for a token is for everybody.
      EXPECT_TRUE(reply.status == expected || (reply.status == 200 && route.is_page))
          << reply.status;
      EXPECT_FALSE(is_body_read_);
    }
  }
  // Nothing of alpha has changed, whoever tried.
  const std::string after = *disk_.read(folder_.hand_in_book(), {.max_size = 1 << 20});
  EXPECT_EQ(after.substr(0, book.size()), book);
  EXPECT_EQ(after.find("\"alpha\"", book.size()), std::string::npos) << after;
  EXPECT_EQ(Book::open(disk_, folder_)->hand_ins().pinned("alpha"), 0);
}

TEST_F(Desk, PlaysFriendliesAndShowsThemToTheTwo) {
  entries_ = {{"alpha", 1}, {"beta", 1}, {"gamma", 1}};
  neighbours_ = {"beta"};
  for (const char* team : {"alpha", "beta", "gamma"}) keep_entry(disk_, folder_, team, "library");
  const auto ask_for = [&](const std::string& token, const std::string& opponent) {
    return ask(api("/api/v1/friendlies", token, "POST", {{"opponent", opponent}})).status;
  };
  EXPECT_EQ(ask_for(alpha_, "nobody"), 404);
  EXPECT_EQ(ask_for(alpha_, "alpha"), 404);
  EXPECT_EQ(ask_for(alpha_, "house:nobody"), 404);
  EXPECT_EQ(ask_for(alpha_, "house:../x"), 404);
  ASSERT_EQ(ask_for(alpha_, "beta"), 202);
  const auto leg = portal_->friendlies().begin_next();
  ASSERT_TRUE(leg);
  EXPECT_EQ(leg->opponent_entry, 1);
  EXPECT_FALSE(portal_->friendlies().begin_next()) << "one at a time of each team";
  ASSERT_TRUE(disk_.write(folder_.friendly("alpha", 1),
                          R"({"result":{"score":{"blue":3,"yellow":1},"end":"full_time",)"
                          R"("fault":null}})"));
  ASSERT_TRUE(disk_.write(folder_.friendly("alpha", 1) + ".blue.log", "of alpha"));
  ASSERT_TRUE(disk_.write(folder_.friendly("alpha", 1) + ".yellow.log", "of beta"));
  ASSERT_TRUE(portal_->friendlies().played(*leg));
  EXPECT_EQ(ask(api("/api/v1/friendlies/alpha/1/log", alpha_)).bytes, "of alpha");
  EXPECT_EQ(ask(api("/api/v1/friendlies/alpha/1/log", beta_)).bytes, "of beta");
  EXPECT_EQ(ask(api("/api/v1/friendlies/alpha/1/replay", beta_)).bytes,
            "the replay, yellow's thoughts");
  const Json seen = json_of(ask(api("/api/v1/friendlies", beta_)))["friendlies"];
  ASSERT_EQ(seen.size(), 1u);
  EXPECT_EQ(seen[0]["goals"], 1);
  EXPECT_EQ(seen[0]["opponent"], "alpha");
  for (const char* strange : {"/alpha/2/log", "/alpha/1/x", "/alpha//log", "/../1/log",
                              "/alpha/1/../1/log", "/gamma/1/log", "/alpha/0/log"}) {
    EXPECT_EQ(ask(api(std::string("/api/v1/friendlies") + strange, alpha_)).status, 404) << strange;
  }
  for (int i = 1; i < 10; ++i) EXPECT_EQ(ask_for(alpha_, "house:striker"), 202);
  EXPECT_EQ(ask_for(alpha_, "house:striker"), 429);
  EXPECT_EQ(ask_for(beta_, "house:striker"), 202) << "another team's limit";
  open();
  EXPECT_EQ(ask_for(alpha_, "house:striker"), 429) << "a server that starts again remembers";

  // The burst of an accepted entry is for its team only, and ends what waits for older entries.
  ASSERT_TRUE(portal_->friendlies().entry_accepted("alpha", 2));
  const Json all = json_of(ask(api("/api/v1/friendlies", alpha_)))["friendlies"];
  EXPECT_EQ(std::count_if(all.begin(), all.end(), [](const Json& one) { return one["burst"]; }), 3);
  EXPECT_EQ(
      std::count_if(all.begin(), all.end(), [](const Json& one) { return one["state"] == "void"; }),
      9);
  ASSERT_TRUE(portal_->friendlies().entry_accepted("alpha", 2));
  EXPECT_EQ(json_of(ask(api("/api/v1/friendlies", alpha_)))["friendlies"].size(), all.size());
  EXPECT_EQ(json_of(ask(api("/api/v1/friendlies", beta_)))["friendlies"].size(), 2u);
  // A later entry meets the one before it.
  ASSERT_TRUE(portal_->friendlies().entry_accepted("alpha", 3));
  const Json later = json_of(ask(api("/api/v1/friendlies", alpha_)))["friendlies"];
  EXPECT_EQ(std::count_if(later.begin(), later.end(),
                          [](const Json& one) {
                            return one["opponent"] == "alpha" && one["entry"] == 3 &&
                                   one["opponent_entry"] == 2;
                          }),
            10);
}

// Catches drills that are tried before the legs, twice, or not again after a check came first, and
// marks of another entry.
TEST_F(Desk, TriesTheDrillsOfAnAcceptedEntryOnce) {
  ASSERT_TRUE(portal_->friendlies().entry_accepted("alpha", 2));
  FriendlyDesk& desk = portal_->friendlies();
  for (int number = 1; number <= 2; ++number) {
    const auto leg = desk.begin_next();
    ASSERT_TRUE(leg);
    EXPECT_EQ(leg->number, number);
    ASSERT_TRUE(disk_.write(folder_.friendly("alpha", number),
                            R"({"result":{"score":{"blue":3,"yellow":1},"end":"full_time",)"
                            R"("fault":null}})"));
    ASSERT_TRUE(desk.played(*leg));
  }
  auto drills = desk.begin_next();
  ASSERT_TRUE(drills);
  EXPECT_EQ(drills->number, 0);
  EXPECT_EQ(drills->entry, 2);
  EXPECT_FALSE(desk.begin_next());
  ASSERT_TRUE(desk.failed(*drills, false));
  drills = desk.begin_next();
  ASSERT_TRUE(drills) << "a check came first";
  ASSERT_TRUE(disk_.write(folder_.drill_marks("alpha", 2) + ".answer",
                          R"({"team":"alpha","drills":[{"name":"save","version":1,"score":30.0,)"
                          R"("low":1.0}],"score":30.0})"
                          "\n"));
  ASSERT_TRUE(desk.played(*drills));
  EXPECT_FALSE(desk.begin_next());
  open();
  EXPECT_FALSE(portal_->friendlies().begin_next()) << "a server that starts again knows them";
  const Json rows = json_of(ask(api("/api/v1/friendlies", alpha_)))["progress"];
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0]["drills"]["score"], 30.0);
  EXPECT_EQ(rows[0]["drills"]["drills"].dump(), R"([{"name":"save","version":1,"score":30.0}])");
  EXPECT_EQ(portal_->friendlies().drills_of("alpha", 1), Json());
}

TEST_F(Desk, PinsAnAcceptedVersionOfItsTeam) {
  keep_entry(disk_, folder_, "alpha", "one");
  keep_entry(disk_, folder_, "alpha", "two");
  keep_entry(disk_, folder_, "alpha", "three", HandInState::refused);
  const auto pin = [&](const std::string& token, const std::string& entry) {
    return ask(api("/api/v1/pin", token, "PUT", {{"entry", entry}})).status;
  };
  EXPECT_EQ(playing("alpha"), 2);
  EXPECT_EQ(pin(alpha_, "1"), 200);
  EXPECT_EQ(playing("alpha"), 1);
  EXPECT_EQ(pin(alpha_, "3"), 409) << "it was refused";
  EXPECT_EQ(pin(alpha_, "9"), 409);
  EXPECT_EQ(pin(beta_, "1"), 409) << "another team's";
  for (const char* strange : {"", "0", "-1", "1x", "../1"}) EXPECT_EQ(pin(alpha_, strange), 400);
  EXPECT_EQ(pin(staff_, "1"), 403);
  open();
  EXPECT_EQ(playing("alpha"), 1);
  EXPECT_EQ(pin(alpha_, "latest"), 200);
  EXPECT_EQ(playing("alpha"), 2);
  // Catches a pin that plays and is not in the book.
  const std::string book = folder_.hand_in_book();
  std::filesystem::rename(book, book + ".away");
  std::filesystem::create_symlink(book + ".away", book);
  EXPECT_EQ(pin(alpha_, "1"), 503) << "a link is no book";
  std::filesystem::rename(book + ".away", book);
  EXPECT_EQ(playing("alpha"), 2);
  open();
  for (int i = 0; i < 8; ++i) EXPECT_EQ(pin(alpha_, "1"), 200);
  EXPECT_EQ(pin(alpha_, "latest"), 429);
}

// kills_test.cpp has the kills. Catches a team that joins again after the host has taken it out,
// and files of an entry that was dropped.
TEST_F(Desk, DoesWhatAKilledProcessHasLeftUndoneAndNothingTwice) {
  for (const char* library : {"one", "two"}) keep_entry(disk_, folder_, "gamma", library);
  auto book = Book::open(disk_, folder_);
  ASSERT_TRUE(book && book->write(Dropped{.team = "gamma", .entries = {1}}));
  open();
  EXPECT_EQ(LeagueStore::open(disk_, folder_)->state().teams.size(), 3u) << "gamma has joined";
  EXPECT_TRUE(disk_.exists(folder_.entry_file("gamma", 2)));
  EXPECT_FALSE(disk_.exists(folder_.entry("gamma", 1)));
  write_league();  // without gamma
  open();
  EXPECT_EQ(LeagueStore::open(disk_, folder_)->state().teams.size(), 2u);
}

TEST_F(Desk, ShowsTheLogsOfOwnLegsOnly) {
  ASSERT_TRUE(disk_.write(log_path(folder_, play_leg("<b>beta</b>")), "hello\x1b[31m"));
  ASSERT_TRUE(disk_.write(temporary_ / "records/r1-f1-1-1.json.blue.log", "the other's"));
  ASSERT_TRUE(disk_.write(temporary_ / "records/r1-f1-1-1.json",
                          R"({"budget":{"yellow":{"cpu_seconds":0.5,"bank_seconds":9.0,)"
                          R"("slowest_tick_ms":2.5,"late_ticks":0}},"decisions":[]})"));
  const Json legs = json_of(ask(api("/api/v1/legs", alpha_)))["legs"];
  ASSERT_EQ(legs.size(), 1u);
  EXPECT_EQ(legs[0]["slowest_tick_ms"], 2.5);
  EXPECT_EQ(legs[0]["replay"], "/replays/r1-f1-1-1.html");
  EXPECT_EQ(ask(api(legs[0]["log"].get<std::string>(), alpha_)).bytes, "hello\\x1b[31m");
  EXPECT_EQ(ask(api(legs[0]["log"].get<std::string>(), beta_)).status, 404);
  for (const char* strange :
       {"/api/v1/legs/log", "/api/v1/legs//log", "/api/v1/legs/../r1-f1-1-1/log",
        "/api/v1/legs/r1-f1-1-1", "/api/v1/legs/r1-f1-1-1.json.blue.log",
        "/api/v1/legsr1-f1-1-1/log"}) {
    EXPECT_EQ(ask(api(strange, alpha_)).status, 404) << strange;
  }
  const std::string page = desk_of(alpha_);
  EXPECT_NE(page.find("&lt;b&gt;beta"), std::string::npos);
  EXPECT_NE(page.find("2.50"), std::string::npos);
}

// Catches thoughts to which another team's token or none leads, and a link to them for a leg that
// kept none.
TEST_F(Desk, ShowsTheThoughtsOfOwnLegsOnly) {
  play_leg("beta");
  const auto told = [&](const std::string& token) {
    return json_of(ask(api("/api/v1/legs", token)))["legs"][0];
  };
  EXPECT_FALSE(told(alpha_).contains("thoughts"));
  ASSERT_TRUE(disk_.write(temporary_ / "records/r1-f1-1-1.blue.thoughts.zst", "the other's"));
  EXPECT_FALSE(told(alpha_).contains("thoughts"));
  ASSERT_TRUE(disk_.write(temporary_ / "records/r1-f1-1-1.yellow.thoughts.zst", "own"));
  const std::string path = told(alpha_)["thoughts"].get<std::string>();
  EXPECT_EQ(path, "/hand-in/replays/r1-f1-1-1.html");
  EXPECT_EQ(ask(api(path, alpha_)).bytes, "replay of r1-f1-1-1, yellow's thoughts");
  EXPECT_EQ(ask(with(get(path), "cookie", log_in(alpha_))).status, 200);
  const Query of_alpha{{"team", "alpha"}};
  EXPECT_EQ(ask(api(path, staff_)).status, 404) << "of which team?";
  EXPECT_EQ(ask(api(path, staff_, "GET", of_alpha)).bytes,
            "replay of r1-f1-1-1, blue's thoughts, yellow's thoughts"
            "<p class=\"path\"><a href=\"../../hand-in?fixture=r1-f1&amp;leg=1#decide\">"
            "Decide about this leg</a></p>");

  EXPECT_EQ(ask(api(path, beta_)).status, 404);
  EXPECT_EQ(ask(api(path, beta_, "GET", of_alpha)).status, 404)
      << "a team's token is for this team only";
  EXPECT_EQ(ask(get(path)).status, 401);
  EXPECT_EQ(ask(api(path, expired_)).status, 401);
  for (const char* strange :
       {"/hand-in/replays/", "/hand-in/replays/r1-f1-1-1", "/hand-in/replays/../r1-f1-1-1.html",
        "/hand-in/replays/r1-f1-1-1.blue.thoughts.zst", "/hand-in/replays/r1-f1-1-2.html"}) {
    EXPECT_EQ(ask(api(strange, alpha_)).status, 404) << strange;
  }
  web::Request desk = with(get("/hand-in"), "cookie", log_in(alpha_));
  EXPECT_NE(ask(desk).bytes.find("href=\"" + path.substr(1)), std::string::npos);
  // The staff's page of a team's legs is for no team, not even for this one.
  desk = with(api("/hand-in", "", "GET", of_alpha), "cookie", log_in(beta_));
  EXPECT_NE(ask(desk).bytes.find("<h1>beta</h1>"), std::string::npos);
  EXPECT_EQ(ask(desk).bytes.find("r1-f1-1-1"), std::string::npos);
}

// Catches a mark that another team sees, or that was not released, and one of the term in the place
// of that of the closing round.
TEST_F(Desk, ShowsAReleasedMarkToItsTeamOnly) {
  const std::string replay = "/hand-in/mark/1/replay";
  EXPECT_EQ(desk_of(alpha_).find("<h2>Mark"), std::string::npos);
  EXPECT_EQ(ask(api(replay, alpha_)).status, 404);
  release(folder_, "1.70");
  const std::string page = desk_of(alpha_);
  EXPECT_NE(page.find("<strong>1.70</strong> (95 % interval 2.10 to 1.30)"), std::string::npos);
  EXPECT_NE(page.find("chaser 2 : 1 <a href=\"" + replay.substr(1)), std::string::npos) << page;
  EXPECT_EQ(desk_of(beta_).find("<h2>Mark"), std::string::npos);
  EXPECT_EQ(ask(api(replay, alpha_)).bytes, "the replay");
  EXPECT_EQ(ask(api(replay, beta_)).status, 404);
  for (const char* wrong : {"2", "01", "x", "1.0"})
    EXPECT_EQ(ask(api(std::string("/hand-in/mark/") + wrong + "/replay", alpha_)).status, 404);
  release(folder_.closing_round(), "1.00");
  EXPECT_NE(desk_of(alpha_).find("<strong>1.00</strong>"), std::string::npos);
}

TEST_F(Desk, EndsATokenAtOnce) {
  ASSERT_EQ(ask(put(alpha_), "ELF").status, 202);
  const std::string cookie = log_in(alpha_);
  ASSERT_EQ(ask(with(get("/api/v1/entries/1"), "cookie", cookie)).status, 200);
  auto list = *read_tokens(disk_, folder_);
  list.revoke(Role::team, "alpha", "", utc_text(now_));
  ASSERT_TRUE(write_tokens(disk_, folder_, list));
  EXPECT_EQ(ask(api("/api/v1/entries/1", alpha_)).status, 401);
  EXPECT_EQ(ask(with(get("/api/v1/entries/1"), "cookie", cookie)).status, 401)
      << "its sessions end with it";
  EXPECT_EQ(ask(put(alpha_), "more").status, 401);
}

TEST_F(Desk, SetsSecureCookiesUnderTls) {
  web::Request request = post("/hand-in/log-in", "https://league.example");
  request.is_encrypted = true;
  const web::Reply reply = ask(request, "token=" + alpha_);
  ASSERT_EQ(reply.status, 303);
  EXPECT_NE(reply.headers.back().second.find("; Secure"), std::string::npos);
  EXPECT_EQ(reply.headers.back().second.find("__Host-"), 0u);
  request = post("/hand-in/log-in", own_origin);
  request.is_encrypted = true;
  EXPECT_EQ(ask(request, "token=" + alpha_).status, 403);
}

TEST_F(Desk, LimitsWhatATeamHandsIn) {
  for (int i = 0; i < 3; ++i) EXPECT_EQ(ask(put(alpha_), "ELF" + std::to_string(i)).status, 202);
  EXPECT_EQ(json_of(ask(put(alpha_), "ELF2"))["entry"], 3) << "the same bytes are no other hand-in";
  EXPECT_EQ(ask(put(alpha_), "ELF3").status, 202);
  EXPECT_EQ(ask(put(alpha_), "ELF4").status, 429);
  EXPECT_EQ(ask(put(beta_), "ELF").status, 202) << "another team's limit";
  auto book = Book::open(disk_, folder_);
  for (int i = 0; i < 19; ++i)
    ASSERT_TRUE(book->write(Rejected{.team = "beta", .message = "no", .at = now_ - 60}));
  const web::Reply reply = ask(put(beta_), "more");
  EXPECT_EQ(reply.status, 429);
  EXPECT_NE(json_of(reply)["error"].get<std::string>().find("20 tries"), std::string::npos);
  EXPECT_EQ(json_of(ask(api("/api/v1/team", beta_)))["status"], 429);
  terms_.why_not = "entries are frozen";
  EXPECT_EQ(ask(put(beta_), "more").status, 403);
  terms_ = {.is_late = true};
  now_ += 3600;
  EXPECT_EQ(json_of(ask(put(beta_), "ELF"))["entry"], 1) << "it had come in time";
  EXPECT_EQ(json_of(ask(put(beta_), "late"))["entry"], 2);
  terms_.is_late = false;
  EXPECT_EQ(json_of(ask(put(beta_), "late"))["entry"], 3) << "now it comes in time";
}

// Catches a list that grows without end with the tries of a team, an older entry that no list has,
// and one that two lists have.
TEST_F(Desk, ListsAHundredEntriesAtOnce) {
  constexpr int count = 205;
  {
    portal_.reset();
    auto book = Book::open(disk_, folder_);
    ASSERT_TRUE(test_support::is_ok(book));
    for (int i = 1; i <= count; ++i) {
      const HandedIn handed{
          .team = i == count ? "beta" : "alpha", .file = "x.so", .is_network = true};
      const auto entry = book->take(handed, [](const std::string&) { return Result<void>(); });
      ASSERT_TRUE(test_support::is_ok(entry));
      ASSERT_TRUE(book->write(Answered{handed.team, *entry, HandInState::refused, "no"}));
    }
  }
  open();
  const auto list = [&](const std::string& token, const std::string& before) {
    return ask(
        api("/api/v1/entries", token, "GET", before.empty() ? Query() : Query{{"before", before}}));
  };
  std::vector<int> seen;
  std::string before;
  for (const std::size_t expected : {100u, 100u, 4u}) {
    const Json page = json_of(list(alpha_, before));
    ASSERT_EQ(page["entries"].size(), expected) << page.dump();
    for (const Json& entry : page["entries"]) seen.push_back(entry["entry"].get<int>());
    EXPECT_EQ(page["older"].is_null(), expected == 4u);
    before = page["older"].dump();
  }
  ASSERT_EQ(seen.size(), 204u);
  for (int i = 0; i < 204; ++i) EXPECT_EQ(seen[static_cast<std::size_t>(i)], 204 - i);
  EXPECT_TRUE(json_of(list(beta_, ""))["older"].is_null());
  for (const char* wrong : {"0", "-1", "x", "1e3", "99999999999"})
    EXPECT_EQ(list(alpha_, wrong).status, 400) << wrong;

  const std::string newest = ask(api("/hand-in", alpha_)).bytes;
  EXPECT_NE(newest.find("id=\"entry-105\""), std::string::npos);
  EXPECT_EQ(newest.find("id=\"entry-104\""), std::string::npos);
  EXPECT_NE(newest.find("href=\"hand-in?before=105\""), std::string::npos);
  const std::string oldest = ask(api("/hand-in", alpha_, "GET", {{"before", "5"}})).bytes;
  EXPECT_NE(oldest.find("id=\"entry-4\""), std::string::npos);
  EXPECT_EQ(oldest.find("id=\"entry-5\""), std::string::npos);
  EXPECT_EQ(oldest.find("/hand-in?before="), std::string::npos);
}

// Catches a write of the server that its caches are not told of, so that the next answer is the
// former one.
TEST_F(Desk, TellsWhenItHasWritten) {
  const auto writes_of = [&](const web::Request& request, int status) {
    writes_ = 0;
    EXPECT_EQ(ask(request, "ELF").status, status) << request.path;
    return writes_;
  };
  keep_entry(disk_, folder_, "beta", "library");
  EXPECT_EQ(writes_of(put(alpha_), 202), 1);
  EXPECT_EQ(
      writes_of(api("/api/v1/friendlies", beta_, "POST", {{"opponent", "house:striker"}}), 202), 1);
  for (const char* path : {"/api/v1/entries", "/api/v1/legs", "/hand-in"})
    EXPECT_EQ(writes_of(api(path, alpha_), 200), 0);
  EXPECT_EQ(writes_of(put("wrong"), 401), 0);
  ASSERT_TRUE(portal_->begin_next());
  writes_ = 0;
  ASSERT_TRUE(portal_->close({"alpha", 1, HandInState::accepted, "alpha: entry 1 was accepted"}));
  EXPECT_EQ(writes_, 1) << "a check lets teams join";
}

// Catches a team that is given the legs of the staff, and a staff that is given those of a team.
TEST_F(Desk, AsksForLegsAsTheOneWhoComes) {
  for (const char* path : {"/api/v1/legs", "/api/v1/legs/x/log", "/hand-in", "/hand-in/replays/x"})
    for (const std::string& token : {alpha_, staff_}) {
      viewers_.clear();
      ask(api(path, token, "GET", {{"team", "alpha"}}));
      EXPECT_EQ(viewers_, std::set{token == staff_ ? Viewer::staff : Viewer::team}) << path;
    }
}

// Catches a step that is taken from the middle of a line that is still written, or from a verdict.
TEST(CheckSteps, AreReadFromTheLastWholeLineOfAnAnswer) {
  const test_support::TemporaryFolder folder;
  system::Disk disk;
  const auto step = [&](const std::string& text) {
    EXPECT_TRUE(disk.write(folder / "answer", text));
    const auto answer = record::last_answer(disk, folder / "answer");
    return answer ? step_in(*answer) : std::nullopt;
  };
  const std::string first = R"({"step": 1, "of": 10, "name": "file"})"
                            "\n";
  EXPECT_EQ(step(first + R"({"step": 2, "of": 10, "name": "complete"})"
                         "\n"),
            (CheckStep{2, 10, "complete"}));
  EXPECT_EQ(step(first + R"({"step": 2, "of": 1)"), (CheckStep{1, 10, "file"}));
  EXPECT_EQ(step(first + R"({"accepted": true})"
                         "\n"),
            std::nullopt);
  EXPECT_EQ(step(""), std::nullopt);
  EXPECT_EQ(step("step 1 of 10: file\n"), std::nullopt);
}

TEST(Logs, AreShortenedToTheirFirstAndLastLines) {
  EXPECT_EQ(shortened("a\nb\n"), "a\nb\n");
  std::string log;
  for (int i = 0; i < 1000; ++i) log += "line " + std::to_string(i) + "\n";
  const std::string text = shortened(log);
  EXPECT_EQ(text.find("line 0\n"), 0u);
  EXPECT_NE(text.find("line 49\n"), std::string::npos);
  EXPECT_EQ(text.find("line 500\n"), std::string::npos);
  EXPECT_NE(text.find("line 999\n"), std::string::npos);
  EXPECT_NE(text.find("bytes are left out"), std::string::npos);
  EXPECT_LT(shortened(std::string(1'000'000, 'x')).size(), 40'000u);
  EXPECT_EQ(shortened("\x1b[31m"), "\\x1b[31m");
}

}  // namespace
}  // namespace mirocup::league
