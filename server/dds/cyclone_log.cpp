// SPDX-License-Identifier: MIT
#include "server/dds/cyclone_log.hpp"

#include <dds/ddsrt/log.h>

#include <algorithm>
#include <string_view>

namespace mirocup::dds {

namespace {

constexpr std::size_t max_message_length = 300;
constexpr std::size_t max_messages = 4;

// Parts of the messages that strangers cause, each time with other numbers and names: hosts that
// send packets and, in secure mode, processes without credentials or with those of another league.
constexpr std::string_view malformed = "malformed packet";
constexpr std::string_view unreadable = " came that could not be read: its type is not that of ";
constexpr std::string_view by_strangers[] = {malformed, "not allowed",
                                             "certificate signature failure", unreadable};

// A part of the trace of Cyclone's discovery, and what it means. As a warning it has no end of line
// and is never passed on.
constexpr std::string_view without_credentials = "Non secure remote";
constexpr const char* meaning = "a process without credentials was seen, and is not allowed";

// How lines of the trace begin that tell of a participant and of one of its readers and writers. A
// GUID follows: numbers between colons, the last of which is not the participant's.
constexpr std::string_view of_participant = "SPDP ST0 ", of_endpoint = "SEDP ST0 ";
constexpr const char* one_sided = "a participant was seen, but no connection to it came about";

bool has(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

// Returns the part that identifies a stranger's kind of message, or the whole text. Of each kind
// one message is kept, because a second one tells nothing more.
std::string_view kind_of(std::string_view text) {
  for (const std::string_view part : by_strangers) {
    if (has(text, part)) return part;
  }
  return text;
}

// What "… deserialization TOPIC/TYPE failed …" means, without the numbers that differ each time.
std::string in_words(std::string text) {
  constexpr std::string_view before = "deserialization ", after = " failed (";
  const std::size_t begin = text.find(before), end = text.find(after);
  const std::size_t slash = text.find('/', begin);
  if (begin == std::string::npos || end == std::string::npos || slash > end) return text;
  const std::size_t topic = begin + before.size();
  return "a sample of " + text.substr(topic, slash - topic) + std::string(unreadable) +
         "mirocup.idl";
}

bool is_by_stranger(std::string_view text) {
  return kind_of(text) != text;
}

}  // namespace

CycloneLog::CycloneLog() {
  dds_set_log_sink(
      [](void* log, const dds_log_data_t* data) {
        if ((data->priority & (DDS_LC_WARNING | DDS_LC_ERROR | DDS_LC_FATAL)) == 0) return;
        static_cast<CycloneLog*>(log)->keep(
            {data->message, std::min(data->size, max_message_length)});
      },
      this);
  dds_set_trace_sink(
      [](void* log, const dds_log_data_t* data) {
        static_cast<CycloneLog*>(log)->follow({data->message, data->size});
      },
      this);
}

CycloneLog::~CycloneLog() {
  // The default sink is the standard error, where the user should not see messages of the shutdown.
  dds_set_log_sink([](void*, const dds_log_data_t*) {}, nullptr);
  dds_set_trace_sink([](void*, const dds_log_data_t*) {}, nullptr);
}

void CycloneLog::follow(std::string_view line) {
  if (has(line, without_credentials)) keep(meaning);
  const bool is_endpoint = has(line, of_endpoint);
  const std::size_t begin = line.find(is_endpoint ? of_endpoint : of_participant);
  if (begin == std::string_view::npos || !(is_endpoint || has(line, " NEW"))) return;
  const std::string_view guid = line.substr(begin + of_participant.size());
  const std::string participant(guid.substr(0, guid.rfind(':', guid.find(' '))));
  const std::lock_guard lock(mutex_);
  std::erase(unanswered_, participant);
  if (!is_endpoint && unanswered_.size() < max_messages) unanswered_.push_back(participant);
}

void CycloneLog::keep(std::string text) {
  while (!text.empty() && (text.back() == '\n' || text.back() == '\0')) text.pop_back();
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  text = in_words(std::move(text));
  const std::lock_guard lock(mutex_);
  std::erase_if(last_, [&](const std::string& kept) { return kind_of(kept) == kind_of(text); });
  if (last_.size() == max_messages) {
    const auto stranger = std::ranges::find_if(last_, is_by_stranger);
    last_.erase(stranger != last_.end() ? stranger : last_.begin());
  }
  last_.push_back(std::move(text));
}

std::string CycloneLog::last_error() const {
  const std::lock_guard lock(mutex_);
  std::string all;
  for (const std::string& text : last_) {
    if (has(text, malformed) && last_.size() > 1) continue;
    all += (all.empty() ? "" : "; ") + text;
  }
  return all.empty() && !unanswered_.empty() ? one_sided : all;
}

std::string CycloneLog::last_error_suffix() const {
  const std::string all = last_error();
  return all.empty() ? all : " (DDS: " + all + ")";
}

}  // namespace mirocup::dds
