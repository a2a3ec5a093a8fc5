// SPDX-License-Identifier: MIT
//
// The contacts of an instant by groups: bodies that touch, directly or through others, concern no other
// group, and what is solved for several at once costs more than one after the other.
#pragma once

#include "core/simulator/collision/contact_constraint.hpp"

#include <array>
#include <span>

namespace mirocup::simulator::impact {

// Whom the contacts that count, counts(contact), connect with one of these bodies, directly or through
// others; of these, those with such a contact.
template <class Counts>
BodySet connected(const BodySet& with, std::span<const collision::Contact> contacts,
                  Counts counts) {
  if (contacts.empty()) return {};
  std::array<unsigned long, max_bodies> off_diagonal{};  // one bit for each body, itself included
  for (const collision::Contact& c : contacts) {
    if (!counts(c)) continue;
    const BodySet two = bodies_of(c.pair);
    for_each_body(two, [&](int i) { off_diagonal[i] |= two.to_ulong(); });
  }
  unsigned long found = 0;
  for (BodySet next = with; next.any();) {
    unsigned long reached = 0;
    for_each_body(next, [&](int i) { reached |= off_diagonal[i]; });
    next = BodySet(reached & ~(found | next.to_ulong()));
    found |= reached;
  }
  return BodySet(found);
}

// The bodies that hold together with this one, itself included; empty if nothing holds it.
BodySet cluster_of(int body, std::span<const collision::Contact> contacts);

// Those that touch one of these, directly or through others; empty if nothing touches them.
BodySet islands_of(const BodySet& bodies, std::span<const collision::Contact> contacts);

class Islands {
 public:
  // Puts the contacts of each group next to each other, without changing their order; groups are in the
  // order of their first contacts. Until the list changes, visits are of it.
  void sort(collision::ContactList& contacts);

  // Calls visit(contacts) for each group.
  template <class Visit>
  void for_each(collision::ContactList& contacts, Visit visit) const {
    for (int i = 0; i < count_; ++i) {
      visit(contacts.contacts().subspan(begin_[i], begin_[i + 1] - begin_[i]));
    }
  }

 private:
  std::size_t move_to_front(std::span<collision::Contact> contacts, const BodySet& group);

  collision::ContactList others_;
  std::array<std::size_t, max_bodies + 1> begin_{};  // of each group
  int count_ = 0;
};

}  // namespace mirocup::simulator::impact
