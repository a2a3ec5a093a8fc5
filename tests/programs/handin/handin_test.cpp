// SPDX-License-Identifier: MIT
//
// A league that takes hand-ins over HTTP, with the real server, command, checks and TLS. Catches a
// hand-in that is lost or checked twice when something is killed, a wrong exit code of
// `mirocup hand-in`, and a client that is not told why its file is not taken. A few kills here;
// MIROCUP_KILLS=200 build/handin_tests --gtest_filter='*Kills*' for many.
#include "system/text.hpp"
#include "tests/programs/league/league_command.hpp"
#include "web/http/client.hpp"
#include "web/http/server.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <map>
#include <memory>
#include <random>
#include <unistd.h>

namespace mirocup {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;
using namespace test_support;
using test_support::league;  // and not the namespace

class HandIn : public testing::Test {
 protected:
  HandIn() { init_league(folder_, {"alpha=house:chaser", "beta=house:keeper"}); }

  std::string new_token(const std::string& team) {
    const Outcome made = expect_exit(0, run(league("token", folder_, {team})));
    write_file(temporary_ / (team + ".token"), made.out);
    return made.out.substr(0, made.out.find('\n'));
  }

  std::string staff_token() {
    const Outcome made = expect_exit(0, run(league("token", folder_, {"--staff"})));
    return made.out.substr(0, made.out.find('\n'));
  }

  // Starts the server, at the same port as before if there was one.
  void serve(const std::vector<std::string>& more = {}) {
    std::vector<std::string> words{"--hand-in", "--at", std::to_string(port_)};
    words.insert(words.end(), more.begin(), more.end());
    server_ = std::make_unique<Running>(league("serve", folder_, words));
    ASSERT_TRUE(wait_until([&] { return server_->out().find("/\n") != std::string::npos; }))
        << server_->err();
    url_ = server_->out();
    url_.pop_back();
    port_ = std::stoi(url_.substr(url_.rfind(':') + 1));
  }

  Outcome hand_in(const std::string& team, const std::string& file,
                  const std::vector<std::string>& more = {}) {
    std::vector<std::string> words{
        program("mirocup"), "hand-in", url_, "--token-file", temporary_ / (team + ".token"), file};
    words.insert(words.end(), more.begin(), more.end());
    return run(words);
  }

  // What the server answers to a visitor, or to the owner of a token.
  web::Answer ask(const std::string& method, const std::string& path, const std::string& token = "",
                  const std::string& body = "") {
    const std::string url = "http://127.0.0.1:" + std::to_string(port_);
    return web::HttpClient::open(url, {.token = token}).value().ask(method, path, body);
  }

  ordered_json state_of(const std::string& token, int entry) {
    const auto reply = ask("GET", "/api/v1/entries/" + std::to_string(entry), token);
    return reply.status == 200 ? ordered_json::parse(reply.body) : ordered_json();
  }

  std::string page(const std::string& path, const std::string& token = "") {
    return ask("GET", path, token).body;
  }

  // Sends a form of the staff page.
  int act(const std::string& token, const std::multimap<std::string, std::string>& form) {
    std::string text;
    for (const auto& [key, value] : form) text += key + '=' + system::percent_coded(value) + '&';
    return ask("POST", "/hand-in/staff", token, text).status;
  }

  std::vector<ordered_json> book() {
    std::vector<ordered_json> lines;
    std::istringstream text(read_file(folder_ + "/hand-ins.jsonl"));
    for (std::string line; std::getline(text, line);) lines.push_back(ordered_json::parse(line));
    return lines;
  }

