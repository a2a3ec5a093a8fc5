// SPDX-License-Identifier: MIT
#include "labs/pitch/validate.hpp"

#include "core/simulator/trajectory/segment.hpp"
#include "system/text.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace mirocup::pitch {

namespace {

using simulator::BodyState;

constexpr int pictures_before = 8;   // from which a start is estimated
constexpr int pictures_between = 5;  // two starts
constexpr int longest = horizons.back();
constexpr double fits_noise = 1.6;     // times the noise: pictures lie on the curve of a start
constexpr double slides_fast = 0.3;    // m/s sideways at a start; slower is noise
constexpr double slides_shown = 1e-4;  // m/s sideways in a prediction
constexpr int least_count = 20;        // errors from which a cell says anything
constexpr double worse_by = 1.02;      // a smaller difference is none
constexpr double least_worse = 1e-4;   // m

// The errors of one cell before they are summed up: squares, m^2, without the mean of the noise.
struct Sums {
  std::array<std::vector<double>, predictors> squares;
  std::vector<double> noise;
};
using SumTable = std::array<std::array<Sums, horizons.size()>, 7>;

Guess paper_guess(const Guess& pitch) {
  Guess paper = pitch;
  simulator::Parameters& p = paper.parameters;
  p.grip = simulator::infinite_grip;
  p.turn_time_constant = 0.0;
  p.brake_time_constant = 0.0;
  p.rolling_friction = simulator::RollingFriction::per_axis;
  p.contact_friction = {};
  return paper;
}

// All predictions from one picture on.
struct Prediction {
  Window window;
  std::vector<BodyState> start;
  std::vector<Footage::FittedState> fitted;  // the same with what is known of it
  // [predictor][place in window.bodies][picture ahead - 1]
  std::array<std::vector<std::vector<Vec2>>, predictors> at;
  std::vector<std::vector<char>> slides;  // [place][picture ahead - 1]
  simulator::RunStatistics statistics;
};

// Returns how much the noise adds to the square of an error at `ahead` s, m^2: that of the picture
// there, and that of the start.
double noise_square(const Footage::FittedState& start, double sigma, double ahead) {
  const double of_start =
      start.position + 2.0 * ahead * start.both + ahead * ahead * start.velocity;
  return 2.0 * sigma * sigma * (1.0 + of_start);
}

// Returns the start from the longest curve on which the pictures lie: a line, else a parabola. One
// whose misfit is too large says that the body has just hit something: it is not judged.
std::optional<Footage::FittedState> start_of(const Footage& footage, int body, int frame,
                                             double sigma) {
  constexpr std::array<std::pair<int, int>, 5> choices{
      std::pair{8, 1}, std::pair{6, 1}, std::pair{8, 2}, std::pair{6, 2}, std::pair{4, 1}};
  std::optional<Footage::FittedState> last;
  for (const auto& [count, degree] : choices) {
    if (auto fitted = footage.state_at(body, frame, -count, degree)) {
      double& left = fitted->state.twist.left;
      if (body != footage.ball() && std::abs(left) < slides_fast) left = 0.0;
      last = fitted;
      if (fitted->misfit < fits_noise * sigma) return fitted;
    }
  }
  return last;
}

EventKind kind_of_event(const Prediction& p, const Footage& footage, std::size_t place,
                        double until, int ahead) {
  const int ball = p.window.bodies.back() == footage.ball()
                       ? static_cast<int>(p.window.bodies.size()) - 1
                       : simulator::no_body;
  const int self = static_cast<int>(place);
  bool hits_robot = false, hits_ball = false, hits_wall = false;
  int hits = 0;
  for (const simulator::Impact& impact : p.statistics.impacts) {
    if (impact.time > until || (impact.first != self && impact.second != self)) continue;
    ++hits;
    const int other = impact.first == self ? impact.second : impact.first;
    hits_wall = hits_wall || other == simulator::no_body;
    hits_ball = hits_ball || (other == ball && ball != simulator::no_body);
    hits_robot = hits_robot || (other != simulator::no_body && other != ball);
  }
  const bool presses = p.statistics.pressing[place].any();
  if (presses && hits > 0 && ahead >= 5) return EventKind::push;
  if (self == ball) {
    if (hits_robot) return EventKind::robot_and_ball;
    return hits_wall ? EventKind::wall : EventKind::free_roll;
  }
  if (hits_robot) return EventKind::robot_and_robot;
  if (hits_ball) return EventKind::robot_and_ball;
  if (hits_wall) return EventKind::wall;
  const auto& slides = p.slides[place];
  const bool slid =
      std::any_of(slides.begin(), slides.begin() + ahead, [](char c) { return c != 0; });
  return slid ? EventKind::slide : EventKind::drive;
}

// What predicts in one recording.
struct Predictors {
  const CameraLog& recording;
  const Footage& footage;
  const Guess& pitch;
  const Peer* peer;
  Rerun own, paper;

