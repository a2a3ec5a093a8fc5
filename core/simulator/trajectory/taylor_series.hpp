// SPDX-License-Identifier: MIT
//
// Truncated Taylor series in time: the form of every motion between two events.
//
// Between two events a robot or the ball follows a smooth differential equation whose right-hand
// side has products and sums only. So each Taylor coefficient follows from the earlier ones by a
// recurrence (automatic differentiation; Moore 1966, "Interval Analysis"). A position is then a
// polynomial, a gap is a polynomial, and the first contact is the first root of a gap.
//
// A segment is kept so short that its series have converged (see converged_length() in
// segment.hpp). Most of the work grows with the square of the number of terms, so a short motion
// has few terms.
//
// The room trajectory uses model, and below it base, field and geometry.
#pragma once

#include "core/simulator/model/solver_settings.hpp"

#include <array>
#include <limits>
#include <type_traits>

namespace mirocup::simulator::trajectory {

// The numbers of coefficients, t^0 .. t^(n-1), that a series may have.
inline constexpr std::array<int, 4> term_counts{6, 8, 10, 14};
inline constexpr int min_terms = term_counts.front();
inline constexpr int max_terms = term_counts.back();

// A time that never comes.
inline constexpr double never = std::numeric_limits<double>::infinity();

// A polynomial in t, in seconds since the start of the segment that the series belongs to. The
// owner of the series states the unit of its values.
struct Series {
  std::array<double, max_terms> c{};
  int terms = max_terms;  // one of term_counts; c[terms] and all later ones are zero

  double operator[](int k) const { return c[k]; }
  double& operator[](int k) { return c[k]; }

  // Returns the value at t, by Horner's rule.
  double at(double t) const;

  // The same value, for a series that is known to have n terms.
  template <int n>
  double at(double t) const {
    double sum = c[n - 1];
    for (int k = n - 2; k >= 0; --k) sum = sum * t + c[k];
    return sum;
  }
};

// Calls f with `terms`, one of term_counts, as a compile-time constant (an std::integral_constant),
// and returns its result. So the compiler can unroll loops over terms.
template <class F>
auto with_terms(int terms, F f) {
  if (terms == term_counts[1]) return f(std::integral_constant<int, term_counts[1]>{});  // mostly
  if (terms < term_counts[1]) return f(std::integral_constant<int, term_counts[0]>{});
  return terms == term_counts[2] ? f(std::integral_constant<int, term_counts[2]>{})
                                 : f(std::integral_constant<int, term_counts[3]>{});
}

inline double Series::at(double t) const {
  return with_terms(terms, [&](auto n) { return at<n>(t); });
}

// Sum, difference and product, with the number of terms of the longer series. A product is
// truncated to that number.
Series operator+(const Series& a, const Series& b);
Series operator-(const Series& a, const Series& b);
Series operator*(const Series& a, const Series& b);
Series operator*(double factor, const Series& a);

// Return a b + c d and a b - c d: the same bits as the operators, with fewer intermediate series.
Series sum_of_products(const Series& a, const Series& b, const Series& c, const Series& d);
Series difference_of_products(const Series& a, const Series& b, const Series& c, const Series& d);

// Returns coefficient k of a * b from the coefficients 0 .. k of both: the step of every
// recurrence. Terms of `a` below term `first` are left out.
inline double product_term(const Series& a, const Series& b, int k, int first = 0) {
  double sum = 0.0;
  for (int j = first; j <= k; ++j) sum += a[j] * b[k - j];
  return sum;
}

// Returns the same polynomial counted from another origin: shifted(p, d).at(t) = p.at(t + d).
Series shifted(const Series& p, double by);

// An interval that contains the change of a series' value.
struct Range {
  double low;
  double high;
};
// Returns bounds of p(t) - p(0) for 0 <= t <= length. The bounds are not sharp, because each term
// is bounded by itself, even if terms have different signs.
Range change_over(const Series& p, double length);

// Returns the first t in [begin, end] at which p is at most `level` + root_tolerance, or `never`.
// Precondition: 0 <= begin <= end.
//
// No root is skipped. Each step goes to the root of a parabola that lies below p: at the present t
// it has the value and the slope of p, and its curvature bounds that of p from below. Near a simple
// root the convergence is quadratic. If p stays within rounding of the level for very long, the
// search stops and returns the time up to which p is known to be above the level. The caller
// searches again from there.
double first_crossing(const Series& p, double level, double begin, double end);

// Returns the longest segment, s, that is worth trying for a motion with rates up to `rate` (1/s:
// turn rates and reciprocal time constants added). A turn whose rate changes may converge more
// slowly; converged_length() then shortens the segment.
inline double segment_length(double rate) {
  return rate > 0.0 ? settings::taylor_series.length_times_rate / rate : never;
}

}  // namespace mirocup::simulator::trajectory