  TemporaryFolder temporary_;
  std::string folder_ = temporary_ / "l";
  std::string url_;
  int port_ = 0;
  std::unique_ptr<Running> server_;
};

TEST_F(HandIn, TellsTheVerdictByOneCommand) {
  new_token("alpha");
  new_token("gamma");
  serve();
  const Outcome accepted = expect_exit(0, hand_in("alpha", house("striker")));
  EXPECT_TRUE(contains(accepted.out, "alpha: entry 2 was accepted"));
  EXPECT_TRUE(contains(accepted.out, " against striker as yellow"));
  EXPECT_EQ(read_file(folder_ + "/entries/alpha/2/strategy.so"), read_file(house("striker")));
  EXPECT_EQ(ask("GET", "/favicon.ico").status, 200) << "each page of a browser asks for it";
  // A team with a token joins with its first good entry.
  const Outcome joined = expect_exit(0, hand_in("gamma", house("navigator"), {"--json"}));
  EXPECT_EQ(ordered_json::parse(joined.out)["state"], "accepted");
  EXPECT_TRUE(contains(read_file(folder_ + "/league.json"), "\"gamma\""));
  EXPECT_FALSE(contains(joined.out, folder_)) << "no path of the host is told";

  write_file(temporary_ / "bad.so", "no library");
  const Outcome refused = expect_exit(1, hand_in("alpha", temporary_ / "bad.so"));
  EXPECT_TRUE(contains(refused.out, "entry 2 plays on"));
  EXPECT_FALSE(contains(read_file(folder_ + "/entries/alpha/3/verdict.json"), folder_));

  write_file(temporary_ / "wrong.token", std::string(26, 'A'));
  EXPECT_EQ(hand_in("wrong", house("striker")).exit_code, 2);
  EXPECT_EQ(hand_in("nobody", house("striker")).exit_code, 3) << "no file of a token";
  EXPECT_EQ(run(league("token", folder_, {"alpha", "--revoke"})).exit_code, 0);
  expect_exit(2, hand_in("alpha", house("idle")), "was revoked");
  server_->signal(SIGTERM);
  EXPECT_EQ(server_->wait().exit_code, 0);
  EXPECT_EQ(hand_in("gamma", house("idle")).exit_code, 3) << "no server";

  // The league goes on with what was handed in.
  EXPECT_EQ(run(league("start", folder_, {"--jobs", "1"})).exit_code, 0);
  for (const auto& line : journal_of(folder_)) {
    if (line["kind"] == "entry" && line["team"] == "alpha") {
      EXPECT_EQ(line["entry"], 2);
    }
  }
}

// Catches a late file that plays, that is lost, or that the host cannot take.
TEST_F(HandIn, KeepsWhatComesAfterTheDeadlineForTheHostToDecide) {
  const std::string alpha = new_token("alpha");
  ASSERT_EQ(run(league("freeze", folder_, {"--reason", "last day"})).exit_code, 0);
  serve();
  const Outcome late = expect_exit(0, hand_in("alpha", house("striker")));
  EXPECT_TRUE(contains(late.out, "the host decides about it"));
  const auto entries = [&] { return run(league("status", folder_, {"--entries"})).out; };
  EXPECT_TRUE(contains(entries(), "entry 1 will play\n"));
  EXPECT_TRUE(contains(entries(), "entry 2 came after the deadline: the host decides about it\n"))
      << "a digest says the same";
  EXPECT_EQ(run(league("take", folder_, {"alpha", "1"})).exit_code, 2) << "it came in time";
  EXPECT_EQ(hand_in("alpha", house("chaser")).exit_code, 0);
  EXPECT_EQ(read_file(folder_ + "/entries/alpha/2/strategy.so"), read_file(house("striker")))
      << "a later file has removed it";
  EXPECT_TRUE(contains(entries(), "entry 3 came after the deadline"));
  EXPECT_FALSE(contains(page("/hand-in", alpha), "data-pin=\"3\""));
  EXPECT_TRUE(contains(page("/hand-in", alpha), "plays only if the host takes it"));
  EXPECT_TRUE(contains(page("/hand-in", alpha), "<p>The deadline was "));
  const std::string staff = staff_token();
  EXPECT_TRUE(contains(page("/hand-in?team=alpha", staff), "hand-in/entries/3?team=alpha"));
  EXPECT_TRUE(contains(page("/hand-in/entries/3?team=alpha", staff), "came after the deadline"));
  EXPECT_EQ(ask("GET", "/hand-in/entries/3", staff).status, 404) << "of no team";
  const Outcome taken = run(league("take", folder_, {"alpha", "2"}));
  EXPECT_EQ(taken.out, "alpha plays with entry 2\n") << taken.err;
  EXPECT_TRUE(contains(page("/hand-in/entries/2", alpha), "; the host has taken it"));
  EXPECT_TRUE(contains(entries(), "entry 2 will play\n"));
}

// Catches a deadline of a sheet that nobody is told, and a score that is not shown to its team, or
// to another one.
TEST_F(HandIn, ShowsDeadlinesAndScoresOfSheets) {
  const std::string alpha = new_token("alpha");
  const std::string beta = new_token("beta");
  write_file(folder_ + "/sheets.json", R"({"driving": {"until": "2026-11-13 18:00",
    "grace_days": 2, "extensions": {"beta": "2026-12-01 18:00"}}, "ball": {"until":
    "2026-12-11 18:00"}})");
  std::filesystem::create_directories(folder_ + "/marks/sheets");
  write_file(folder_ + "/marks/sheets/alpha.json", R"({"driving": "83.5"})");
  serve();
  const std::string own = page("/hand-in", alpha);
  for (const char* text : {">2026-11-13 18:00 UTC<", ">2026-11-15 18:00 UTC<", ">83.5<", ">ball<"})
    EXPECT_TRUE(contains(own, text)) << text;
  const std::string other = page("/hand-in", beta);
  EXPECT_TRUE(contains(other, ">2026-12-01 18:00 UTC<"));
  EXPECT_FALSE(contains(other, "83.5"));
  EXPECT_TRUE(contains(page("/hand-in", staff_token()),
                       "Sheet driving: until 2026-11-13 18:00 UTC, with "
                       "grace until 2026-11-15 18:00 UTC; beta until "));
}

