// SPDX-License-Identifier: MIT
#include "plugins/host/team_log.hpp"

#include "system/printable.hpp"

#include <algorithm>

namespace mirocup::plugins {

namespace {

constexpr char tick_mark = '\x1e';  // stands on both sides of the number of a tick

// Returns the raw text with its marks as words, or without them.
std::string with_words(std::string_view raw, Ticks ticks) {
  std::string text;
  while (!raw.empty()) {
    const std::size_t begin = raw.find(tick_mark);
    text += raw.substr(0, begin);
    if (begin == std::string_view::npos) break;
    raw.remove_prefix(begin + 1);
    const std::size_t end = raw.find(tick_mark);
    if (end == std::string_view::npos) break;
    if (ticks == Ticks::shown) text += "tick " + std::string(raw.substr(0, end)) + ": ";
    raw.remove_prefix(end + 1);
  }
  return text;
}

}  // namespace

void TeamLog::append(std::string_view bytes) {
  std::string raw(bytes);
  std::replace(raw.begin(), raw.end(), tick_mark, '?');
  add(raw);
  if (!raw.empty()) is_in_a_line_ = raw.back() != '\n';
}

void TeamLog::append(std::string_view bytes, std::uint32_t tick) {
  while (!bytes.empty()) {
    if (!is_in_a_line_) add(tick_mark + std::to_string(tick) + tick_mark);
    const std::size_t line = std::min(bytes.find('\n'), bytes.size() - 1) + 1;
    append(bytes.substr(0, line));
    bytes.remove_prefix(line);
  }
}

void TeamLog::add(std::string_view bytes) {
  const std::size_t room = max_beginning - beginning_.size();
  const std::size_t first = std::min(room, bytes.size());
  beginning_ += bytes.substr(0, first);
  end_ += bytes.substr(first);
  if (end_.size() <= 2 * max_end) return;
  const std::size_t too_old = end_.size() - max_end;
  end_.erase(0, too_old);
  left_out_ += too_old;
}

std::string TeamLog::text(Ticks ticks) const {
  // What is left of a mark that was cut.
  std::string_view rest = end_;
  if (left_out_ > 0 || beginning_.ends_with(tick_mark)) {
    const std::size_t digits = rest.find_first_not_of("0123456789");
    if (digits < rest.size() && rest[digits] == tick_mark) rest.remove_prefix(digits + 1);
  }
  std::string beginning = system::printable(with_words(beginning_, ticks), system::LineEnds::kept);
  std::string end = system::printable(with_words(rest, ticks), system::LineEnds::kept);
  const std::size_t times = ticks == Ticks::shown ? 2 : 1;
  const std::size_t most = times * max_beginning;
  const std::size_t most_at_end = times * max_end;
  if (left_out_ == 0 && beginning.size() + end.size() <= most + most_at_end) return beginning + end;
  std::size_t left_out = left_out_;
  if (beginning.size() > most) {
    left_out += beginning.size() - most;
    beginning.resize(most);
  }
  if (end.size() > most_at_end) {
    left_out += end.size() - most_at_end;
    end.erase(0, end.size() - most_at_end);
  }
  beginning += "\n[about " + std::to_string(left_out);
  return beginning.append(left_out_here) + end;
}

}  // namespace mirocup::plugins
