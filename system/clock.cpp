// SPDX-License-Identifier: MIT
#include "system/clock.hpp"

#include "system/files.hpp"
#include "system/text.hpp"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <map>
#include <mutex>
#include <vector>

namespace mirocup::system {

namespace {

constexpr std::int64_t day_s = 86'400;
constexpr const char* zone_folder = "/usr/share/zoneinfo/";

std::string formatted(std::int64_t at, const char* format) {
  const std::time_t time = at;
  std::tm parts{};
  gmtime_r(&time, &parts);
  char text[40];
  return std::string(text, std::strftime(text, sizeof text, format, &parts));
}

}  // namespace

std::int64_t now_s() {
  std::int64_t offset = 0;
  if (const char* text = std::getenv("MIROCUP_CLOCK_OFFSET"))
    std::from_chars(text, text + std::strlen(text), offset);
  return static_cast<std::int64_t>(std::time(nullptr)) + offset;
}

std::string utc_text(std::int64_t at) {
  return formatted(at, "%Y-%m-%dT%H:%M:%SZ");
}

std::optional<ParsedTime> parse_time(std::string_view text) {
  constexpr std::size_t length = 19;  // without an offset
  const std::string date(text.substr(0, length));
  std::tm parts{};
  strptime(date.c_str(), "%Y-%m-%dT%H:%M:%S", &parts);
  ParsedTime time{.at = timegm(&parts), .is_local = text.size() == length};
  // The C library also reads other forms, and the 31st of a month of 30 days.
  if (time.at < 0 || utc_text(time.at) != date + "Z") return std::nullopt;
  const std::string_view rest = text.substr(length);
  if (time.is_local || rest == "Z") return time;
  if (rest.size() != 6 || (rest[0] != '+' && rest[0] != '-')) return std::nullopt;
  const auto offset = parse_time("1970-01-01T" + std::string(rest.substr(1)) + ":00Z");
  if (!offset || offset->at >= 15 * 3600) return std::nullopt;
  time.at -= rest[0] == '+' ? offset->at : -offset->at;
  return time;
}

struct TimeZone::Table {
  struct Change {
    std::int64_t from;  // s since 1970
    Offset to;
  };
  Offset before;  // the first change
  std::vector<Change> changes;
};

// The C library reads the files of the database, and knows one zone at a time: that of the
// environment variable TZ.
std::shared_ptr<const TimeZone::Table> TimeZone::table_of(const std::string& path) {
  constexpr std::int64_t step_s = 7 * day_s;  // no zone changes twice in a week
  constexpr std::int64_t last = 150 * 366 * day_s;
  const auto offset_at = [](std::time_t time) {
    std::tm parts{};
    localtime_r(&time, &parts);
    return Offset{.seconds = static_cast<int>(parts.tm_gmtoff), .name = parts.tm_zone};
  };
  const char* own = std::getenv("TZ");
  const std::optional<std::string> former = own ? std::optional<std::string>(own) : std::nullopt;
  setenv("TZ", (":" + path).c_str(), 1);
  tzset();
  auto table = std::make_shared<Table>();
  Offset offset = table->before = offset_at(0);
  for (std::int64_t end = step_s; end < last; end += step_s) {
    const Offset next = offset_at(end);
    if (next == offset) continue;
    std::int64_t before = end - step_s, from = end;
    while (from - before > 1) {
      const std::int64_t middle = before + (from - before) / 2;
      (offset_at(middle) == offset ? before : from) = middle;
    }
    table->changes.push_back({from, next});
    offset = next;
  }
  former ? setenv("TZ", former->c_str(), 1) : unsetenv("TZ");
  tzset();
  return table;
}

Result<TimeZone> TimeZone::find(const std::string& name) {
  const auto unknown = [&name] {
    return fail(Errc::input, "this computer knows no time zone \"" + name +
                                 "\": a name like \"Europe/Berlin\" is expected");
  };
  TimeZone zone;
  if (name == "UTC") return zone;
  const bool is_safe = !name.empty() && name.size() <= 60 && name[0] != '/' &&
                       std::all_of(name.begin(), name.end(), [](char c) {
                         return (is_plain(c) && c != '.') || c == '/' || c == '+';
                       });
  if (!is_safe) return unknown();
  if (std::error_code none; !std::filesystem::exists(zone_folder, none)) {
    return fail(Errc::unavailable, "the time zone \"" + name +
                                       "\" is not known: " + std::string(zone_folder) +
                                       " is missing; Debian's package is tzdata");
  }
  const std::string path = zone_folder + name;
  const auto text = Disk().read_named(path, size_limit::certificate);
  if (!text || !text->starts_with("TZif")) return unknown();
  static std::mutex mutex;
  static std::map<std::string, std::shared_ptr<const Table>> known;
  const std::lock_guard lock(mutex);
  std::shared_ptr<const Table>& table = known[path];
  if (!table) table = table_of(path);
  zone.table_ = table;
  return zone;
}

TimeZone::Offset TimeZone::at(std::int64_t time) const {
  if (!table_) return {};
  const auto next =
      std::upper_bound(table_->changes.begin(), table_->changes.end(), time,
                       [](std::int64_t t, const Table::Change& c) { return t < c.from; });
  return next == table_->changes.begin() ? table_->before : (next - 1)->to;
}

std::string TimeZone::text(std::int64_t time) const {
  const Offset offset = at(time);
  return formatted(time + offset.seconds, "%Y-%m-%d %H:%M ") + offset.name;
}

std::string TimeZone::date(std::int64_t time) const {
  return formatted(time + at(time).seconds, "%Y-%m-%d");
}

std::int64_t TimeZone::from_local(std::int64_t shown) const {
  // The offset a day before and a day after: one of the two holds, and both where nothing changes.
  const std::int64_t first = shown - at(shown - day_s).seconds;
  if (first + at(first).seconds == shown) return first;
  return shown - at(shown + day_s).seconds;
}

std::optional<std::pair<std::int64_t, std::int64_t>> TimeZone::gap_at(std::int64_t shown) const {
  std::int64_t before = from_local(shown);
  if (before + at(before).seconds == shown) return std::nullopt;
  std::int64_t after = shown - at(shown - day_s).seconds;
  while (after - before > 1) {
    const std::int64_t middle = before + (after - before) / 2;
    (at(middle).seconds == at(after).seconds ? after : before) = middle;
  }
  return std::pair(before + at(before).seconds, after + at(after).seconds);
}

std::string in_zone(const TimeZone& zone, const std::string& utc) {
  const auto time = parse_time(utc);
  return time ? zone.text(time->at) : utc;
}

}  // namespace mirocup::system