// A faculty shows each league below a path of its server: a link that begins with "/" leaves it. A
// proxy passes the whole path on, or cuts off the beginning.
TEST_F(HandIn, LivesBelowAPath) {
  const std::string alpha = new_token("alpha");
  const std::string staff = staff_token();
  for (const std::string below : {"/spring", ""}) {
    server_.reset();
    serve(below.empty() ? std::vector<std::string>() : std::vector<std::string>{"--base", below});
    url_ = "http://127.0.0.1:" + std::to_string(port_) + below + "/";
    if (!below.empty()) EXPECT_EQ(hand_in("alpha", house("striker")).exit_code, 0);
    EXPECT_EQ(ask("GET", below + "/api/v1/entries", alpha).status, 200);
    for (const auto& [path, token] :
         std::vector<std::pair<std::string, std::string>>{{"/", ""},
                                                          {"/index.html", ""},
                                                          {"/teams/alpha.html", ""},
                                                          {"/hand-in", ""},
                                                          {"/hand-in", alpha},
                                                          {"/hand-in/entries/2", alpha},
                                                          {"/hand-in/entries/2/replay", alpha},
                                                          {"/hand-in?team=alpha", staff},
                                                          {"/hand-in", staff}}) {
      const web::Answer shown = ask("GET", below + path, token);
      EXPECT_EQ(shown.status, 200) << below + path;
      for (const char* link : {"href=\"/", "src=\"/", "action=\"/", "file\":\"/"})
        EXPECT_FALSE(contains(shown.body, link)) << below + path << ": " << link;
    }
    EXPECT_EQ(ask("GET", below + "/hand-in/").status, 308) << "to /hand-in";
    for (const char* link : {"/../hand-in", "/../../hand-in.js"})
      EXPECT_EQ(ask("GET", below + link).status, 404) << link;
  }
  serve({"--base", "/spring"});
  EXPECT_EQ(ask("GET", "/spring").status, 308);
  EXPECT_EQ(ask("GET", "/springs/").status, 404);
  server_.reset();
  EXPECT_EQ(run(league("serve", folder_, {"--base", "spring"})).exit_code, 2);
}

