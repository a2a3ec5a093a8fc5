// SPDX-License-Identifier: MIT
//
// A portal, and the host's own hand-ins, killed before, within and behind each of their writes: the
// next process goes on, and a client that was not told repeats its request. Catches a file, an
// answer, a pin or a friendly that is lost or that counts twice, and what follows from the book and
// is never done.
#include "tests/support/temporary_folder.hpp"
#include "tests/unit/tournaments/kept_entry.hpp"
#include "tests/unit/tournaments/small_league.hpp"
#include "tournaments/handin/portal.hpp"
#include "tournaments/league/league_store.hpp"

#include <csignal>
#include <sstream>
#include <sys/wait.h>
#include <unistd.h>

namespace mirocup::league {
namespace {

enum class Moment { before, within, behind };

// A disk on which this process is killed at a write.
class DeadlyDisk final : public system::Disk {
 public:
  DeadlyDisk(int write, Moment moment) : left_(write), moment_(moment) {}

  using Path = const std::string&;
  Result<void> write(Path path, std::string_view bytes, system::Readers readers) override {
    return at_write([&](std::size_t) { return Disk::write(path, bytes, readers); });
  }
  Result<void> append(Path path, std::string_view bytes) override {
    return at_write(
        [&](std::size_t part) { return Disk::append(path, bytes.substr(0, bytes.size() / part)); });
  }
  Result<void> make_folder(Path path, system::Readers readers) override {
    return at_write([&](std::size_t) { return Disk::make_folder(path, readers); });
  }
  Result<void> remove(Path path) override {
    return at_write([&](std::size_t) { return Disk::remove(path); });
  }

 private:
  Result<void> at_write(const auto& write) {
    if (--left_ != 0) return write(1);
    if (moment_ != Moment::before) (void)write(moment_ == Moment::within ? 2 : 1);
    raise(SIGKILL);
    return {};
  }

  int left_;  // writes; at 0 the process is killed
  Moment moment_;
};

class Kills : public testing::Test, public PortalLeague {
 protected:
  Kills() {
    TokenList list;
    for (const char* team : {"alpha", "gamma"}) tokens_[team] = list.add(team, utc_text(now_), "");
    EXPECT_TRUE(write_tokens(disk_, folder_, list));
    EXPECT_TRUE(disk_.write(folder_.config(),
                            print_league_file(league_file_of(
                                {"alpha", "beta"}, {.kind = FormatKind::ladder}, "submitted"))));
    for (const char* team : {"alpha", "beta"}) keep_entry(disk_, folder_, team, "first");
    auto league = LeagueStore::open(disk_, folder_);
    EXPECT_TRUE(league && start_league(disk_, *league));
  }

  HandInTerms hand_in_terms(const std::string& team, const std::string&) override {
    return {.is_late = team == "gamma"};
  }
  std::map<std::string, int> booked_entries() override { return {{"beta", 0}}; }
  std::vector<std::string> neighbours_of(const std::string&) override { return {"beta"}; }

  std::unique_ptr<Portal> open(system::Files& disk) {
    PortalOptions options;
    options.now = [this] { return now_; };
    options.house = {"keeper", "striker"};
    auto portal = Portal::open(disk, folder_, *this, std::move(options), nullptr);
    if (!portal) ADD_FAILURE() << portal.error().what;
    return portal ? std::move(*portal) : nullptr;
  }

  // Does one of `acts`. Returns true if it is done, and the one who asked for it is told so.
  bool perform(const std::string& act, system::Files& disk, Portal& portal, int round) {
    std::istringstream words(act);
    std::string who, method, path, key, value;
    words >> who >> method >> path >> key >> value;
    if (who == "check") return check_all(portal);
    if (who == "play") return play_one(portal);
    if (who == "take") return take_late(disk);
    if (who == "host") return submit(disk, "good file " + std::to_string(round));
    if (key == "name") value += " " + std::to_string(round);
    web::Request request{.method = method, .path = "/api/v1/" + path, .address = "10.0.0.1"};
    request.headers.emplace("host", "league.example");
    request.headers.emplace("authorization", "Bearer " + tokens_.at(who));
    request.query.emplace(key, value);
    const auto reply = portal.answer(request, [&](const auto& take) { return take(value); });
    return reply && reply->status / 100 == 2;
  }

  // Checks what waits, as a process of its own would; a file is good if it says so.
  bool check_all(Portal& portal) {
    while (const auto next = portal.begin_next()) {
      const auto file = disk_.read(folder_.library(next->team, next->entry), {.max_size = 100});
      const Json verdict{{"accepted", file && file->starts_with("good")}};
      if (!disk_.write(folder_.verdict(next->team, next->entry), verdict.dump()) ||
          !portal.conclude(next->team, next->entry))
        return false;
    }
    return true;
  }

