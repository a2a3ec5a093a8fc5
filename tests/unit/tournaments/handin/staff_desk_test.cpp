// SPDX-License-Identifier: MIT
//
// The page of the staff, through the desk. Catches a form that a team or a foreign page may send, a
// decision without a reason, one that is written although it was only tried, names of people that
// become markup, an act that the page offers and the desk does not know.
#include "tests/support/temporary_folder.hpp"
#include "tests/unit/tournaments/small_league.hpp"
#include "tournaments/handin/portal.hpp"
#include "tournaments/league/acts.hpp"
#include "tournaments/league/people.hpp"

#include <gtest/gtest.h>

#include <regex>

namespace mirocup::league {
namespace {

constexpr std::int64_t moment = 1'796'061'600;  // 2026-11-30T18:00:00Z

class StaffPage : public testing::Test, public PortalLeague {
 protected:
  StaffPage() {
    LeagueFile file = league_file_of({"alpha", "beta"}, {}, "submitted");
    file.title = "Spring";
    file.zone = "Europe/Berlin";
    file.time_zone = system::TimeZone::find(file.zone).value();
    EXPECT_TRUE(init_folder(disk_, folder_, file));
    auto store = LeagueStore::open(disk_, folder_);
    EXPECT_TRUE(store && store->write(start_of(disk_, folder_)));
    fixture_ = store->state().fixtures[0].fixture.id();
    TokenList list;
    alpha_ = list.add("alpha", utc_text(moment), "");
    staff_ = list.add_for(Role::staff, "", utc_text(moment), "");
    tutor_ = list.add_for(Role::tutor, "", utc_text(moment), "");
    assistant_ = list.add_for(Role::assistant, "A. Berg", utc_text(moment), "");
    EXPECT_TRUE(write_tokens(disk_, folder_, list));
    portal_ =
        std::move(*Portal::open(disk_, folder_, *this, {.now = [] { return moment; }}, nullptr));
  }

  HandInTerms hand_in_terms(const std::string&, const std::string&) override { return {}; }
  std::vector<OwnLeg> legs_of(Viewer, const std::string& team) override {
    return team == "alpha" ? legs_ : std::vector<OwnLeg>();
  }

  web::Reply ask(const std::string& method, const std::string& path, const std::string& token,
                 const std::string& form = "", const std::string& query = "") {
    web::Request request{.method = method, .path = path, .address = "10.0.0.1"};
    request.headers.emplace("host", "league.example");
    request.headers.emplace("authorization", "Bearer " + token);
    if (!query.empty()) request.query.emplace("done", query);
    const auto reply =
        portal_->answer(request, [&](const auto& take) { return take(std::string_view(form)); });
    return reply.value_or(web::Reply{.status = 404});
  }

  // The page without its markup.
  std::string text_of_page(const std::string& token, const std::string& done = "") {
    return std::regex_replace(std::regex_replace(ask("GET", "/hand-in", token, "", done).bytes,
                                                 std::regex("<[^>]*>"), ""),
                              std::regex("\\s+"), " ");
  }

  web::Reply act(const std::string& form) { return ask("POST", "/hand-in/staff", staff_, form); }

  std::vector<Decision> decisions() {
    return LeagueStore::open(disk_, folder_).value().state().decisions;
  }

