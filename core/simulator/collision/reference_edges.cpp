// SPDX-License-Identifier: MIT
#include "core/simulator/collision/reference_edges.hpp"

#include <algorithm>
#include <array>
#include <optional>

namespace mirocup::simulator::collision {

namespace {

// Of the pair of these contacts, if it is not theirs. All gaps are taken to change at even rates.
std::optional<geometry::Reference> edge_of_entry(const StaticWorld& world,
                                                 std::span<const Contact> contacts,
                                                 std::span<const BodyState> begin,
                                                 std::span<const BodyState> end) {
  const Pair& pair = contacts.front().pair;
  if (world.is_ball(pair.a) || pair.with_plane()) return {};
  std::array<double, 2> were{};  // gaps
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    ContactPoint at = contacts[i].point;
    refresh_contact(world, begin, pair, at);
    if (at.gap >= -world.tolerances.intermediate_penetration) return {};
    were[i] = at.gap;
  }
  const geometry::Outline& a = world.shape(pair.a);
  const geometry::Outline& b = partner_outline(world, pair);
  const geometry::Reference first = reference_of(a, begin[pair.a], b, partner_body(pair, begin));
  const double was = std::max(first.best.separation, 0.0);
  const double is = separation_from(first, a, end[pair.a], b, partner_body(pair, end));
  if (is >= 0.0) return {};
  const double part = was / (was - is);
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    // Behind the first edge only when it was past the corner already.
    if (were[i] + part * (contacts[i].point.gap - were[i]) > 0.0) return {};
  }
  return first;
}

}  // namespace

void use_reference_edges(const StaticWorld& world, std::span<const BodyState> begin,
                         std::span<const BodyState> end, ContactList& list) {
  struct Entry {
    Pair pair;
    geometry::Reference over;
  };
  std::array<Entry, solver::max_unknowns> entries;
  int count = 0;
  for_each_pair(list.contacts(), [&](std::span<const Contact> contacts) {
    const auto first = edge_of_entry(world, contacts, begin, end);
    if (first) entries[count++] = {contacts.front().pair, *first};
  });
  for (int i = 0; i < count; ++i) {
    const auto& [pair, over] = entries[i];
    list.keep_if([&pair = pair](const Contact& c) { return !(c.pair == pair); });
    add_points(world, pair, end,
               corners_over(over, world.shape(pair.a), end[pair.a], partner_outline(world, pair),
                            partner_body(pair, end)),
               list);
  }
}

}  // namespace mirocup::simulator::collision