  bool play_one(Portal& portal) {
    const auto leg = portal.friendlies().begin_next();
    return leg && disk_.write(folder_.friendly(leg->team, leg->number), leg_) &&
           portal.friendlies().played(*leg);
  }

  // Hands in a file as `league submit` does, but for the program that checks it.
  bool submit(system::Files& disk, const std::string& bytes) {
    auto book = Book::open(disk, folder_);
    const auto entry = book->take({.team = "beta", .file = bytes}, [&](const std::string& path) {
      return disk.write(path, bytes, system::Readers::owner);
    });
    auto booking = Booking::begin(disk, folder_);
    return entry && booking && booking->conclude(*book, "beta", *entry, {{"accepted", true}}, now_);
  }

  // Takes the last entry of gamma, which came late, as `league take` does.
  bool take_late(system::Files& disk) {
    auto book = Book::open(disk, folder_);
    auto booking = Booking::begin(disk, folder_);
    const int last = book->hand_ins().last_kept("gamma");
    if (!book->hand_ins().find("gamma", last)->is_late) return true;  // done by one that was killed
    const auto why_not = booking->take_late(*book, "gamma", last, now_);
    return why_not && why_not->empty();
  }

  test_support::TemporaryFolder temporary_;
  system::Disk disk_;
  Folder folder_{temporary_ / "."};
  std::map<std::string, std::string> tokens_;
  std::int64_t now_ = 1'795'000'000;  // s since 1970
  const std::string leg_ =
      R"({"result":{"score":{"blue":3,"yellow":1},"end":"full_time","fault":null}})";
};

const char* const acts[] = {"alpha PUT entries name good",
                            "check",
                            "alpha PUT pin entry 1",
                            "play",
                            "alpha POST friendlies opponent beta",
                            "gamma PUT entries name good",
                            "check",
                            "take",
                            "alpha PUT pin entry latest",
                            "host",
                            "alpha PUT entries name bad",
                            "check",
                            "play"};

TEST_F(Kills, AtEachWriteLoseAndDoubleNothing) {
  int kills = 0;
  int round = 0;
  for (; kills < 200; ++round) {
    for (const char* const act : acts) {
      for (int status = 1, number = 0; status != 0; ++number) {
        now_ += 3600;  // no quota
        const pid_t server = fork();
        if (server == 0) {
          DeadlyDisk disk(1 + number / 3, static_cast<Moment>(number % 3));
          const auto portal = open(disk);
          _exit(portal && perform(act, disk, *portal, round) ? 0 : 1);
        }
        ASSERT_EQ(waitpid(server, &status, 0), server);
        ASSERT_TRUE(status == 0 || WIFSIGNALED(status)) << act << " after " << number << " kills";
        kills += status != 0;
      }
    }
  }
  {
    const auto portal = open(disk_);
    ASSERT_TRUE(portal && check_all(*portal));
    while (play_one(*portal)) {
    }
  }
  const auto book = Book::open(disk_, folder_);
  const auto league = LeagueStore::open(disk_, folder_);
  ASSERT_TRUE(test_support::is_ok(book) && test_support::is_ok(league));
  for (const std::string team : {"alpha", "beta", "gamma"}) {
    SCOPED_TRACE(team);
    std::map<std::string, int> files;
    for (const auto& [number, handed] : book->hand_ins().of_team(team)) {
      if (handed.is_network) ++files[handed.file];
      EXPECT_TRUE(is_final(handed.state) || !handed.is_network) << number;
      if (!is_final(handed.state)) continue;  // a command of the host that was killed
      EXPECT_EQ(handed.state != HandInState::accepted, handed.file.starts_with("bad")) << number;
      EXPECT_EQ(disk_.exists(folder_.entry_file(team, number)), handed.is_kept()) << number;
    }
    for (const auto& [file, count] : files) EXPECT_EQ(count, 1) << file;
    EXPECT_EQ(files.size(), (team == "alpha" ? 2u : team == "gamma" ? 1u : 0u) * round);
    EXPECT_EQ(league->state().teams[*league->state().find_team(team)].entry,
              book->hand_ins().playing(team));
    for (int number = 1; number <= book->friendlies().last_number(team); ++number)
      EXPECT_NE(book->friendlies().find(team, number)->state, FriendlyState::waiting) << number;
  }
  EXPECT_EQ(book->hand_ins().pinned("alpha"), 0);
}

}  // namespace
}  // namespace mirocup::league
