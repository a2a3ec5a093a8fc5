// SPDX-License-Identifier: MIT
#include "tournaments/play/progress_reporter.hpp"

#include "system/printable.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>
#include <unistd.h>

namespace mirocup::league {

namespace {

// The bar of a league of thousands of legs then fits into a terminal of 80 columns.
constexpr int bar_width = 24;

// At least one second, as long as legs are left.
std::string time_text(double seconds) {
  const long rounded = std::max(1L, std::lround(seconds));
  if (rounded < 90) return std::to_string(rounded) + " s";
  const long minutes = std::lround(seconds / 60.0);
  if (minutes < 90) return std::to_string(minutes) + " min";
  return std::to_string(minutes / 60) + " h " + std::to_string(minutes % 60) + " min";
}

// "[######......]  37 of 100 legs, 2 playing, 4 min left" with a bar of `width` characters. The
// remaining time follows from the `seconds` since `first` legs were decided.
std::string bar_text(int first, int decided, int legs, int playing, double seconds, int width) {
  const int full = legs > 0 ? width * decided / legs : width;
  std::string text = "[" + std::string(full, '#') + std::string(width - full, '.') + "]  " +
                     std::to_string(decided) + " of " + std::to_string(legs) + " legs, " +
                     std::to_string(playing) + " playing";
  if (decided > first && decided < legs) {
    text += ", " + time_text(seconds * (legs - decided) / (decided - first)) + " left";
  }
  return text;
}

class LineReporter final : public ProgressReporter {
 public:
  void say(const std::string& line) override { std::cerr << system::printable(line) << '\n'; }
  void update(int, int, int) override {}
};

class BarReporter final : public ProgressReporter {
 public:
  ~BarReporter() override { std::cerr << clear << std::flush; }

  void say(const std::string& line) override {
    std::cerr << clear << system::printable(line) << '\n' << text_ << std::flush;
  }

  void update(int decided, int legs, int playing) override {
    if (first_ < 0) first_ = decided;
    const std::chrono::duration<double> gone = std::chrono::steady_clock::now() - begin_;
    text_ = bar_text(first_, decided, legs, playing, gone.count(), bar_width);
    std::cerr << clear << text_ << std::flush;
  }

 private:
  static constexpr const char* clear = "\r\033[K";

  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  int first_ = -1;
  std::string text_;
};

}  // namespace

std::unique_ptr<ProgressReporter> make_progress_reporter() {
  if (isatty(STDERR_FILENO) != 0) return std::make_unique<BarReporter>();
  return std::make_unique<LineReporter>();
}

}  // namespace mirocup::league