// Catches a verdict or a result that is read from what a library prints.
TEST_F(HandIn, BelievesNothingThatALibraryPrints) {
  const std::string liar = program("hostile/false_verdict.so");
  new_token("alpha");
  serve();
  const Outcome refused = expect_exit(1, hand_in("alpha", liar, {"--json"}));
  const auto told = ordered_json::parse(refused.out);
  EXPECT_EQ(told["state"], "refused");
  EXPECT_TRUE(contains(told["message"].get<std::string>(), "(crash)")) << told;
  EXPECT_EQ(told["plays"], "entry 1 plays on");
  EXPECT_TRUE(contains(told["log"].get<std::string>(), "it is good"))
      << "the library has printed nothing: " << told;
  server_->signal(SIGTERM);
  EXPECT_EQ(server_->wait().exit_code, 0);
  EXPECT_EQ(run(league("submit", folder_, {"alpha", liar})).exit_code, 1);
  for (const char* entry : {"2", "3"}) {
    const std::string place = folder_ + "/entries/alpha/" + entry;
    EXPECT_EQ(ordered_json::parse(read_file(place + "/verdict.json"))["accepted"], false);
  }

  expect_exit(0,
              run({program("mirocup"), "match", "--blue", liar, "--yellow", "idle", "--half", "1",
                   "--record", temporary_ / "leg.json", "--answer", temporary_ / "answer"}));
  const auto result = ordered_json::parse(read_file(temporary_ / "leg.json"))["result"];
  EXPECT_EQ(result["fault"]["code"], "crash");
  EXPECT_EQ(result["winner"], "yellow");
  EXPECT_EQ(read_file(temporary_ / "answer"), "");
}

TEST_F(HandIn, PlaysWithThePinnedVersion) {
  new_token("alpha");
  serve();
  ASSERT_EQ(hand_in("alpha", house("striker")).exit_code, 0);
  const auto pin = [&](const char* entry) {
    return run_mirocup(
        {"hand-in", url_, "--token-file", temporary_ / "alpha.token", "--pin", entry});
  };
  EXPECT_EQ(pin("7").exit_code, 2);
  const Outcome pinned = expect_exit(0, pin("1"));
  EXPECT_EQ(pinned.out, "entry 1 plays\n");
  const Outcome later = hand_in("alpha", house("navigator"));
  EXPECT_TRUE(contains(later.out, "entry 1, which is pinned, plays on"));
  // The burst of the later entry waits for nobody, and the league starts with the pinned one.
  EXPECT_TRUE(wait_until([&] {
    return read_file(folder_ + "/hand-ins.jsonl").find("\"played\"") != std::string::npos;
  }));
  EXPECT_EQ(run(league("start", folder_, {"--jobs", "1"})).exit_code, 0);
  for (const auto& line : journal_of(folder_)) {
    if (line["kind"] == "entry" && line["team"] == "alpha") {
      EXPECT_EQ(line["entry"], 1);
    }
  }
  EXPECT_EQ(pin("2").exit_code, 2) << "the league has started";
  expect_exit(2, hand_in("alpha", house("striker")), "the league has started");
}

// Each answer follows its act at once, and the page before it makes the caches fresh. Catches a
// cache of the server that is not told of what the server itself has written.
TEST_F(HandIn, ShowsInTheNextAnswerWhatItHasWritten) {
  const std::string staff = staff_token();
  const std::string alpha = new_token("alpha");
  new_token("gamma");
  serve();
  const auto opponents = [&] {
    return ordered_json::parse(page("/api/v1/friendlies", alpha))["opponents"].dump();
  };
  const auto shows = [&](const std::string& path, const std::string& text) {
    return page(path).find(text) != std::string::npos;
  };
  for (int i = 0; i < 5; ++i) {
    const std::string text = "notice " + std::to_string(i);
    EXPECT_FALSE(shows("/", text));
    ASSERT_EQ(act(staff, {{"act", "notice"}, {"text", text}}), 303);
    EXPECT_TRUE(shows("/", text)) << i;
    const std::string name = "Rovers " + std::to_string(i);
    EXPECT_FALSE(shows("/teams/beta.html", name));
    ASSERT_EQ(act(staff, {{"act", "people"}, {"team", "beta"}, {"display", name}}), 303);
    for (const char* path : {"/", "/teams/beta.html"}) EXPECT_TRUE(shows(path, name)) << i << path;
  }
  // A team joins by its check, and is an opponent as soon as it is told so.
  EXPECT_FALSE(shows("/", "gamma"));
  EXPECT_FALSE(contains(opponents(), "gamma"));
  expect_exit(0, hand_in("gamma", house("navigator")));
  EXPECT_TRUE(shows("/", "gamma"));
  EXPECT_TRUE(contains(opponents(), "gamma"));
}

// The data in a replay page.
ordered_json data_of(const std::string& page) {
  constexpr std::string_view begin = R"(id="leg">)";
  const std::size_t at = page.find(begin);
  if (at == std::string::npos) return {};
  const std::size_t from = at + begin.size();
  return ordered_json::parse(page.substr(from, page.find("</script>", from) - from), nullptr,
                             false);
}

