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

std::vector<std::vector<Two>> contacts_by_island(collision::ContactList& list) {
  const auto islands = std::make_unique<Islands>();
  islands->sort(list);
  std::vector<std::vector<Two>> found;
  islands->for_each(list, [&](std::span<const collision::Contact> contacts) {
    found.emplace_back();
    for (const collision::Contact& c : contacts)
      found.back().emplace_back(c.pair.a, c.pair.partner);
  });
  return found;
}

// Bodies of one island may be connected by the last contact only, and islands may come mixed.
// Catches an island that is closed too early, and contacts that are lost or change their order.
TEST(Islands, ContactsOfAnIslandFollowEachOther) {
  const auto list = contacts_of({{2, 1}, {5, 3}, {7, 6}, {2, 1}, {4, 3}, {9, 8}, {6, 1}});
  const std::vector<std::vector<Two>> expected{
      {{2, 1}, {7, 6}, {2, 1}, {6, 1}}, {{5, 3}, {4, 3}}, {{9, 8}}};
  EXPECT_EQ(contacts_by_island(*list), expected);
}

// Two robots at the same wall do not affect each other.
TEST(Islands, ObstaclesDoNotConnectBodies) {
  const auto list = contacts_of({{2, 1}, {4, 3}});
  for (const int i : {1, 3}) list->list[list->count++].pair = pair_with_obstacle(i, 0);
  EXPECT_EQ(contacts_by_island(*list).size(), 2);
}

TEST(Islands, WithoutContactsThereIsNoIsland) {
  const auto list = contacts_of({});
  EXPECT_TRUE(contacts_by_island(*list).empty());
}

// Catches a search that includes the body it starts from although nothing touches it.
TEST(Islands, ABodyWithoutContactHasNone) {
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