  Predictors(const CameraLog& r, const Footage& f, const Guess& guess, const Peer* other)
      : recording(r),
        footage(f),
        pitch(guess),
        peer(other),
        own(f, guess),
        paper(f, paper_guess(guess)) {}
};

std::optional<Prediction> predict(Predictors& by, int first, double sigma) {
  const Footage& footage = by.footage;
  Prediction p;
  p.window = {first, std::min(first + longest, footage.frames() - 1), {}};
  for (int body = 0; body < footage.bodies(); ++body) {
    if (const auto fitted = start_of(footage, body, first, sigma)) {
      p.window.bodies.push_back(body);
      p.start.push_back(fitted->state);
      p.fitted.push_back(*fitted);
    }
  }
  if (p.window.bodies.empty()) return std::nullopt;
  const std::size_t n = p.window.bodies.size();
  for (auto& of : p.at) of.resize(n);
  p.slides.resize(n);
  by.own.play(
      p.window, p.start,
      [&](int frame, std::size_t i, const BodyState& state) {
        p.at[0][i].push_back(state.position);
        const bool is_ball = p.window.bodies[i] == footage.ball();
        p.slides[i].push_back(!is_ball && std::abs(state.twist.left) > slides_shown ? 1 : 0);
        const double span = footage.time(frame) - footage.time(first);
        p.at[1][i].push_back(simulator::trajectory::along_arc(p.start[i], span).position);
      },
      &p.statistics);
  by.paper.play(p.window, p.start, [&](int, std::size_t i, const BodyState& state) {
    p.at[2][i].push_back(state.position);
  });
  if (by.peer != nullptr) {
    by.peer->play(by.recording, footage, by.pitch, p.window, p.start,
                  [&](int, std::size_t i, const Vec2& at) { p.at[3][i].push_back(at); });
  }
  return p;
}

std::string body_text(const CameraLog& recording, int body) {
  if (body == 2 * recording.robots) return "the ball";
  return (body < recording.robots ? "blue " : "yellow ") + std::to_string(body % recording.robots);
}

// Adds the errors of a prediction to the sums, and its tracks to the examples.
void add_prediction(const CameraLog& recording, const Footage& footage, const Prediction& p,
                    double sigma, SumTable& sums, std::vector<Track>& tracks) {
  for (std::size_t i = 0; i < p.window.bodies.size(); ++i) {
    const int body = p.window.bodies[i];
    if (p.fitted[i].misfit > fits_noise * sigma) continue;
    for (std::size_t h = 0; h < horizons.size(); ++h) {
      const int frame = p.window.first + horizons[h];
      if (frame > p.window.last || !footage.sight(body, frame).is_seen) continue;
      const double ahead = footage.time(frame) - footage.time(p.window.first);
      const EventKind kind = kind_of_event(p, footage, i, ahead, horizons[h]);
      Sums& cell = sums[static_cast<std::size_t>(kind)][h];
      const Vec2 seen = footage.sight(body, frame).position;
      for (int k = 0; k < predictors; ++k) {
        if (p.at[k][i].empty()) continue;  // no peer
        cell.squares[k].push_back((p.at[k][i][horizons[h] - 1] - seen).squaredNorm());
      }
      cell.noise.push_back(noise_square(p.fitted[i], sigma, ahead));
      if (horizons[h] != longest) continue;
      Track track{kind,
                  body == footage.ball(),
                  body_text(recording, body),
                  footage.time(p.window.first),
                  std::sqrt(cell.squares[0].back()),
                  {},
                  {}};
      for (int f = p.window.first + 1; f <= p.window.last; ++f) {
        if (footage.sight(body, f).is_seen) track.seen.push_back(footage.sight(body, f).position);
      }
      for (int k = 0; k < predictors; ++k) track.predicted[k] = p.at[k][i];
      const double moved = (track.seen.back() - track.seen.front()).norm();
      if (moved > 0.05 || kind == EventKind::push) tracks.push_back(std::move(track));
    }
  }
}

double mean_of(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double v : values) sum += v;
  return values.empty() ? 0.0 : sum / static_cast<double>(values.size());
}

