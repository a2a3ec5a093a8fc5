// SPDX-License-Identifier: MIT
#include "plugins/host/team_log.hpp"

#include "system/printable.hpp"

#include <algorithm>

namespace mirocup::plugins {

void TeamLog::append(std::string_view bytes) {
  const std::size_t room = max_beginning - beginning_.size();
  const std::size_t first = std::min(room, bytes.size());
  beginning_ += bytes.substr(0, first);
  end_ += bytes.substr(first);
  if (end_.size() <= 2 * max_end) return;
  const std::size_t too_old = end_.size() - max_end;
  end_.erase(0, too_old);
  left_out_ += too_old;
}

std::string TeamLog::text() const {
  std::string beginning = system::printable(beginning_, system::LineEnds::kept);
  std::string end = system::printable(end_, system::LineEnds::kept);
  if (left_out_ == 0 && beginning.size() + end.size() <= max_beginning + max_end) {
    return beginning + end;
  }
  std::size_t left_out = left_out_;
  if (beginning.size() > max_beginning) {
    left_out += beginning.size() - max_beginning;
    beginning.resize(max_beginning);
  }
  if (end.size() > max_end) {
    left_out += end.size() - max_end;
    end.erase(0, end.size() - max_end);
  }
  return beginning + "\n[about " + std::to_string(left_out) + " bytes are left out here]\n" + end;
}

}  // namespace mirocup::plugins