// Catches thoughts that are not kept, that another team or the public sees, with or without the
// name of their file, and pages of publish that have them.
TEST_F(HandIn, ShowsThoughtsToTheirTeamAndTheStaffOnly) {
  auto file = ordered_json::parse(read_file(folder_ + "/league.json"));
  file["thoughts"] = true;
  file["teams"][0]["entry"] = "house:tactician";
  file["teams"][1]["entry"] = "house:navigator";
  write_file(folder_ + "/league.json", file.dump(2));
  const std::string alpha = new_token("alpha"), beta = new_token("beta"), staff = staff_token();
  ASSERT_EQ(run(league("start", folder_, {"--jobs", "1"})).exit_code, 0);
  ASSERT_EQ(run(league("publish", folder_)).exit_code, 0);
  serve();
  const auto legs = ordered_json::parse(page("/api/v1/legs", alpha))["legs"];
  ASSERT_EQ(legs.size(), 2u);
  for (const auto& leg : legs) {
    ASSERT_TRUE(leg.contains("thoughts")) << leg;
    const std::string own = leg["colour"].get<std::string>(),
                      other = own == "blue" ? "yellow" : "blue";
    const std::string path = leg["thoughts"].get<std::string>();
    const auto seen_with = [&](const std::string& token) {
      return data_of(page(path, token))["own"];
    };
    EXPECT_TRUE(seen_with(alpha)[own].contains("thoughts"));
    EXPECT_FALSE(seen_with(alpha).contains(other));
    EXPECT_TRUE(seen_with(beta)[other].contains("thoughts"));
    EXPECT_FALSE(seen_with(beta).contains(own));
    const std::string replay = leg["replay"].get<std::string>(),
                      record = leg["record"].get<std::string>();
    for (const std::string& token : {alpha, beta, staff, std::string()}) {
      const auto open = ask("GET", replay, token);
      EXPECT_EQ(open.status, 200);
      EXPECT_FALSE(data_of(open.body).contains("own"));
      const std::string stem = record.substr(0, record.rfind('.'));
      for (const std::string colour : {"blue", "yellow"}) {
        EXPECT_TRUE(fs::exists(folder_ + stem + "." + colour + ".thoughts.zst"));
        for (const std::string begin : {"", "/replays/..", "/replays/%2e%2e", "//", "/."})
          EXPECT_NE(ask("GET", begin + stem + "." + colour + ".thoughts.zst", token).status, 200)
              << begin;
      }
    }
    EXPECT_FALSE(data_of(read_file(folder_ + "/site" + replay)).contains("own"));
  }
}

TEST_F(HandIn, IsEncrypted) {
  const std::string certificate = temporary_ / "cert.pem";
  const std::string key = temporary_ / "key.pem";
  ASSERT_EQ(run({"/usr/bin/openssl", "req", "-x509", "-newkey", "ec", "-pkeyopt",
                 "ec_paramgen_curve:prime256v1", "-nodes", "-days", "2", "-subj", "/CN=127.0.0.1",
                 "-addext", "subjectAltName=IP:127.0.0.1", "-keyout", key, "-out", certificate})
                .exit_code,
            0);
  new_token("alpha");
  serve({"--tls", certificate, key});
  EXPECT_EQ(url_.find("https://127.0.0.1:"), 0u);
  expect_exit(0, hand_in("alpha", house("striker"), {"--ca", certificate}));
  EXPECT_EQ(hand_in("alpha", house("idle")).exit_code, 3) << "nobody has signed for this server";
  // More than once: the server writes why to a viewer that is gone, which must not end it.
  for (int i = 0; i < 30; ++i)
    EXPECT_EQ(ask("GET", "/").status, 0) << "without TLS there is no page";
  const auto browser = web::HttpClient::open(url_, {.authority = certificate});
  EXPECT_TRUE(contains(browser.value().ask("GET", "/hand-in").body, "Token of your team"));

  expect_exit(2, run(league("serve", folder_, {"--tls", key, certificate})), "key.pem");
}

