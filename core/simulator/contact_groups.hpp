// SPDX-License-Identifier: MIT
//
// The contacts of an instant by groups: bodies that touch, directly or through others, concern no other
// group, and what is solved for several at once costs more than one after the other.
#pragma once

#include "core/simulator/impact.hpp"

#include <array>
#include <span>

namespace mirocup::simulator {

class ContactGroups {
 public:
  // Puts the contacts of each group next to each other, without changing their order; groups are in the
  // order of their first contacts. Until the list changes, visits are of it.
  void sort(ContactList& contacts);

  // Calls visit(contacts) for each group.
  template <class Visit>
  void for_each(ContactList& contacts, Visit visit) const {
    for (int i = 0; i < count_; ++i) {
      visit(contacts.contacts().subspan(begin_[i], begin_[i + 1] - begin_[i]));
    }
  }

 private:
  std::size_t gather(std::span<Contact> contacts, const BodySet& group);

  ContactList others_;
  std::array<std::size_t, max_bodies + 1> begin_{};  // of each group
  int count_ = 0;
};

}  // namespace mirocup::simulator