  test_support::TemporaryFolder temporary_;
  system::Disk disk_;
  Folder folder_{temporary_ / "l"};
  std::string alpha_, staff_, tutor_, assistant_, fixture_;
  std::vector<OwnLeg> legs_;  // of alpha
  std::unique_ptr<Portal> portal_;
};

// Catches a decision that is signed by another than its token says, and grades for an assistant.
TEST_F(StaffPage, AnAssistantDecidesUnderItsNameAndSeesNoGrades) {
  const web::Reply page = ask("GET", "/hand-in", assistant_);
  EXPECT_NE(page.bytes.find("Signed by A. Berg"), std::string::npos);
  EXPECT_EQ(page.bytes.find("grades.csv"), std::string::npos);
  EXPECT_EQ(ask("GET", "/hand-in/grades.csv", assistant_).status, 403);
  const std::string form = "act=pause&team=alpha&reason=because&by=The+Professor&go=do";
  EXPECT_EQ(ask("POST", "/hand-in/staff", assistant_, form).status, 303);
  ASSERT_EQ(decisions().size(), 1u);
  EXPECT_EQ(std::get<Paused>(decisions().front().event).signature.by, "A. Berg");
}

// Catches a tutor's token that decides, and a page that offers it.
TEST_F(StaffPage, ATutorReadsAndDecidesNothing) {
  const web::Reply page = ask("GET", "/hand-in", tutor_);
  EXPECT_EQ(page.status, 200);
  EXPECT_NE(text_of_page(tutor_).find("Not handed in: alpha · beta"), std::string::npos);
  EXPECT_EQ(page.bytes.find("\"hand-in/staff\""), std::string::npos) << page.bytes;
  EXPECT_NE(ask("GET", "/hand-in", staff_).bytes.find("\"hand-in/staff\""), std::string::npos);
  EXPECT_EQ(ask("GET", "/hand-in/grades.csv", tutor_).status, 200);
  const web::Reply act = ask("POST", "/hand-in/staff", tutor_, "act=close&reason=over&go=do");
  EXPECT_EQ(act.status, 403);
  EXPECT_NE(act.bytes.find("decides nothing"), std::string::npos) << act.bytes;
  for (const char* path : {"/api/v1/pin", "/api/v1/entries", "/api/v1/friendlies"})
    EXPECT_GE(ask(path == std::string("/api/v1/friendlies") ? "POST" : "PUT", path, tutor_).status,
              400)
        << path;
  EXPECT_TRUE(decisions().empty());
}

TEST_F(StaffPage, DecidesWithAReasonAndTakesBack) {
  const std::string rule = "act=rule&fixture=" + fixture_ + "&leg=1&score=2%3A1&by=A.+Host&reason=";
  EXPECT_EQ(act(rule + "+-+&go=do").status, 400);
  const web::Reply tried = act(rule + "it+was+valid&go=try");
  EXPECT_EQ(tried.status, 200);
  EXPECT_NE(tried.bytes.find("2:1"), std::string::npos);
  EXPECT_NE(tried.bytes.find("(was not decided)"), std::string::npos);
  EXPECT_NE(tried.bytes.find("#rule-form\"><p role=\"status\">"), std::string::npos)
      << "the answer stands in its form, and is no error";
  EXPECT_TRUE(decisions().empty()) << "it was only tried";
  EXPECT_EQ(act(rule + "it+was+valid&go=do").status, 303);
  ASSERT_EQ(decisions().size(), 1u);
  const web::Reply page = ask("GET", "/hand-in", staff_, "", "1");
  EXPECT_NE(page.bytes.find("Decision 1 is written"), std::string::npos);
  EXPECT_NE(page.bytes.find("2026-11-30 19:00 CET (18:00 UTC)"), std::string::npos);
  EXPECT_NE(text_of_page(staff_).find("Not handed in: alpha · beta"), std::string::npos);
  EXPECT_EQ(act("act=undo&decision=1&reason=the+wrong+leg&go=do").status, 303);
  EXPECT_EQ(decisions()[0].undone_by, 1u);
  const web::Reply again = act("act=undo&decision=1&reason=again&go=do");
  EXPECT_EQ(again.status, 400);
  EXPECT_NE(again.bytes.find("#undo-form\"><p role=\"alert\">"), std::string::npos);
  const web::Reply opened = ask("GET", "/hand-in/staff", staff_);
  ASSERT_EQ(opened.status, 308) << "the address of an answer, opened again";
  EXPECT_EQ(opened.headers.front().second, "../hand-in");
  const auto state = LeagueStore::open(disk_, folder_).value().state();
  EXPECT_FALSE(state.fixtures[0].legs[0].played);
}

// Catches a notice that is markup, that is shown to nobody, or that a team may write; a schedule
// that does not know what comes.
TEST_F(StaffPage, TellsTheClassAndShowsWhatComes) {
  EXPECT_EQ(ask("POST", "/hand-in/staff", alpha_, "act=notice&text=x").status, 403);
  EXPECT_EQ(act("act=notice&text=No+%3Cb%3Enight%3C%2Fb%3E%0D%0Aon+Friday").status, 303);
  EXPECT_EQ(LeagueStore::open(disk_, folder_).value().state().notice, "No <b>night</b>\non Friday");
  EXPECT_NE(ask("GET", "/hand-in", staff_).bytes.find("No &lt;b&gt;night&lt;/b&gt;\non Friday<"),
            std::string::npos);
  EXPECT_EQ(act("act=notice&text=%00").status, 400);
  EXPECT_EQ(act("act=notice&text=" + std::string(1001, 'x')).status, 400);
  EXPECT_EQ(act("act=notice&text=").status, 303);
  EXPECT_EQ(LeagueStore::open(disk_, folder_).value().state().notice, "");
  EXPECT_NE(text_of_page(staff_).find("Round 1 0 of 2 legs are decided"), std::string::npos)
      << text_of_page(staff_);
}

TEST_F(StaffPage, KnowsEachActThatItOffers) {
  const std::string page = ask("GET", "/hand-in", staff_).bytes;
  const std::string leg = "&fixture=" + fixture_ + "&leg=all";
  for (const std::string& form :
       {"rule" + leg + "&score=1:1", "award" + leg + "&team=alpha", "void" + leg,
        std::string("pause&team=alpha"), std::string("resume&team=alpha"),
        std::string("freeze&from=2026-12-18T18:00:00"), std::string("freeze&lift=yes"),
        std::string("extend&team=alpha&from=2126-12-18T18:00:00"),
        std::string("release&level=hidden&through=r1"),
        std::string("withdraw&team=beta&results=keep"), std::string("close")}) {
    const std::string name = form.substr(0, form.find('&'));
    EXPECT_NE(page.find("value=\"" + name + "\""), std::string::npos) << name;
    EXPECT_EQ(act("act=" + form + "&reason=because&go=do").status, 303) << form;
  }
  EXPECT_EQ(act("act=pause&team=alpha&reason=because&go=do").status, 303)
      << "also when it is closed";
  EXPECT_EQ(act("act=rule&reason=because").status, 400);
  EXPECT_EQ(act("act=nonsense&reason=because").status, 400);
}

TEST_F(StaffPage, NamesPeopleInAnyLettersAndEscapesThem) {
  EXPECT_EQ(act("act=people&team=alpha&display=Zo%C3%AB+%26+%3Cb%3E&members=Ada%3B+Max").status,
            303);
  const web::Reply page = ask("GET", "/hand-in", staff_);
  EXPECT_NE(page.bytes.find("Zoë &amp; &lt;b&gt;"), std::string::npos);
  EXPECT_EQ(page.bytes.find("<b>"), std::string::npos);
  const auto people = read_people(disk_, folder_);
  ASSERT_TRUE(people);
  EXPECT_EQ(people->at("alpha").members, (std::vector<std::string>{"Ada", "Max"}));
  EXPECT_EQ(act("act=people&team=alpha&display=%0A").status, 400);
  EXPECT_EQ(act("act=people&team=nobody&display=x").status, 400);
}

// Catches display names on the pages of an anonymous league, and two teams of one name.
TEST(People, AreShownUnlessTheLeagueIsAnonymous) {
  LeagueFile file = league_file_of({"a", "b", "c"});
  const PeopleOfTeams people{{"a", {.display = "Löwen", .members = {}}},
                             {"b", {.display = "Löwen", .members = {}}}};
  EXPECT_EQ(shown_names(file, people), (std::vector<std::string>{"Löwen (a)", "Löwen (b)", "c"}));
  file.is_anonymous = true;
  EXPECT_TRUE(shown_names(file, people).empty());
}

}  // namespace
}  // namespace mirocup::league
