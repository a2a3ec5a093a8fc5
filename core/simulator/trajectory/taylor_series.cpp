// SPDX-License-Identifier: MIT
#include "core/simulator/trajectory/taylor_series.hpp"

#include "core/base/assert.hpp"

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

// All coefficients of a * b: the sums of product_term(), added in the same order. The loops are
// exchanged so that the compiler can compute two sums at a time and keep them in registers; j is a
// constant in each unrolled line.
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

// Combines the products a b and c d term by term.
template <class Combine>
Series combined_products(const Series& a, const Series& b, const Series& c, const Series& d,
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
  return combined_products(a, b, c, d, std::plus<>{});
}

Series difference_of_products(const Series& a, const Series& b, const Series& c, const Series& d) {
  return combined_products(a, b, c, d, std::minus<>{});
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

// Range::low of change_over(), which costs half of the whole.
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

// Half of the largest -p'' on [0, end], or an upper bound of it. Terms with positive coefficients
// curve upwards for t >= 0 and are left out.
double downward_curvature(const Series& p, double end) {
  return with_terms(p.terms, [&](auto n) {
    double sum = 0.0;
    double power = 1.0;
    for (int k = 2; k < n; ++k) {
      if (p[k] < 0.0) sum -= 0.5 * k * (k - 1) * p[k] * power;
      power *= end;
    }
    return sum;
  });
}

// The first positive root of value + slope t - curvature t^2, for value > 0 and curvature >= 0. Of
// the two forms of the root, each branch uses the one without cancellation.
double safe_step(double value, double slope, double curvature) {
  const double root = std::sqrt(slope * slope + 4.0 * curvature * value);
  if (slope < 0.0) return 2.0 * value / (root - slope);
  return curvature > 0.0 ? (slope + root) / (2.0 * curvature) : never;
}

// A search in a window: up to t the polynomial is above the level, and at t it has reached it if
// `is_crossing`.
struct WindowSearch {
  double t;
  bool is_crossing;
};

// Searches [0, window] of a polynomial whose time 0 is at `origin` of the segment.
WindowSearch search_window(const Series& local, double level, double origin, double window) {
  const double curvature = downward_curvature(local, window);
  double t = 0.0;
  for (int step = 0; step < settings::taylor_series.steps_per_window && t < window; ++step) {
    const Value here = evaluate(local, t);
    const double height = here.p - level;
    if (height <= settings::taylor_series.root_tolerance) return {t, true};
    const double ahead = safe_step(height, here.slope, curvature);
    // Two tolerances: above, in the value; here, in time. A step too short for the clock of the
    // tick is a crossing, too: a steep curve can be within one tick of the clock of its root and
    // still above root_tolerance.
    if (origin + (t + ahead) <= origin + t) return {t, true};
    t += ahead;
  }
  return {t, false};
}

}  // namespace

// The interval is searched in windows. The bound of the curvature holds over a whole window: the
// smaller the window, the tighter the bound and the longer the steps. So a window that the steps do
// not get through is given up for a smaller one, which starts where they stopped. After a window
// without a crossing a larger one follows.
double first_crossing(const Series& p, double level, double begin, double end) {
  MIROCUP_ASSERT(0.0 <= begin);
  if (p[0] + least_change(p, end) > level) return never;

  double origin = begin;
  double window = end - begin;
  // The first window is [0, end] if begin is 0: the line above has computed its bound already.
  bool bound_is_known = begin == 0.0;
  for (int i = 0; i < settings::taylor_series.max_windows; ++i) {
    const Series local = shifted(p, origin);
    window = std::min(window, end - origin);
    double t = window;
    if (bound_is_known || !(local[0] + least_change(local, window) > level)) {
      bound_is_known = false;
      const WindowSearch search = search_window(local, level, origin, window);
      if (search.is_crossing) return origin + search.t;
      t = search.t;
    }
    if (t >= window) {
      if (origin + window >= end) return never;
      origin += window;
      window *= settings::taylor_series.window_growth;
    } else {
      origin += t;
      window *= settings::taylor_series.window_shrink;
    }
  }
  return origin;
}

}  // namespace mirocup::simulator::trajectory