ErrorCell cell_of(const Sums& sums) {
  ErrorCell cell;
  cell.count = static_cast<int>(sums.noise.size());
  if (cell.count == 0) return cell;
  const double noise = mean_of(sums.noise);
  for (int k = 0; k < predictors; ++k) {
    if (sums.squares[k].empty()) continue;
    cell.rms[k] = std::sqrt(std::max(0.0, mean_of(sums.squares[k]) - noise));
    if (k == 0 || cell.count < least_count) continue;
    double mean = 0.0, square = 0.0;
    for (int i = 0; i < cell.count; ++i) {
      const double d = sums.squares[0][i] - sums.squares[k][i];
      mean += d / cell.count;
      square += d * d / cell.count;
    }
    const double error = std::sqrt(std::max(0.0, square - mean * mean) / cell.count);
    cell.beats_simulator[k] =
        mean > 2.0 * error && cell.rms[0] > worse_by * cell.rms[k] + least_worse;
  }
  return cell;
}

std::string objection(EventKind kind, int horizon, const std::string& yardstick, double error,
                      const ErrorCell& cell) {
  return system::formatted(
      "%s, %d pictures ahead: the simulator is worse than %s: %.1f mm against %.1f mm in %d "
      "predictions",
      to_string(kind).data(), horizon, yardstick.c_str(), 1e3 * cell.rms[0], 1e3 * error,
      cell.count);
}

}  // namespace

Validation validate(const std::vector<CameraLog>& recordings, const Guess& pitch,
                    const Peer* peer) {
  Validation result;
  if (peer != nullptr) result.peer = peer->name;
  const std::array<std::string, predictors> names{"", "going on straight", "the paper's own model",
                                                  result.peer};
  SumTable sums;
  std::vector<Track> tracks;
  for (const CameraLog& recording : recordings) {
    const Footage footage(recording);
    const double sigma = footage.position_noise();
    result.noise = std::max(result.noise, sigma);
    result.period = footage.usual_period();
    Predictors by(recording, footage, pitch, peer);
    for (int f = pictures_before; f + 1 < footage.frames(); f += pictures_between) {
      const int last = std::min(f + longest, footage.frames() - 1);
      if (footage.is_broken(f - pictures_before, last)) continue;
      if (const auto p = predict(by, f, sigma))
        add_prediction(recording, footage, *p, sigma, sums, tracks);
    }
  }
  for (std::size_t kind = 0; kind < sums.size(); ++kind) {
    for (std::size_t h = 0; h < horizons.size(); ++h) {
      const ErrorCell cell = result.cells[kind][h] = cell_of(sums[kind][h]);
      for (int k = 1; k < predictors; ++k) {
        if (cell.beats_simulator[k]) {
          result.objections.push_back(
              objection(static_cast<EventKind>(kind), horizons[h], names[k], cell.rms[k], cell));
        }
      }
    }
    std::vector<Track> own;
    for (const Track& track : tracks) {
      if (static_cast<std::size_t>(track.kind) == kind) own.push_back(track);
    }
    if (own.empty()) continue;
    const auto middle = own.begin() + static_cast<std::ptrdiff_t>(own.size() / 2);
    std::nth_element(own.begin(), middle, own.end(),
                     [](const Track& a, const Track& b) { return a.error < b.error; });
    result.examples.push_back(*middle);
  }
  return result;
}

}  // namespace mirocup::pitch
