// SPDX-License-Identifier: MIT
#include "core/simulator/trajectory/taylor_series.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace mirocup::simulator::trajectory {

Series operator+(const Series& a, const Series& b) {
  return with_terms(std::max(a.terms, b.terms), [&](auto n) {
    Series s;
    s.terms = n;
    for (int k = 0; k < n; ++k) s[k] = a[k] + b[k];
    return s;
  });
}

Series operator-(const Series& a, const Series& b) {
  return with_terms(std::max(a.terms, b.terms), [&](auto n) {
    Series s;
    s.terms = n;
    for (int k = 0; k < n; ++k) s[k] = a[k] - b[k];
    return s;
  });
}

namespace {

// The same sums in the same order as product_term(), arranged so that a compiler can do two at a
// time, and keep them in registers: j is a constant in each line of what this comes to.
template <int n>
std::array<double, n> product(const Series& a, const Series& b) {
  std::array<double, n> sum{};
  const auto add = [&](auto j) {
    const double factor = a[j];
    if (factor == 0.0) return;
    for (int k = j; k < n; ++k) sum[k] += factor * b[k - j];
  };
  const auto add_all = [&]<int... j>(std::integer_sequence<int, j...>) {
    (add(std::integral_constant<int, j>{}), ...);
  };
  add_all(std::make_integer_sequence<int, n>{});
  return sum;
}

// Of a b and c d, term by term.
template <class Combine>
Series of_products(const Series& a, const Series& b, const Series& c, const Series& d,
                   Combine combine) {
  return with_terms(std::max({a.terms, b.terms, c.terms, d.terms}), [&](auto n) {
    Series s;
    s.terms = n;
    const auto ab = product<n>(a, b);
    const auto cd = product<n>(c, d);
    for (int k = 0; k < n; ++k) s[k] = combine(ab[k], cd[k]);
    return s;
  });
}

}  // namespace

Series operator*(const Series& a, const Series& b) {
  return with_terms(std::max(a.terms, b.terms), [&](auto n) {
    Series s;
    s.terms = n;
    const auto ab = product<n>(a, b);
    std::copy(ab.begin(), ab.end(), s.c.begin());
    return s;
  });
}

Series sum_of_products(const Series& a, const Series& b, const Series& c, const Series& d) {
  return of_products(a, b, c, d, std::plus<>{});
}

Series difference_of_products(const Series& a, const Series& b, const Series& c, const Series& d) {
  return of_products(a, b, c, d, std::minus<>{});
}

Series operator*(double factor, const Series& a) {
  return with_terms(a.terms, [&](auto n) {
    Series s;
    s.terms = n;
    for (int k = 0; k < n; ++k) s[k] = factor * a[k];
    return s;
  });
}

Series shifted(const Series& p, double by) {
  if (by == 0.0) return p;
  return with_terms(p.terms, [&](auto n) {
    Series s = p;
    // Repeated synthetic division by (t - by).
    for (int i = 0; i < n - 1; ++i) {
      for (int k = n - 2; k >= i; --k) s[k] += by * s[k + 1];
    }
    return s;
  });
}

Range change_over(const Series& p, double length) {
  return with_terms(p.terms, [&](auto n) {
    Range range{0.0, 0.0};
    double power = 1.0;
    for (int k = 1; k < n; ++k) {
      power *= length;
      const double change = p[k] * power;
      range.low += std::min(change, 0.0);
      range.high += std::max(change, 0.0);
    }
    return range;
  });
}

namespace {

// Range::low of change_over().
double least_change(const Series& p, double length) {
  return with_terms(p.terms, [&](auto n) {
    double low = 0.0;
    double power = 1.0;
    for (int k = 1; k < n; ++k) {
      power *= length;
      low += std::min(p[k] * power, 0.0);
    }
    return low;
  });
}

struct Value {
  double p;
  double slope;
};

Value evaluate(const Series& p, double t) {
  return with_terms(p.terms, [&](auto n) {
    double value = p[n - 1];
    double slope = 0.0;
    for (int k = n - 2; k >= 0; --k) {
      slope = slope * t + value;
      value = value * t + p[k];
    }
    return Value{value, slope};
  });
}

// Half of the strongest downward curvature on [0, end]. Terms with positive coefficients bend
// upwards for t >= 0 and may be left out.
double downward_curvature(const Series& p, double end) {
  double sum = 0.0;
  double power = 1.0;
  for (int k = 2; k < p.terms; ++k) {
    if (p[k] < 0.0) sum -= 0.5 * k * (k - 1) * p[k] * power;
    power *= end;
  }
  return sum;
}

// How far the parabola value + slope t - curvature t^2 stays above zero; value > 0.
double safe_step(double value, double slope, double curvature) {
  const double root = std::sqrt(slope * slope + 4.0 * curvature * value);
  if (slope < 0.0) return 2.0 * value / (root - slope);
  return curvature > 0.0 ? (slope + root) / (2.0 * curvature) : never;
}

}  // namespace

double first_crossing(const Series& p, double level, double begin, double end) {
  if (p[0] + least_change(p, end) > level) return never;

  // Looks at one window after the other; a window is made smaller where the bounds over it are too
  // loose.
  constexpr int steps_per_window = 8;
  constexpr int most_windows = 256;
  double origin = begin;
  double window = end - begin;
  bool may_fall = begin == 0.0;  // in the window; known of the whole of [0, end]
  for (int i = 0; i < most_windows; ++i) {
    const Series local = shifted(p, origin);
    window = std::min(window, end - origin);
    double t = 0.0;
    if (!may_fall && local[0] + least_change(local, window) > level) {
      t = window;
    } else {
      may_fall = false;
      const double curvature = downward_curvature(local, window);
      for (int step = 0; step < steps_per_window && t < window; ++step) {
        const Value here = evaluate(local, t);
        const double height = here.p - level;
        if (height <= root_tolerance) return origin + t;
        const double ahead = safe_step(height, here.slope, curvature);
        if (origin + (t + ahead) <= origin + t)
          return origin + t;  // closer than the clock can tell
        t += ahead;
      }
    }
    if (t >= window) {
      if (origin + window >= end) return never;
      origin += window;
      window *= 2.0;
    } else {
      origin += t;
      window *= 0.25;
    }
  }
  return origin;  // p is that close to the level for that long: the caller looks again from here
}

}  // namespace mirocup::simulator::trajectory
