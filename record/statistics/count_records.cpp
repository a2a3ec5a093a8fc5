// SPDX-License-Identifier: MIT
//
// In a file of its own, because the module for browsers has no threads.
#include "record/statistics/leg_report.hpp"

#include <algorithm>
#include <atomic>
#include <thread>
#include <utility>

namespace mirocup::statistics {

Result<std::vector<LegReport>> count_records(system::Files& files,
                                             const std::vector<std::string>& paths) {
  std::vector<std::optional<Result<LegReport>>> counted(paths.size());
  std::atomic<std::size_t> next = 0;
  std::atomic<bool> has_failed = false;
  const auto work = [&] {
    for (std::size_t i = next++; i < paths.size() && !has_failed; i = next++) {
      counted[i] = count_record(files, paths[i]);
      if (!*counted[i]) has_failed = true;
    }
  };
  const std::size_t workers =
      std::min<std::size_t>(paths.size(), std::max(1u, std::thread::hardware_concurrency()));
  {
    std::vector<std::jthread> threads;
    for (std::size_t i = 1; i < workers; ++i) threads.emplace_back(work);
    work();
  }
  std::vector<LegReport> reports;
  for (auto& result : counted) {
    if (!result) break;  // not reached, since another one failed
    if (!*result) return tl::unexpected(result->error());
    reports.push_back(*std::move(*result));
  }
  return reports;
}

}  // namespace mirocup::statistics
