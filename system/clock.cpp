// SPDX-License-Identifier: MIT
#include "system/clock.hpp"

#include "system/files.hpp"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <filesystem>
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

// Reads the digits of `text` at `begin`; -1 if there are none of that count.
int digits(std::string_view text, std::size_t begin, std::size_t count) {
  if (begin + count > text.size()) return -1;
  int value = 0;
  for (const char c : text.substr(begin, count)) {
    if (c < '0' || c > '9') return -1;
    value = 10 * value + (c - '0');
  }
  return value;
}

// A number of that many bytes, the highest first, as the files of the database have them.
std::int64_t big_endian(std::string_view bytes, std::size_t at, std::size_t size) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < size; ++i)
    value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
  return size == 4 ? static_cast<std::int32_t>(static_cast<std::uint32_t>(value))
                   : static_cast<std::int64_t>(value);
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
  const int year = digits(text, 0, 4);
  const int month = digits(text, 5, 2);
  const int day = digits(text, 8, 2);
  const int hour = digits(text, 11, 2);
  const int minute = digits(text, 14, 2);
  const int second = digits(text, 17, 2);
  if (text.size() < length || text[4] != '-' || text[7] != '-' || text[10] != 'T' ||
      text[13] != ':' || text[16] != ':' || year < 1970 || month < 1 || month > 12 || day < 1 ||
      hour < 0 || hour > 23 || minute < 0 || minute > 59 || second < 0 || second > 59)
    return std::nullopt;
  const std::chrono::year_month_day date{std::chrono::year(year),
                                         std::chrono::month(static_cast<unsigned>(month)),
                                         std::chrono::day(static_cast<unsigned>(day))};
  if (!date.ok()) return std::nullopt;
  const std::int64_t days = std::chrono::sys_days(date).time_since_epoch().count();
  ParsedTime time{.at = days * day_s + hour * 3600 + minute * 60 + second, .is_local = false};
  const std::string_view rest = text.substr(length);
  if (rest == "Z") return time;
  if (rest.empty()) {
    time.is_local = true;
    return time;
  }
  const int hours = digits(rest, 1, 2);
  const int minutes = digits(rest, 4, 2);
  if (rest.size() != 6 || (rest[0] != '+' && rest[0] != '-') || rest[3] != ':' || hours < 0 ||
      hours > 14 || minutes < 0 || minutes > 59)
    return std::nullopt;
  time.at -= (rest[0] == '+' ? 1 : -1) * (hours * 3600 + minutes * 60);
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

// The files are described in RFC 8536. Debian's have all changes until 2037; later ones, which the
// last line of a file gives as a rule, are not read.
Result<TimeZone> TimeZone::find(const std::string& name) {
  const auto unknown = [&name] {
    return fail(Errc::input, "this computer knows no time zone \"" + name +
                                 "\": a name like \"Europe/Berlin\" is expected");
  };
  TimeZone zone;
  if (name == "UTC") return zone;
  const bool is_safe = !name.empty() && name.size() <= 60 && name[0] != '/' &&
                       std::all_of(name.begin(), name.end(), [](char c) {
                         return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                                (c >= '0' && c <= '9') || c == '/' || c == '_' || c == '-' ||
                                c == '+';
                       });
  if (!is_safe) return unknown();
  if (std::error_code none; !std::filesystem::exists(zone_folder, none)) {
    return fail(Errc::unavailable, "the time zone \"" + name +
                                       "\" is not known: " + std::string(zone_folder) +
                                       " is missing; Debian's package is tzdata");
  }
  Disk disk;
  const auto text = disk.read_named(zone_folder + name, size_limit::certificate);
  if (!text) return unknown();
  constexpr std::size_t header = 44;
  const auto count = [&text](std::size_t at, int number) {
    return static_cast<std::size_t>(
        std::clamp<std::int64_t>(big_endian(*text, at + 20 + 4 * std::size_t(number), 4), 0, 5000));
  };
  if (text->size() < header || text->substr(0, 4) != "TZif" || (*text)[4] < '2') return unknown();
  // The second part has times of 64 bits. Counts: of UTC flags, standard flags, leap seconds,
  // changes, kinds, letters.
  const std::size_t second = header + count(0, 3) * 5 + count(0, 4) * 6 + count(0, 5) +
                             count(0, 2) * 8 + count(0, 1) + count(0, 0);
  if (text->size() < second + header || text->substr(second, 4) != "TZif") return unknown();
  const std::size_t changes = count(second, 3);
  const std::size_t kinds = count(second, 4);
  const std::size_t letters = count(second, 5);
  const std::size_t times = second + header;
  const std::size_t kind_of = times + 8 * changes;
  const std::size_t kind_at = kind_of + changes;
  const std::size_t letters_at = kind_at + 6 * kinds;
  if (kinds == 0 || text->size() < letters_at + letters) return unknown();
  const auto offset = [&](std::size_t kind) {
    const std::size_t at = kind_at + 6 * std::min(kind, kinds - 1);
    const std::size_t begin = std::min<std::size_t>(static_cast<unsigned char>((*text)[at + 5]),
                                                    letters > 0 ? letters - 1 : 0);
    const std::string_view names(text->data() + letters_at, letters);
    const std::string_view rest = names.substr(begin);
    return Offset{.seconds = static_cast<int>(big_endian(*text, at, 4)),
                  .name = std::string(rest.substr(0, rest.find('\0')))};
  };
  auto table = std::make_shared<Table>();
  table->before = offset(0);
  for (std::size_t i = 0; i < changes; ++i) {
    table->changes.push_back({big_endian(*text, times + 8 * i, 8),
                              offset(static_cast<unsigned char>((*text)[kind_of + i]))});
  }
  zone.table_ = std::move(table);
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
