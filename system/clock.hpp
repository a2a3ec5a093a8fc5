// SPDX-License-Identifier: MIT
//
// The wall clock, and times as texts in UTC and in a time zone.
#pragma once

#include "core/base/error.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace mirocup::system {

// Returns the time in seconds since 1970, plus the seconds in the environment variable
// MIROCUP_CLOCK_OFFSET, with which a term can be rehearsed in minutes.
std::int64_t now_s();

// Returns a time, in seconds since 1970, as "2026-11-30T18:00:00Z".
std::string utc_text(std::int64_t at);

// Reads a date and a time: "2026-11-30T18:00:00Z", or with an offset in place of the Z,
// "2026-11-30T19:00:00+01:00". Without Z and offset, `is_local` is true and `at` is computed as if
// the text were UTC. Returns nothing if the text has another form, or names no day of the calendar.
struct ParsedTime {
  std::int64_t at = 0;  // s since 1970
  bool is_local = false;
};
std::optional<ParsedTime> parse_time(std::string_view text);

// A time zone of the computer's database (tzdata). A copy is cheap.
class TimeZone {
 public:
  TimeZone() = default;  // UTC

  // Finds a zone by its name, "Europe/Berlin", with its changes of 150 years from 1970 on. Errors:
  // Errc::input if the computer has no zone of that name. The first call with a name changes the
  // environment for a moment, so call it before there are threads that read the environment.
  static Result<TimeZone> find(const std::string& name);

  // Returns the seconds by which local time is ahead of UTC at `time`, and the name of that offset:
  // "CET".
  struct Offset {
    int seconds = 0;
    std::string name = "UTC";
    bool operator==(const Offset&) const = default;
  };
  Offset at(std::int64_t time) const;

  // Returns "2026-11-30 19:00 CET".
  std::string text(std::int64_t time) const;
  std::string date(std::int64_t time) const;  // "2026-11-30"

  // Returns the time at which clocks in the zone show `shown`; if there are two such times, the
  // first. If clocks skip `shown` (see gap_at()), returns a time before they do.
  std::int64_t from_local(std::int64_t shown) const;

  // If no clock in the zone ever shows `shown`, because clocks are put forward past it, returns the
  // readings of a clock one second before that change and at the change.
  std::optional<std::pair<std::int64_t, std::int64_t>> gap_at(std::int64_t shown) const;

 private:
  struct Table;
  static std::shared_ptr<const Table> table_of(const std::string& path);
  std::shared_ptr<const Table> table_;  // null: UTC
};

// Returns a time of the journal as people of the zone read it: "2026-11-30 19:00 CET". A text that
// is not a time stays unchanged.
std::string in_zone(const TimeZone& zone, const std::string& utc);

}  // namespace mirocup::system
