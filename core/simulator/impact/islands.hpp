// SPDX-License-Identifier: MIT
//
// Islands: the connected components of the contact graph, whose nodes are bodies. Islands do not
// affect each other, and several small problems cost less than one large problem. Obstacles do not
// connect bodies, since they cannot move. Uses collision.
#pragma once

#include "core/simulator/collision/contact_constraint.hpp"

#include <array>
#include <span>

namespace mirocup::simulator::impact {

// Returns the bodies that are connected with a body in `start`, directly or through others. Two
// bodies are connected by a contact for which counts(contact) is true. A body in `start` is
// included only if it has such a contact.
template <class Counts>
BodySet connected(const BodySet& start, std::span<const collision::Contact> contacts,
                  Counts counts) {
  if (contacts.empty()) return {};
  std::array<unsigned long, max_bodies> neighbours{};  // one bit for each body, itself included
  for (const collision::Contact& c : contacts) {
    if (!counts(c)) continue;
    const BodySet two = bodies_of(c.pair);
    for_each_body(two, [&](int i) { neighbours[i] |= two.to_ulong(); });
  }
  // Breadth-first search: `next` holds the bodies found in the last round.
  unsigned long found = 0;
  for (BodySet next = start; next.any();) {
    unsigned long reached = 0;
    for_each_body(next, [&](int i) { reached |= neighbours[i]; });
    next = BodySet(reached & ~(found | next.to_ulong()));
    found |= reached;
  }
  return BodySet(found);
}

// Returns the contact cluster of a body, itself included: the bodies that active resting contacts
// connect with it. Empty if the body has no such contact.
BodySet cluster_of(int body, std::span<const collision::Contact> contacts);

// Returns the union of the islands of these bodies. In an island every contact connects, active or
// not. A body without a contact is left out.
BodySet islands_of(const BodySet& bodies, std::span<const collision::Contact> contacts);

// The contacts of an instant, sorted by islands. Kept and reused: holds scratch space, so nothing
// is allocated.
class Islands {
 public:
  // Sorts the list so that the contacts of each island follow each other. Their order within an
  // island does not change, and islands are in the order of their first contacts. for_each() is
  // valid until the list changes.
  void sort(collision::ContactList& contacts);

  // Calls visit(contacts) for each island of the list that was sorted last.
  template <class Visit>
  void for_each(collision::ContactList& contacts, Visit visit) const {
    for (int i = 0; i < count_; ++i) {
      visit(contacts.contacts().subspan(begin_[i], begin_[i + 1] - begin_[i]));
    }
  }

 private:
  std::size_t move_to_front(std::span<collision::Contact> contacts, const BodySet& island);

  collision::ContactList others_;                    // scratch space of move_to_front()
  std::array<std::size_t, max_bodies + 1> begin_{};  // index of each island's first contact
  int count_ = 0;
};

}  // namespace mirocup::simulator::impact
