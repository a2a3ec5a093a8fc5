// SPDX-License-Identifier: MIT
//
// A league that is shown round by round looks as it did when that round had been played. Catches
// pages that give away what comes later: a score, a pairing, a place in the table.
#include "tournaments/publish/snapshot.hpp"

#include "tests/support/is_ok.hpp"
#include "tests/support/memory_files.hpp"
#include "tests/unit/tournaments/small_league.hpp"
#include "tests/unit/tournaments/whole_site.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <map>

namespace mirocup::league {
namespace {

using test_support::MemoryFiles;

std::string round_of(const Fixture& f) {
  return (f.part == Part::knockout ? "k" : "r") + std::to_string(f.round);
}

// Plays a league round by round and keeps the pages after each round.
struct Season {
  MemoryFiles files;
  Journal journal;
  LeagueState state;
  std::map<std::string, std::vector<SiteFile>> after;  // by round

  explicit Season(const LeagueFile& file, bool with_pages = true)
      : journal(std::move(*Journal::open(files, "journal.jsonl"))), state(new_league(file)) {
    write(Started{.config_sha256 = "x", .version = ""});
    for (const TeamConfig& team : file.teams)
      write(EntryBooked{.team = team.name, .entry = 1, .sha256 = "s"});
    // Fixtures are added while it is played.
    for (std::size_t i = 0; i < state.fixtures.size(); ++i) {
      for (int leg = 1; leg <= state.fixtures[i].needed(); ++leg) {
        if (!state.fixtures[i].legs[leg - 1].played)
          write(made_up_leg(state, state.fixtures[i].fixture, leg));
      }
      if (with_pages && is_last_of_its_round(i))
        after[round_of(state.fixtures[i].fixture)] = make_site({state});
    }
  }

  bool is_last_of_its_round(std::size_t i) const {
    const std::string round = round_of(state.fixtures[i].fixture);
    for (std::size_t later = i + 1; later < state.fixtures.size(); ++later) {
      if (round_of(state.fixtures[later].fixture) == round) return false;
    }
    return true;
  }

