// SPDX-License-Identifier: MIT
#include "server/dds/log.hpp"

#include <dds/ddsrt/log.h>

#include <algorithm>
#include <string_view>

namespace mirocup::dds {

namespace {

constexpr std::size_t longest = 300;

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
  if (text.starts_with(noise) && !last_.empty()) return;
  last_ = std::move(text);
}

std::string Log::last() const {
  const std::lock_guard lock(mutex_);
  return last_;
}

}  // namespace mirocup::dds
