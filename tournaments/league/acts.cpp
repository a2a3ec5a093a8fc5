// SPDX-License-Identifier: MIT
#include "tournaments/league/acts.hpp"

#include "system/digest.hpp"
#include "system/file_lock.hpp"
#include "system/number_of.hpp"
#include "system/printable.hpp"
#include "system/text.hpp"
#include "tournaments/league/apply.hpp"
#include "tournaments/league/decisions.hpp"
#include "tournaments/league/submission.hpp"

#include <algorithm>
#include <filesystem>

namespace mirocup::league {

namespace {

constexpr std::size_t max_reason = 500;  // bytes
constexpr std::size_t max_by = 60;       // bytes

using Lines = std::vector<std::string>;
constexpr const char* not_written = " (not written: a dry run)";

// Returns the legs that an act on a fixture is about.
Result<std::vector<int>> legs_of(const LeagueState& state, const Act& act) {
  const auto index = state.find_fixture(act.fixture);
  if (!index) return fail(Errc::input, "there is no fixture " + act.fixture);
  const int needed = state.fixtures[*index].needed();
  if (act.leg > 0) {
    if (act.has_all_legs) return fail(Errc::input, "one leg and all legs exclude each other");
    return std::vector<int>{act.leg};
  }
  if (!act.has_all_legs && needed > 1) {
    return fail(Errc::input, act.fixture + " has " + std::to_string(needed) +
                                 " legs: say which one (--leg N), or --all-legs");
  }
  std::vector<int> legs;
  for (int leg = 1; leg <= needed; ++leg) legs.push_back(leg);
  if (legs.empty()) return fail(Errc::input, act.fixture + " has no leg to be decided");
  return legs;
}

// Reads "2:1".
Result<HomeAway> score_of(const std::string& text) {
  HomeAway score;
  const std::size_t colon = text.find(':');
  const auto goals = [](const std::string& part) {
    return system::number_of<int>(system::replaced(part, " ", "")).value_or(-1);
  };
  if (colon != std::string::npos)
    score = {goals(text.substr(0, colon)), goals(text.substr(colon + 1))};
  if (colon == std::string::npos || std::min(score.home, score.away) < 0)
    return fail(Errc::input, text + " is no score: HOME:AWAY is expected, as in 2:1");
  if (std::max(score.home, score.away) > max_ruled_goals) {
    return fail(Errc::input, text + ": a ruling gives each team at most " +
                                 std::to_string(max_ruled_goals) + " goals in a leg");
  }
  return score;
}

// Returns the score by which a leg is given to a team.
Result<HomeAway> awarded_to(const LeagueState& state, const Act& act) {
  const auto index = state.find_fixture(act.fixture);
  if (!index) return fail(Errc::input, "there is no fixture " + act.fixture);
  const Fixture& fixture = state.fixtures[*index].fixture;
  const auto team = state.find_team(act.team);
  if (!team || (*team != fixture.home && *team != fixture.away))
    return fail(Errc::input, act.team + " does not play in " + act.fixture);
  const int goals = state.file.rules.forfeit_goals;
  return *team == fixture.home ? HomeAway{goals, 0} : HomeAway{0, goals};
}

// Keeps a reason that is not published in the league's file reasons.txt, which only the host can
// read, and returns the SHA-256 of the kept text. Random characters before the reason keep others
// from guessing it by its hash.
Result<std::string> keep_private_reason(system::Files& files, const Folder& folder,
                                        const std::string& reason) {
  const std::string path = folder.private_reasons();
  MIROCUP_TRY(const auto lock, system::FileLock::acquire(folder.lock()));
  MIROCUP_TRY(const auto known, files.read_if_there(path, {.max_size = system::size_limit::note}));
  const std::string kept = system::base32(system::random_bytes(16)) + " " + reason;
  const std::string sha256 = system::sha256(kept);
  MIROCUP_TRY_VOID(
      files.write(path, known.value_or("") + sha256 + " " + kept + "\n", system::Readers::owner));
  return sha256;
}

// While results are held back, only the host reads journal and records. Otherwise everybody may who
// may read league.json.
void show_results(const Folder& folder, bool is_shown) {
  namespace fs = std::filesystem;
  using enum fs::perms;
  std::error_code ignored;
  const fs::perms given = fs::status(folder.config(), ignored).permissions();
  const fs::perms readers = is_shown ? given & (group_read | others_read) : none;
  const auto enter = static_cast<fs::perms>(static_cast<unsigned>(readers) >> 2);
  fs::permissions(folder.journal(), owner_read | owner_write | readers, ignored);
  fs::permissions(folder.path + "/records", owner_all | readers | enter, ignored);
}

// One act, with the time at which it is done.
class Deciding {
 public:
  Deciding(system::Files& files, LeagueStore& store, const Act& act, std::int64_t now)
      : files_(files), store_(store), act_(act), now_(now) {}

