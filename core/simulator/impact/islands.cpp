// SPDX-License-Identifier: MIT
#include "core/simulator/impact/islands.hpp"

#include <algorithm>

namespace mirocup::simulator::impact {

BodySet cluster_of(int body, std::span<const collision::Contact> contacts) {
  return connected(BodySet(1UL << body), contacts,
                   [](const collision::Contact& c) { return c.resting.is_active; });
}

BodySet islands_of(const BodySet& bodies, std::span<const collision::Contact> contacts) {
  return connected(bodies, contacts, [](const collision::Contact&) { return true; });
}

void Islands::sort(collision::ContactList& contacts) {
  count_ = 0;
  begin_[0] = 0;
  for (std::size_t left = 0; left < contacts.contacts().size();) {
    const std::span<collision::Contact> rest = contacts.contacts().subspan(left);
    const BodySet island = islands_of(bodies_of(rest.front().pair), rest);
    left += move_to_front(rest, island);
    begin_[++count_] = left;
  }
}

// Moves the island's contacts to the front, in the same order, and returns how many there are.
std::size_t Islands::move_to_front(std::span<collision::Contact> contacts, const BodySet& island) {
  std::size_t count = 0;
  std::size_t others = 0;
  for (collision::Contact& c : contacts) {
    if (!island[c.pair.a]) {
      others_.list[others++] = c;
    } else {
      if (others > 0) contacts[count] = c;
      ++count;
    }
  }
  std::copy_n(others_.list.begin(), others, contacts.begin() + static_cast<std::ptrdiff_t>(count));
  return count;
}

}  // namespace mirocup::simulator::impact
