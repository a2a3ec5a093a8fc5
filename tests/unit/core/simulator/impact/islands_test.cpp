// SPDX-License-Identifier: MIT
#include "core/simulator/impact/islands.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <utility>
#include <vector>

namespace mirocup::simulator::impact {
namespace {

using Two = std::pair<int, int>;

std::unique_ptr<collision::ContactList> contacts_of(const std::vector<Two>& pairs) {
  auto list = std::make_unique<collision::ContactList>();
  for (const auto& [i, j] : pairs) list->list[list->count++].pair = pair_of(i, j);
  return list;
}

std::vector<std::vector<Two>> groups_of(collision::ContactList& list) {
  const auto groups = std::make_unique<Islands>();
  groups->sort(list);
  std::vector<std::vector<Two>> found;
  groups->for_each(list, [&](std::span<const collision::Contact> contacts) {
    found.emplace_back();
    for (const collision::Contact& c : contacts)
      found.back().emplace_back(c.pair.a, c.pair.partner);
  });
  return found;
}

// Bodies of one group may be connected by the last contact only, and groups may come mixed. Catches a
// group that is closed too early, and contacts that are lost or change their order.
TEST(Islands, AreNextToEachOther) {
  const auto list = contacts_of({{2, 1}, {5, 3}, {7, 6}, {2, 1}, {4, 3}, {9, 8}, {6, 1}});
  const std::vector<std::vector<Two>> expected{
      {{2, 1}, {7, 6}, {2, 1}, {6, 1}}, {{5, 3}, {4, 3}}, {{9, 8}}};
  EXPECT_EQ(groups_of(*list), expected);
}

// Two robots at the same wall have nothing to do with each other.
TEST(Islands, ObstaclesConnectNobody) {
  const auto list = contacts_of({{2, 1}, {4, 3}});
  for (const int i : {1, 3}) list->list[list->count++].pair = pair_with_obstacle(i, 0);
  EXPECT_EQ(groups_of(*list).size(), 2);
}

TEST(Islands, NoContactsAreNoGroup) {
  const auto list = contacts_of({});
  EXPECT_TRUE(groups_of(*list).empty());
}

// Catches a search that counts who is asked for where nothing touches it.
TEST(Cluster, OnlyContactsConnect) {
  const auto list = contacts_of({{2, 1}, {3, 2}, {6, 5}});
  EXPECT_EQ(islands_of(BodySet(0b11), list->contacts()), BodySet(0b1110));
  EXPECT_EQ(islands_of(BodySet(0b1), list->contacts()), BodySet());
  EXPECT_EQ(cluster_of(1, list->contacts()), BodySet());
  list->list[1].resting.is_active = true;
  EXPECT_EQ(cluster_of(1, list->contacts()), BodySet());
  EXPECT_EQ(cluster_of(2, list->contacts()), BodySet(0b1100));
}

}  // namespace
}  // namespace mirocup::simulator::impact