  Result<Lines> perform() {
    switch (act_.kind) {
      case ActKind::rule:
        return score_of(act_.score).and_then([&](const HomeAway& s) { return rule(s); });
      case ActKind::award:
        return awarded_to(state(), act_).and_then([&](const HomeAway& s) { return rule(s); });
      case ActKind::void_:
        return annul();
      case ActKind::withdraw:
        return withdraw();
      case ActKind::pause:
        return write(signed_as(Paused{.team = act_.team}));
      case ActKind::resume:
        return write(signed_as(Resumed{.team = act_.team}));
      case ActKind::freeze:
        return freeze();
      case ActKind::release:
        return release();
      case ActKind::close:
        return write(signed_as(Closed{.closing_round = act_.final}));
      case ActKind::undo:
        return undo();
    }
    return Lines{};
  }

 private:
  const LeagueState& state() const { return store_.state(); }

  template <class Decided>
  Decided signed_as(Decided event) const {
    event.signature = {act_.reason, act_.by, utc_text(now_)};
    return event;
  }

  // Returns a line about the event, as the list of decisions has it.
  Result<Lines> write(const Event& event) {
    MIROCUP_TRY_VOID(validate(state(), event));
    std::string line = decision_in_words(state(), event);
    if (const std::string before = before_in_words(state(), event); !before.empty())
      line += " (" + before + ")";
    if (act_.is_dry_run) return Lines{line + not_written};
    MIROCUP_TRY_VOID(store_.write(event));
    return Lines{line};
  }

  Result<Lines> each_leg(const std::function<Event(int leg)>& decide) {
    MIROCUP_TRY(const auto legs, legs_of(state(), act_));
    // All or none: the first that cannot be decided stops it before a line is written.
    for (const int leg : legs) MIROCUP_TRY_VOID(validate(state(), decide(leg)));
    Lines lines;
    for (const int leg : legs) {
      MIROCUP_TRY(const Lines written, write(decide(leg)));
      lines.push_back(written[0]);
    }
    return lines;
  }

  Result<Lines> rule(const HomeAway& score) {
    return each_leg([&](int leg) {
      return signed_as(Ruled{.fixture = act_.fixture, .leg = leg, .score = score});
    });
  }

  Result<Lines> annul() {
    return each_leg([&](int leg) {
      const auto index = state().find_fixture(act_.fixture);
      const int attempt = leg <= max_legs ? state().fixtures[*index].legs[leg - 1].voids + 1 : 1;
      return signed_as(LegVoided{.fixture = act_.fixture,
                                 .leg = leg,
                                 .attempt = attempt,
                                 .cause = VoidCause::ruling,
                                 .has_new_seed = !act_.keeps_seed});
    });
  }

  Result<Lines> withdraw() {
    const auto results = from_string<WithdrawnResults>(act_.results);
    if (!results) return fail(Errc::input, "for the team's results, keep or annul is expected");
    if (!state().is_started && state().find_team(act_.team)) {
      return change_file(
          [this](LeagueFile& file) {
            std::erase_if(file.teams, [this](const auto& one) { return one.name == act_.team; });
          },
          act_.team + " is out of the league, which has not started yet");
    }
    return write(signed_as(Withdrawn{.team = act_.team, .results = *results}));
  }

  Result<Lines> extend() {
    if (!is_good_name(act_.except)) return fail(Errc::input, act_.except + " is no name of a team");
    if (state().is_started && !state().find_team(act_.except))
      return fail(Errc::input, "there is no team " + act_.except);
    if (act_.from.empty()) return fail(Errc::input, "say until when: --until TIME");
    MIROCUP_TRY(const auto until, time_to_come(""));
    Extended event = signed_as(Extended{.team = act_.except, .until = until, .reason_sha256 = {}});
    event.signature.why = "an extension; the reason is not published";
    if (!state().is_started)
      return change_file([&](LeagueFile& file) { file.extensions[act_.except] = until; },
                         decision_in_words(state(), event));
    MIROCUP_TRY_VOID(validate(state(), event));  // no reason is kept of what is refused
    if (!act_.is_dry_run) {
      // The name of the team, which nobody can change, and not the one that pages show.
      MIROCUP_TRY(event.reason_sha256, keep_reason(act_.except + " may hand in until " +
                                                   shown_time(state().file, until)));
    }
    return write(event);
  }

