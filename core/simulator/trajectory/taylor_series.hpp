// SPDX-License-Identifier: MIT
//
// Power series in time: how every motion of one tick is written down.
//
// Between two events a robot or the ball follows a smooth differential equation whose Taylor
// coefficients come one from the other by multiplications only. So a position is a polynomial, a
// gap is a polynomial, and the first touch is the first root of one. Truncation: a segment is kept
// so short that its series have converged (see converged_length()). Most of the work grows with the
// square of the terms, so a curve that is soon over has few, and one between two bounces fewer.
#pragma once

#include <array>
#include <limits>
#include <type_traits>

namespace mirocup::simulator::trajectory {

// How many coefficients, t^0 .. t^(n-1), a series may have: few of a short curve.
inline constexpr std::array<int, 4> term_counts{6, 8, 10, 14};
inline constexpr int min_terms = term_counts.front();
inline constexpr int max_terms = term_counts.back();

// "Never", where a time is asked for.
inline constexpr double never = std::numeric_limits<double>::infinity();

// Values in any unit, t in seconds from the begin of the segment that the series belongs to.
struct Series {
  std::array<double, max_terms> c{};
  int terms = max_terms;  // one of term_counts: all coefficients from there on are zero

  double operator[](int k) const { return c[k]; }
  double& operator[](int k) { return c[k]; }

  double at(double t) const;

  // The same for a series of n terms.
  template <int n>
  double at(double t) const {
    double sum = c[n - 1];
    for (int k = n - 2; k >= 0; --k) sum = sum * t + c[k];
    return sum;
  }

  static Series constant(double value) {
    Series s;
    s.c[0] = value;
    s.terms = min_terms;
    return s;
  }
};

// Calls f with a number of terms, one of term_counts, as a constant (an std::integral_constant): it
// is what lets a compiler unroll loops over terms.
template <class F>
auto with_terms(int terms, F f) {
  if (terms == term_counts[0]) return f(std::integral_constant<int, term_counts[0]>{});
  if (terms == term_counts[1]) return f(std::integral_constant<int, term_counts[1]>{});
  return terms == term_counts[2] ? f(std::integral_constant<int, term_counts[2]>{})
                                 : f(std::integral_constant<int, term_counts[3]>{});
}

inline double Series::at(double t) const {
  return with_terms(terms, [&](auto n) { return at<n>(t); });
}

Series operator+(const Series& a, const Series& b);
Series operator-(const Series& a, const Series& b);
Series operator*(const Series& a, const Series& b);  // truncated to the terms of the longer one
Series operator*(double factor, const Series& a);

// a b + c d and a b - c d: the same numbers, with less to store.
Series sum_of_products(const Series& a, const Series& b, const Series& c, const Series& d);
Series difference_of_products(const Series& a, const Series& b, const Series& c, const Series& d);

// Coefficient k of a * b, from the coefficients 0 .. k of both: the step of every recurrence. From
// `first` on, without what the coefficients of a before that give.
inline double product_term(const Series& a, const Series& b, int k, int first = 0) {
  double sum = 0.0;
  for (int j = first; j <= k; ++j) sum += a[j] * b[k - j];
  return sum;
}

// The same polynomial counted from a later origin: shifted(p, d).at(t) = p.at(t + d).
Series shifted(const Series& p, double by);

// Bounds of p over [0, length]: p(t) - p(0) lies between `low` and `high`.
struct Range {
  double low;
  double high;
};
Range change_over(const Series& p, double length);

// The first t in [begin, end] at which p has fallen to `level` or below, or never; 0 <= begin.
//
// It cannot skip a root: every step stays left of the first root of a parabola that lies below p,
// and the parabola's curvature bounds that of p from below over the whole interval. Near a simple
// root it converges quadratically; p at the result is at most `level` + `closeness`.
inline constexpr double root_tolerance = 1e-14;
double first_crossing(const Series& p, double level, double begin, double end);

// The longest segment worth trying for a motion with rates up to `rate` (1/s: turn rates and
// reciprocal time constants added). One exponential, or a steady turn, is exact to 1e-13 of itself
// over it; a turn that changes may converge more slowly.
inline double segment_length(double rate) {
  return rate > 0.0 ? 0.6 / rate : never;
}

}  // namespace mirocup::simulator::trajectory
