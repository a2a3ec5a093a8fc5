// SPDX-License-Identifier: MIT
//
// identify_bars [PITCHES] [SECONDS] [FIRST]: identifies random pitches from recordings of 60 s,
// with a noise of 2 mm and 1 degree, 60 pictures a second, 2 % gaps and 1 % outliers. Prints for
// each number how often its interval of 95 % holds the truth, its mean half-width, and the mean and
// the root mean square of the errors in standard deviations, which should be 0 and 1.
#include "labs/pitch/identify.hpp"
#include "labs/tests/support/driven_pitch.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>

namespace {

using namespace mirocup;

struct Row {
  int known = 0;
  int held = 0;
  double half = 0.0;    // of the interval: a share for ratios
  double error = 0.0;   // sum, in standard deviations
  double square = 0.0;  // sum of their squares
};

double truth_of(const pitch::Guess& truth, int unknown) {
  pitch::Guess plain = truth;
  plain.parameters.turn_time_constant = truth.parameters.turn_lag();
  plain.parameters.brake_time_constant = truth.parameters.brake_lag();
  const double value = value_of(plain, unknown);
  return pitch::unknowns()[unknown].is_ratio ? std::exp(value) : value;
}

void count(const pitch::Estimate& e, double truth, bool is_ratio, Row& row) {
  ++row.known;
  row.held += e.low <= truth && truth <= e.high ? 1 : 0;
  row.half += (e.high - e.low) / 2.0 / (is_ratio ? truth : 1.0);
  const double half = truth > e.value ? e.high - e.value : e.value - e.low;
  const double error = 1.96 * (e.value - truth) / std::max(1e-12, half);
  row.error += error;
  row.square += error * error;
}

void print(const char* name, const Row& row) {
  if (row.known == 0) return;
  std::printf("%-28s %4d known   %5.1f %% hold   half-width %-9.4g error %5.2f, rms %.2f\n", name,
              row.known, 100.0 * row.held / row.known, row.half / row.known, row.error / row.known,
              std::sqrt(row.square / row.known));
}

}  // namespace

int main(int argc, char** argv) {
  const int pitches = argc > 1 ? std::atoi(argv[1]) : 20;
  const double seconds = argc > 2 ? std::atof(argv[2]) : 60.0;
  const int first = argc > 3 ? std::atoi(argv[3]) : 1;
  std::array<Row, pitch::unknown_count> rows{};
  Row deceleration;
  for (int i = first; i < first + pitches; ++i) {
    test_support::DrivenPitch driven;
    driven.truth = test_support::random_pitch(static_cast<std::uint64_t>(i));
    driven.seconds = seconds;
    driven.seed = static_cast<std::uint64_t>(i);
    const auto recording = test_support::recording_of(driven);
    const std::clock_t begin = std::clock();
    const auto found = pitch::identify({recording}, {});
    if (!found) return EXIT_FAILURE;
    const double took = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    std::printf("pitch %d: %.1f s, %d windows, %d left out, noise %.2f mm;", i, took,
                found->windows, found->unexplained, 1e3 * found->position_noise.value);
    for (int u = 0; u < pitch::unknown_count; ++u) {
      if (!found->known[u]) continue;
      const double truth = truth_of(driven.truth, u);
      const pitch::Estimate& e = *found->known[u];
      count(e, truth, pitch::unknowns()[u].is_ratio, rows[u]);
      if (truth < e.low || truth > e.high) {
        std::printf(" %s %.4g not in %.4g to %.4g;", std::string(pitch::unknowns()[u].name).c_str(),
                    truth, e.low, e.high);
      }
    }
    std::printf("\n");
    const simulator::Parameters& p = driven.truth.parameters;
    const double truth = p.rolling_resistance * simulator::gravity / 1.4 +
                         0.5 * p.viscous_friction / (1.4 * p.ball_mass);
    if (found->has_deceleration) count(found->deceleration, truth, true, deceleration);
    std::fflush(stdout);
  }
  Row all;
  for (int u = 0; u < pitch::unknown_count; ++u) {
    print(std::string(pitch::unknowns()[u].name).c_str(), rows[u]);
    all.known += rows[u].known;
    all.held += rows[u].held;
  }
  print("ball's deceleration", deceleration);
  std::printf("pooled: %.1f %% of %d intervals hold\n", 100.0 * all.held / std::max(1, all.known),
              all.known);
  return EXIT_SUCCESS;
}