  void write(const Event& event) {
    EXPECT_TRUE(journal.append(std::string(kind_of(event)), fields_of(event)));
    const auto valid = validate(state, event);
    EXPECT_TRUE(test_support::is_ok(valid));
    league::apply(state, event);
  }
};

TEST(Snapshot, ShowsALeagueAsItWasAfterARound) {
  for (const auto kind : {FormatKind::double_round_robin, FormatKind::groups, FormatKind::knockout,
                          FormatKind::swiss}) {
    const Season season(numbered_teams(kind, 9));
    EXPECT_TRUE(season.state.is_over()) << to_string(kind);
    EXPECT_GE(season.after.size(), 4u);
    for (const auto& [round, pages] : season.after) {
      const auto shown = state_through(season.state, season.journal, round);
      ASSERT_TRUE(test_support::is_ok(shown));
      const auto again = make_site({*shown});
      ASSERT_EQ(again.size(), pages.size());
      for (std::size_t i = 0; i < pages.size(); ++i)
        EXPECT_EQ(again[i].bytes, pages[i].bytes)
            << to_string(kind) << " " << round << " " << pages[i].name;
    }
  }
}

// Catches a show whose table after a leg knows of a later one.
TEST(Snapshot, ShowsARoundLegByLeg) {
  for (const auto kind : {FormatKind::double_round_robin, FormatKind::knockout}) {
    const Season season(numbered_teams(kind, 9), false);
    const std::string first = kind == FormatKind::knockout ? "k1" : "r1";
    const auto whole = state_through(season.state, season.journal, first);
    ASSERT_TRUE(whole);
    std::set<LegName> shown;
    for (const FixtureState& f : season.state.fixtures) {
      if (round_of(f.fixture) != first || !f.fixture.has_both()) continue;
      for (int leg = 1; leg <= f.needed(); ++leg) {
        const auto before = state_through(season.state, season.journal, first, &shown);
        ASSERT_TRUE(test_support::is_ok(before));
        EXPECT_EQ(before->results().size(), shown.size());
        shown.insert({f.fixture.id(), leg});
      }
    }
    const auto after = state_through(season.state, season.journal, first, &shown);
    ASSERT_TRUE(after);
    EXPECT_EQ(after->played(), whole->played());
  }
}

// Catches a team that joins in the second week and stands in the table of the first.
TEST(Snapshot, ShowsANightWithoutTheTeamsThatJoinedAfterIt) {
  Season season(league_file_of({"a", "b"}, {.kind = FormatKind::nightly}, "submitted"), false);
  const auto play_night = [&season](int number, const std::vector<EntryBooked>& entries) {
    season.write(NightBegan{.number = number, .entries = entries});
    for (std::size_t i = 0; i < season.state.fixtures.size(); ++i) {
      const Fixture fixture = season.state.fixtures[i].fixture;
      for (int leg = 1; leg <= season.state.fixtures[i].needed(); ++leg) {
        if (!season.state.fixtures[i].legs[leg - 1].played)
          season.write(made_up_leg(season.state, fixture, leg));
      }
    }
  };
  play_night(1, {});
  const auto first = make_site({season.state});
  season.write(TeamJoined{.team = "c", .source = "submitted"});
  season.write(Paused{.team = "c", .signature = {"w", "H"}});
  season.write(Resumed{.team = "c", .signature = {"w", "H"}});
  play_night(2, {{.team = "c", .entry = 1, .sha256 = "u"}});
  const auto shown = state_through(season.state, season.journal, "r1");
  ASSERT_TRUE(test_support::is_ok(shown));
  EXPECT_EQ(shown->teams.size(), 2u);
  const auto again = make_site({*shown});
  ASSERT_EQ(again.size(), first.size());
  for (std::size_t i = 0; i < first.size(); ++i)
    EXPECT_EQ(again[i].bytes, first[i].bytes) << first[i].name;
  const auto second = state_through(season.state, season.journal, "r2");
  ASSERT_TRUE(test_support::is_ok(second));
  EXPECT_EQ(second->fixtures.size(), 4u);
}

// Who sees what is not released: docs/hosting.md. Catches a level that tells a team what nobody may
// know, and one that hides the league from its staff.
TEST(Snapshot, ShowsEachViewerWhatIsReleasedForIt) {
  LeagueState whole = new_league(numbered_teams(FormatKind::double_round_robin, 9));
  const LeagueState released = whole;
  for (const char* through : {"", "r1"}) {
    for (const auto level : {ReleaseLevel::all, ReleaseLevel::teams, ReleaseLevel::hidden}) {
      whole.release.level = level;
      whole.release.through = through;
      const bool is_open = level == ReleaseLevel::all && whole.release.through.empty();
      const auto sees_whole = [&](Viewer viewer) {
        return &*seen_by(viewer, whole, released) == &whole;
      };
      EXPECT_EQ(sees_whole(Viewer::visitor), is_open) << to_string(level) << through;
      EXPECT_EQ(sees_whole(Viewer::team), is_open || level == ReleaseLevel::teams);
      EXPECT_TRUE(sees_whole(Viewer::staff));
      EXPECT_EQ(sees_nights(Viewer::visitor, whole), is_open);
    }
  }
  whole.file.format.kind = FormatKind::nightly;
  EXPECT_TRUE(sees_nights(Viewer::visitor, whole)) << "a night is a round";
}

TEST(Snapshot, KnowsWhichRoundsThereAre) {
  const Season season(numbered_teams(FormatKind::knockout, 9));
  for (const char* round : {"", "k", "k0", "k9", "r1", "k1x", "k-1", "x1"}) {
    const auto shown = state_through(season.state, season.journal, round);
    ASSERT_FALSE(shown) << round;
    EXPECT_EQ(shown.error().code, Errc::input);
  }
}

}  // namespace
}  // namespace mirocup::league