// A server that answers `mirocup hand-in` as it likes.
class OtherServer {
 public:
  OtherServer() {
    write_file(temporary_ / "token", std::string(26, 'A'));
    EXPECT_TRUE(server_.listen({}, "--at"));
  }
  OtherServer(const OtherServer&) = delete;
  OtherServer& operator=(const OtherServer&) = delete;

  Outcome hand_in(const std::vector<std::string>& more) const {
    std::vector<std::string> words{program("mirocup"), "hand-in", server_.url(), "--token-file",
                                   temporary_ / "token"};
    words.insert(words.end(), more.begin(), more.end());
    return run(words);
  }

  std::string team = R"({"team": "a", "why_not": null})";
  std::string taken = R"({"entry": 1})";
  std::string entry = R"({"state": "accepted", "message": "good"})";
  std::string pinned = R"({"playing": 1})";
  std::string friendlies = R"({"progress": [], "change": null})";

 private:
  web::Reply answer(const web::Request& request, const web::Body& body) {
    if (request.method == "PUT") body([](std::string_view) { return true; });
    if (request.path == "/api/v1/team") return {.bytes = team};
    if (request.path == "/api/v1/entries") return {.status = 202, .bytes = taken};
    if (request.path == "/api/v1/pin") return {.bytes = pinned};
    if (request.path == "/api/v1/friendlies") return {.bytes = friendlies};
    if (request.path != "/api/v1/entries/1") return {.status = 404};
    return {.bytes = entry};
  }

  TemporaryFolder temporary_;
  web::HttpServer server_{
      [this](const web::Request& request, const web::Body& body) { return answer(request, body); },
      {.bodies = {.max_upload = 32u << 20}}};
};

// Catches a value of another type that ends the client by an exception, and one that it believes.
TEST(HandInAtAServerOfAnotherKind, IsAnsweredWithASentence) {
  const std::string file = house("idle");
  OtherServer server;
  EXPECT_EQ(server.hand_in({file}).out, "good\n");
  EXPECT_EQ(server.hand_in({"--pin", "1"}).out, "entry 1 plays\n");
  EXPECT_EQ(server.hand_in({"--progress"}).exit_code, 0);
  const auto expect_sentence = [&](std::string& body, const std::vector<std::string>& wrong,
                                   const std::vector<std::string>& words) {
    const std::string right = body;
    for (const std::string& one : wrong) {
      body = one;
      const Outcome told = server.hand_in(words);
      EXPECT_EQ(told.exit_code, 3) << one << told.err;
      EXPECT_EQ(told.out, "") << one;
      EXPECT_TRUE(contains(told.err, " does not answer as a league: /")) << one;
    }
    body = right;
  };
  expect_sentence(server.team, {"<html>", "", "[1]", "7", R"({"why_not": 5})"}, {file});
  expect_sentence(server.taken,
                  {"<html>", "{}", R"({"entry": "x"})", R"({"entry": 0})", R"({"entry": 1.5})",
                   R"({"entry": 99999999999999999999999})", "[[[[1]]]]"},
                  {file});
  expect_sentence(
      server.entry,
      {"<html>", "[]", "{}", R"({"state": 7})", R"({"state": "ready"})", R"({"state": "queued"})",
       R"({"state": "queued", "before": -2000000000})", R"({"state": "queued", "before": 1e30})",
       R"({"state": "checking", "step": {"name": 5, "number": "x"}})",
       R"({"state": "checking", "step": [1]})", R"({"state": "refused", "reason": {"a": 1}})",
       R"({"state": "accepted", "message": 5})", R"({"state": "accepted", "told": [1, {}]})",
       R"({"state": "accepted", "told": "abc", "plays": 1})",
       R"({"state": "accepted", "notes": {"a": 1}})",
       R"({"state": "accepted", "notes": [1, "x", null]})", R"({"state": "accepted", "log": [1]})",
       R"({"state": "accepted", "state": "void"})", std::string(300'000, '[')},
      {file});
  expect_sentence(server.pinned, {"<html>", "{}", R"({"playing": "x"})", R"({"playing": -1})"},
                  {"--pin", "1"});
  expect_sentence(server.friendlies,
                  {"<html>", "{}", R"({"progress": "x"})", R"({"progress": [1, 2]})",
                   R"({"progress": [{"entry": "a", "rating": "b", "low": {}, "high": []}]})",
                   R"({"progress": [{"against": [1]}]})",
                   R"({"progress": [{"entry": 1, "rating": 0, "low": 0, "high": 0,
                                     "against": {"x": "z"}, "drills": null}]})",
                   R"({"progress": [], "change": [1]})"},
                  {"--progress"});
}

