// SPDX-License-Identifier: MIT
#include "core/simulator/collision/reference_edges.hpp"

#include <algorithm>
#include <array>
#include <optional>

namespace mirocup::simulator::collision {

namespace {

// Returns the edge over which the pair of these contacts came to overlap if it is another one than
// theirs. All gaps are taken to change at constant rates within the step.
std::optional<geometry::Reference> crossed_edge(const StaticWorld& world,
                                                std::span<const Contact> contacts,
                                                std::span<const BodyState> begin,
                                                std::span<const BodyState> end) {
  const Pair& pair = contacts.front().pair;
  if (world.is_ball(pair.a) || pair.with_plane()) return {};

  // The contacts' own edge is right if a corner was in front of its line at the start, or behind it
  // by no more than a step may leave.
  std::array<double, ContactPoints::max_points> gap_at_begin{};
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    ContactPoint at = contacts[i].point;
    refresh_contact(world, begin, pair, at);
    if (at.gap >= -world.tolerances.intermediate_penetration) return {};
    gap_at_begin[i] = at.gap;
  }

  // The edge that separated the bodies at the start, and the share of the step after which it did
  // so no more.
  const geometry::Outline& a = world.shape(pair.a);
  const geometry::Outline& b = partner_outline(world, pair);
  const geometry::Reference first = reference_of(a, begin[pair.a], b, partner_body(pair, begin));
  const double before = std::max(first.best.separation, 0.0);
  const double after = separation_from(first, a, end[pair.a], b, partner_body(pair, end));
  if (after >= 0.0) return {};
  const double share = before / (before - after);

  // If a corner was in front of the contacts' own edge by then, it had passed the other corner, and
  // the contacts are right.
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    if (gap_at_begin[i] + share * (contacts[i].point.gap - gap_at_begin[i]) > 0.0) return {};
  }
  return first;
}

}  // namespace

void use_reference_edges(const StaticWorld& world, std::span<const BodyState> begin,
                         std::span<const BodyState> end, ContactList& list) {
  struct CrossedEdge {
    Pair pair;
    geometry::Reference edge;
  };
  std::array<CrossedEdge, max_contacts> crossed;
  int count = 0;
  for_each_pair(list.contacts(), [&](std::span<const Contact> contacts) {
    const auto edge = crossed_edge(world, contacts, begin, end);
    if (edge) crossed[count++] = {contacts.front().pair, *edge};
  });
  for (int i = 0; i < count; ++i) {
    const auto& [pair, edge] = crossed[i];
    list.keep_if([&pair = pair](const Contact& c) { return !(c.pair == pair); });
    add_points(world, pair, end,
               incident_corners(edge, world.shape(pair.a), end[pair.a],
                                partner_outline(world, pair), partner_body(pair, end)),
               list);
  }
}

}  // namespace mirocup::simulator::collision
