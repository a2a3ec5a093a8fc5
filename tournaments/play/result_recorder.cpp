// SPDX-License-Identifier: MIT
#include "tournaments/play/result_recorder.hpp"

#include "core/match/controller.hpp"
#include "system/text.hpp"
#include "tournaments/play/leg_record.hpp"
#include "tournaments/play/program.hpp"

namespace mirocup::league {

namespace {

// A busy host can cause such a fault, so a loss by it counts only when it is confirmed.
bool is_by_a_clock(const LegFault& fault) {
  const auto code = from_string<match::FaultCode>(fault.code);
  return code == match::FaultCode::budget || code == match::FaultCode::hang ||
         code == match::FaultCode::start_timeout;
}

std::string record_of(const LegId& leg) {
  return Folder::record_name(leg.fixture, leg.leg, leg.version);
}

std::string name_of(const LegId& leg) {
  return leg.fixture.id() + " leg " + std::to_string(leg.leg);
}

}  // namespace

ResultRecorder::ResultRecorder(system::Files& files, LeagueStore store, ProgressReporter& progress)
    : files_(files), store_(std::move(store)), progress_(progress) {}

Result<void> ResultRecorder::start(int jobs) {
  jobs_ = jobs;
  return start_league(files_, store_);
}

const FixtureState* ResultRecorder::find(const std::string& id) const {
  const auto index = state().find_fixture(id);
  return index ? &state().fixtures[*index] : nullptr;
}

std::optional<LegId> ResultRecorder::next_leg(const FixtureState& fixture) const {
  for (const int leg : open_legs(state(), fixture)) {
    const LegState& now = fixture.legs[leg - 1];
    const LegId id{fixture.fixture, leg, now.version, now.voids + 1};
    const auto failures = host_failures_.find(name_of(id));
    if (failures == host_failures_.end() || failures->second < max_attempts) return id;
  }
  return std::nullopt;
}

Result<bool> ResultRecorder::book_own(const LegId& leg) {
  MIROCUP_TRY(const auto played, find_played_leg(files_, folder(), state(), leg));
  if (!played) return false;
  MIROCUP_TRY_VOID(book_result(leg, *played));
  return true;
}

Result<bool> ResultRecorder::book_found(const LegId& leg) {
  MIROCUP_TRY(const auto played, find_played_leg(files_, folder(), state(), leg));
  if (!played) return false;
  if (!checked_.contains(record_of(leg))) MIROCUP_TRY_VOID(check_found());
  const std::string why = checked_[record_of(leg)];
  checked_.erase(record_of(leg));
  if (why.empty()) return book_own(leg);
  ++refused_;
  ++host_failures_[name_of(leg)];
  MIROCUP_TRY_VOID(
      write_void(leg, VoidCause::host, why + "; played again with another seed", true));
  return true;
}

// Verifies the records of all legs that wait to be booked.
Result<void> ResultRecorder::check_found() {
  std::vector<std::string> records;
  for (const FixtureState& f : state().fixtures) {
    for (const int leg : open_legs(state(), f)) {
      const LegId id{f.fixture, leg, f.legs[leg - 1].version};
      const std::string record = record_of(id);
      if (checked_.contains(record)) continue;
      MIROCUP_TRY(const auto found, find_played_leg(files_, folder(), state(), id));
      if (!found) continue;
      MIROCUP_TRY(const auto key, impossible_key(files_, folder(), state(), id));
      if (key.empty()) records.push_back(record);
      checked_[record] = key.empty() ? "" : record + ": /" + key + " cannot be that of this leg";
    }
  }
  MIROCUP_TRY(const auto verified, verify_records(files_, folder(), records, jobs_));
  for (const VerifiedRecords::Problem& p : verified.problems) {
    checked_[p.record] = p.record + ": " + p.text;
    if (p.code == exit_no) continue;
    return fail(p.code == exit_code(Errc::damaged) ? Errc::damaged : Errc::host,
                p.text + "; the leg may have been played: mend " + p.record +
                    ", or remove it to play again");
  }
  return {};
}

Result<int> ResultRecorder::book_played(const std::string& fixture) {
  for (int count = 0;; ++count) {
    const FixtureState* now = find(fixture);
    const auto leg = now != nullptr ? next_leg(*now) : std::nullopt;
    if (!leg) return count;
    MIROCUP_TRY(const auto booked, book_found(*leg));
    if (!booked) return count;
  }
}

std::string ResultRecorder::last_output_line(const LegId& leg) const {
  return system::last_line(
      files_
          .read(leg_output(folder(), leg),
                {.max_size = system::size_limit::log, .growth = system::Growth::ignored})
          .value_or(""));
}

Result<void> ResultRecorder::book_void(const LegId& leg, const std::string& why) {
  ++host_failures_[name_of(leg)];
  return write_void(leg, VoidCause::host, why);
}

// Drops an event that no longer fits because a person decided otherwise in the meantime.
Result<void> ResultRecorder::drop_if_outdated(Result<void> result) {
  if (result || result.error().code != Errc::input) return result;
  progress_.say("not counted: " + result.error().what);
  return {};
}

Result<void> ResultRecorder::book_result(const LegId& leg, const LegPlayed& played) {
  const FixtureState* fixture = find(played.fixture);
  const bool is_confirmed = fixture != nullptr && fixture->legs[leg.leg - 1].awaits_confirmation;
  if (played.fault && is_by_a_clock(*played.fault) && !is_confirmed) {
    return write_void(leg, VoidCause::confirm,
                      played.fault->summary() + "; played again to confirm it");
  }
  MIROCUP_TRY_VOID(drop_if_outdated(store_.write(played)));
  std::string end(to_string(played.end));
  if (played.fault) end += ": " + played.fault->team + ": " + played.fault->code;
  progress_.say(std::to_string(state().played()) + "/" + std::to_string(state().legs()) + "  " +
                played.home + " " + std::to_string(played.score.home) + " : " +
                std::to_string(played.score.away) + " " + played.away + "  (" + end + ")");
  return pause_after_strikes(leg.fixture);
}

Result<void> ResultRecorder::write_void(const LegId& leg, VoidCause cause, const std::string& why,
                                        bool has_new_seed) {
  progress_.say(name_of(leg) + ": void: " + why);
  return drop_if_outdated(store_.write(LegVoided{.fixture = leg.fixture.id(),
                                                 .leg = leg.leg,
                                                 .attempt = leg.attempt,
                                                 .cause = cause,
                                                 .signature = {why},
                                                 .has_new_seed = has_new_seed}));
}

Result<void> ResultRecorder::pause_after_strikes(const Fixture& fixture) {
  const int max = state().file.strikes;
  for (const int team : {fixture.home, fixture.away}) {
    const TeamState& now = state().teams[team];
    if (max == 0 || now.strikes < max || now.status != TeamStatus::playing) continue;
    const std::string why = std::to_string(now.strikes) + " legs in a row lost by its own faults";
    const std::string name = state().name(team);
    MIROCUP_TRY_VOID(drop_if_outdated(
        store_.write(Paused{.team = name, .signature = {why}, .is_by_program = true})));
    progress_.say(name + " is paused: " + why +
                  "; to end the pause: mirocup league resume or withdraw " + folder().path + " " +
                  name);
  }
  return {};
}

Error interrupted_after(const LeagueState& state) {
  return {Errc::interrupted, "interrupted after " + std::to_string(state.played()) + " of " +
                                 std::to_string(state.legs()) +
                                 " legs; the same command continues from here"};
}

}  // namespace mirocup::league