  // Returns the time that a person typed, unless it is past; `otherwise` ends the objection.
  Result<std::string> time_to_come(const std::string& otherwise) const {
    const std::string now = utc_text(now_);
    MIROCUP_TRY(const auto time, utc_of(act_.from, state().file));
    if (time >= now) return time;
    return fail(Errc::input, shown_time(state().file, time) + " is past, it is " +
                                 shown_time(state().file, now) + ": choose a later time" +
                                 otherwise);
  }

  // Keeps who has decided what, and why, where only the host reads it. Returns the hash.
  Result<std::string> keep_reason(const std::string& line) {
    return keep_private_reason(files_, store_.folder(),
                               utc_text(now_) + ", " + act_.by + ": " + line + ": " + act_.reason);
  }

  // Before the start the journal has no line yet. Others may have written the file meanwhile.
  Result<Lines> change_file(const std::function<void(LeagueFile&)>& change,
                            const std::string& line) {
    if (act_.is_dry_run) return Lines{line + not_written};
    MIROCUP_TRY(const auto lock, system::FileLock::acquire(store_.folder().submitting()));
    MIROCUP_TRY(const auto fresh, LeagueStore::open_unplanned(files_, store_.folder()));
    if (fresh.state().is_started)
      return fail(Errc::input, "the league has started meanwhile: decide once more");
    LeagueFile file = fresh.state().file;
    change(file);
    MIROCUP_TRY_VOID(files_.write(store_.folder().config(), print_league_file(file)));
    MIROCUP_TRY_VOID(keep_reason(line));
    return Lines{line + "; reasons.txt keeps who has decided it, and why"};
  }

  Result<Lines> freeze() {
    if (!act_.except.empty()) return extend();
    Frozen frozen;
    if (act_.from.empty() && !act_.is_lifted) frozen.from = utc_text(now_);
    if (!act_.from.empty() && !act_.is_lifted) {
      MIROCUP_TRY(frozen.from, time_to_come(", or none to take no entry from now on"));
    }
    if (state().is_started) return write(signed_as(frozen));
    return change_file([&](LeagueFile& file) { file.freeze = frozen.from; },
                       decision_in_words(state(), frozen));
  }

  Result<Lines> release() {
    const auto level = from_string<ReleaseLevel>(act_.level);
    if (!level) return fail(Errc::input, "all, teams or hidden is expected");
    const std::string& round = act_.through;
    const bool exists =
        round.empty() || std::ranges::any_of(state().fixtures, [&round](const FixtureState& f) {
          return f.fixture.round_key() == round;
        });
    if (!exists) return fail(Errc::input, "there is no round " + round);
    MIROCUP_TRY(auto lines, write(signed_as(Released{.level = *level, .through = round})));
    if (!act_.is_dry_run)
      show_results(store_.folder(), round.empty() && *level == ReleaseLevel::all);
    return lines;
  }

  Result<Lines> undo() {
    const auto& decisions = state().decisions;
    if (act_.decision < 1 || act_.decision > static_cast<int>(decisions.size())) {
      return fail(Errc::input, "there is no decision " + std::to_string(act_.decision) +
                                   "; league decisions lists them");
    }
    const int line = decisions[static_cast<std::size_t>(act_.decision) - 1].line;
    return write(signed_as(Undone{.line = line}));
  }

  system::Files& files_;
  LeagueStore& store_;
  const Act& act_;
  std::int64_t now_;
};

}  // namespace

std::string objection_to_reason(const std::string& text) {
  const bool has_word = std::ranges::any_of(text, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           static_cast<unsigned char>(c) >= 0x80;
  });
  if (!has_word) return "a reason is expected, in words: it is published";
  if (text.size() > max_reason)
    return "a reason has at most " + std::to_string(max_reason) + " bytes";
  if (system::printable(text) != text) return "a reason is one line of text in UTF-8";
  return "";
}

std::string objection_to_person(const std::string& name) {
  if (name.size() <= max_by && system::printable(name) == name) return "";
  return "the name of the person who decides is one line of text, of at most " +
         std::to_string(max_by) + " bytes";
}

Result<std::vector<std::string>> perform(system::Files& files, LeagueStore& store, const Act& act,
                                         std::int64_t now) {
  if (const std::string why = objection_to_reason(act.reason); !why.empty())
    return fail(Errc::input, why);
  if (const std::string why = objection_to_person(act.by); !why.empty())
    return fail(Errc::input, why);
  MIROCUP_TRY_VOID(store.refresh());
  return Deciding(files, store, act, now).perform();
}

}  // namespace mirocup::league
