// SPDX-License-Identifier: MIT
#include "server/dds/log.hpp"

#include <dds/ddsrt/log.h>

#include <algorithm>
#include <string_view>

namespace mirocup::dds {

namespace {

constexpr std::size_t longest = 300;
constexpr std::size_t most = 4;

// Anybody who can send packets can make it say this: it must not hide what was said before.
constexpr std::string_view noise = "malformed packet";

}  // namespace

Log::Log() {
  dds_set_log_sink(
      [](void* log, const dds_log_data_t* data) {
        if ((data->priority & (DDS_LC_WARNING | DDS_LC_ERROR | DDS_LC_FATAL)) == 0) return;
        static_cast<Log*>(log)->keep({data->message, std::min(data->size, longest)});
      },
      this);
}

Log::~Log() {
  // Not the standard error, which is the default: its last words are for nobody.
  dds_set_log_sink([](void*, const dds_log_data_t*) {}, nullptr);
}

void Log::keep(std::string text) {
  while (!text.empty() && (text.back() == '\n' || text.back() == '\0')) text.pop_back();
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  const std::lock_guard lock(mutex_);
  const bool is_noise = text.starts_with(noise);
  if (is_noise && !last_.empty()) return;
  std::erase_if(last_, [&](const std::string& kept) {
    return kept == text || (!is_noise && kept.starts_with(noise));
  });
  if (last_.size() == most) last_.erase(last_.begin());
  last_.push_back(std::move(text));
}

std::string Log::said() const {
  const std::lock_guard lock(mutex_);
  std::string all;
  for (const std::string& text : last_) all += (all.empty() ? "" : "; ") + text;
  return all;
}

}  // namespace mirocup::dds
