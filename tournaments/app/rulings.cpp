// SPDX-License-Identifier: MIT
//
// What a person decides about a league. Each is a line of the journal with a reason; the lines before
// stay. They may be given while the league is being played.
#include "tournaments/app/commands.hpp"
#include "tournaments/run/book.hpp"

#include <iostream>
#include <memory>

namespace mirocup::league {

namespace {

struct Options {
  std::string folder;
  std::string fixture;
  int leg = 0;  // 0: all
  std::string team;
  std::string score;
  std::string results = "keep";
  std::string reason;
  std::string by;
};

Json signed_fields(const Options& options, Json fields) {
  fields["why"] = options.reason;
  if (!options.by.empty()) fields["by"] = options.by;
  return fields;
}

// The legs that are meant: one, or all of the fixture.
Result<std::vector<int>> legs_of(const Book& book, const Options& options) {
  const auto index = book.state().find_fixture(options.fixture);
  if (!index) return fail(Errc::input, "there is no fixture " + options.fixture);
  if (options.leg > 0) return std::vector<int>{options.leg};
  std::vector<int> legs;
  for (int leg = 1; leg <= book.state().fixtures[*index].needed(); ++leg) legs.push_back(leg);
  return legs;
}

Result<int> rule(const Options& options, int home_goals, int away_goals) {
  record::Disk disk;
  auto book = Book::open(disk, Folder{options.folder});
  if (!book) return tl::unexpected(book.error());
  const auto legs = legs_of(*book, options);
  if (!legs) return tl::unexpected(legs.error());
  for (const int leg : *legs) {
    if (auto written = book->write(
            "ruling",
            signed_fields(options, {{"fixture", options.fixture},
                                    {"leg", leg},
                                    {"score", {{"home", home_goals}, {"away", away_goals}}}}));
        !written) {
      return tl::unexpected(written.error());
    }
    std::cout << options.fixture << " leg " << leg << ": " << home_goals << " : " << away_goals
              << '\n';
  }
  return exit_yes;
}

Result<int> award(const Options& options) {
  record::Disk disk;
  const auto book = Book::open(disk, Folder{options.folder});
  if (!book) return tl::unexpected(book.error());
  const LeagueState& state = book->state();
  const auto index = state.find_fixture(options.fixture);
  if (!index) return fail(Errc::input, "there is no fixture " + options.fixture);
  const Fixture& fixture = state.fixtures[*index].fixture;
  const auto team = state.find_team(options.team);
  if (!team || (*team != fixture.home && *team != fixture.away))
    return fail(Errc::input, options.team + " does not play in " + options.fixture);
  const int goals = state.file.rules.forfeit_goals;
  return rule(options, *team == fixture.home ? goals : 0, *team == fixture.home ? 0 : goals);
}

Result<int> rule_score(const Options& options) {
  int home = -1;
  int away = -1;
  char colon = 0;
  std::istringstream text(options.score);
  if (!(text >> home >> colon >> away) || colon != ':' || !(text >> std::ws).eof() || home < 0 ||
      away < 0) {
    return fail(Errc::input, options.score + " is no score: HOME:AWAY is expected, as in 2:1");
  }
  return rule(options, home, away);
}

Result<int> annul(const Options& options) {
  record::Disk disk;
  auto book = Book::open(disk, Folder{options.folder});
  if (!book) return tl::unexpected(book.error());
  const auto legs = legs_of(*book, options);
  if (!legs) return tl::unexpected(legs.error());
  for (const int leg : *legs) {
    const auto index = book->state().find_fixture(options.fixture);
    const int attempt =
        leg <= most_legs ? book->state().fixtures[*index].legs[leg - 1].voids + 1 : 1;
    if (auto written = book->write("void", signed_fields(options, {{"fixture", options.fixture},
                                                                   {"leg", leg},
                                                                   {"attempt", attempt},
                                                                   {"cause", "ruling"}}));
        !written) {
      return tl::unexpected(written.error());
    }
    std::cout << options.fixture << " leg " << leg << ": void; league start plays it again\n";
  }
  return exit_yes;
}

Result<int> write_team_line(const Options& options, const std::string& kind, Json fields) {
  record::Disk disk;
  auto book = Book::open(disk, Folder{options.folder});
  if (!book) return tl::unexpected(book.error());
  fields["team"] = options.team;
  if (auto written = book->write(kind, signed_fields(options, std::move(fields))); !written)
    return tl::unexpected(written.error());
  return exit_yes;
}

Result<int> withdraw(const Options& options) {
  const auto done = write_team_line(options, "withdraw", {{"results", options.results}});
  if (done) {
    std::cout << options.team << " has withdrawn; "
              << (options.results == "keep" ? "its results stay, the others win what is left\n"
                                            : "its results count for nothing\n");
  }
  return done;
}

Result<int> pause(const Options& options) {
  return write_team_line(options, "pause", Json::object());
}

Result<int> resume(const Options& options) {
  return write_team_line(options, "resume", Json::object());
}

class Builder {
 public:
  Builder(CLI::App& app, Run& run) : app_(app), run_(run) {}

  // A command with DIR and a reason.
  void begin(const char* name, const char* description, Result<int> (*command)(const Options&)) {
    options_ = std::make_shared<Options>();
    sub_ = app_.add_subcommand(name, description);
    sub_->add_option("DIR", options_->folder, "the league's folder")->required();
    auto options = options_;
    Run& run = run_;
    sub_->callback(
        [options, command, &run] { run = [options, command] { return command(*options); }; });
  }

  void fixture() {
    sub_->add_option("FIXTURE", options_->fixture, "its id, as in r3-f1")->required();
    sub_->add_option("--leg", options_->leg, "1, 2 or 3 (default: all)")->check(CLI::Range(1, 3));
  }

  void team() { sub_->add_option("TEAM", options_->team, "its name")->required(); }

  void end(bool needs_reason) {
    auto* reason = sub_->add_option("--reason", options_->reason, "why; it is published");
    if (needs_reason) reason->required();
    sub_->add_option("--by", options_->by, "who decided; it is published");
  }

  CLI::App& sub() { return *sub_; }
  Options& options() { return *options_; }

 private:
  CLI::App& app_;
  Run& run_;
  CLI::App* sub_ = nullptr;
  std::shared_ptr<Options> options_;
};

}  // namespace

void add_rulings(CLI::App& app, Run& run) {
  Builder b(app, run);
  b.begin("award", "Give a fixture or a leg to a team, as by a forfeit", award);
  b.fixture();
  b.team();
  b.end(true);

  b.begin("rule", "Decide the score of a fixture's legs or of one", rule_score);
  b.fixture();
  b.sub().add_option("--score", b.options().score, "HOME:AWAY")->required();
  b.end(true);

  b.begin("void", "Let legs count for nothing and be played again with the same seed", annul);
  b.fixture();
  b.end(true);

  b.begin("withdraw", "Take a team out of the league", withdraw);
  b.team();
  b.sub()
      .add_option("--results", b.options().results, "keep what it played, or annul it")
      ->check(CLI::IsMember({"keep", "annul"}))
      ->capture_default_str();
  b.end(true);

  b.begin("pause", "Play no legs of a team for now", pause);
  b.team();
  b.end(true);

  b.begin("resume", "Let a paused team play again", resume);
  b.team();
  b.end(false);
}

}  // namespace mirocup::league