// The server, the check's own process, `mirocup check`, the processes of its strategies.
void kill_one_below(int pid, std::mt19937& random) {
  std::vector<int> living{pid};
  for (std::size_t i = 0; i < living.size(); ++i) {
    const std::string id = std::to_string(living[i]);
    std::istringstream children(read_file("/proc/" + id + "/task/" + id + "/children"));
    for (int child = 0; children >> child;) living.push_back(child);
  }
  // The server itself in one of four.
  const std::size_t chosen = random() % 4 == 0 ? 0 : random() % living.size();
  kill(living[chosen], SIGKILL);
}

TEST_F(HandIn, LosesAndDoublesNothingByKills) {
  const char* wanted = std::getenv("MIROCUP_KILLS");
  const int most = wanted != nullptr ? std::atoi(wanted) : 8;
  std::map<std::string, std::string> tokens;
  // A team has twenty tries an hour.
  for (int i = 0; i < std::max(4, most / 10); ++i) {
    const std::string team = "team" + std::to_string(i);
    tokens[team] = new_token(team);
  }
  std::mt19937 random(1);
  std::map<std::pair<std::string, int>, std::string> taken;  // bytes of each entry
  write_file(temporary_ / "bad.so", "no library");
  serve({"--jobs", "2"});
  int number = 0;
  for (int kills = 0; kills < most; ++kills) {
    for (const auto& [team, token] : tokens) {
      // Good and bad files, each with bytes of its own.
      std::string bytes = number % 2 == 0 ? read_file(house("chaser")) : "no library";
      bytes += std::to_string(number++);
      const auto reply = ask("PUT", "/api/v1/entries", token, bytes);
      if (reply.status != 202) continue;  // killed, or the team has had enough
      const int entry = ordered_json::parse(reply.body)["entry"].get<int>();
      EXPECT_TRUE(taken.emplace(std::pair(team, entry), bytes).second) << "numbered twice";
    }
    // The host hands in, too, and a team takes its pin back.
    Running host(league("submit", folder_, {"beta", temporary_ / "bad.so"}));
    ask("PUT", "/api/v1/pin?entry=latest", tokens.begin()->second);
    usleep(static_cast<useconds_t>(random() % 200'000));
    if (random() % 2 == 0) host.signal(SIGKILL);
    kill_one_below(server_->pid(), random);
    host.wait();
    usleep(20'000);
    if (kill(server_->pid(), 0) != 0 ||
        read_file("/proc/" + std::to_string(server_->pid()) + "/cmdline").empty()) {
      server_->wait();
      serve({"--jobs", "2"});
    }
  }
  ASSERT_FALSE(taken.empty());
  for (const auto& [key, bytes] : taken) {
    const std::string team = key.first;
    const int entry = key.second;
    ordered_json state;
    ASSERT_TRUE(wait_until([&] {
      state = state_of(tokens[team], entry);
      return state.is_object() && (state["state"] == "accepted" || state["state"] == "refused");
    })) << team
        << entry << " " << state << server_->err();
    const bool is_good = bytes.substr(0, 4) ==
                         "\x7f"
                         "ELF";
    EXPECT_EQ(state["state"], is_good ? "accepted" : "refused") << state;
  }
  std::map<std::pair<std::string, int>, int> answers;
  for (const auto& line : book()) {
    if (line["kind"] == "answer")
      ++answers[{line["team"].get<std::string>(), line["entry"].get<int>()}];
  }
  for (const auto& [key, count] : answers) EXPECT_EQ(count, 1) << key.first << key.second;
  for (const auto& [key, bytes] : taken) {
    EXPECT_EQ(answers[key], 1) << key.first << key.second;
    const std::string path =
        folder_ + "/entries/" + key.first + "/" + std::to_string(key.second) + "/strategy.so";
    if (fs::exists(path)) {
      EXPECT_EQ(read_file(path), bytes) << path;
    }
  }
  EXPECT_TRUE(fs::is_empty(folder_ + "/entries/.uploads"));
}

}  // namespace
}  // namespace mirocup
