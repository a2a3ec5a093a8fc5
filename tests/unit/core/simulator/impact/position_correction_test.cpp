// SPDX-License-Identifier: MIT
//
// Overlaps that position projection removes.
#include "core/simulator/impact/position_correction.hpp"

#include "core/simulator/collision/collision_queries.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>

namespace mirocup::simulator::impact {
namespace {

constexpr double overlap = 1e-6;

struct CrowdedRow {
  collision::StaticWorld world;
  std::array<BodyState, 4> bodies{};
  std::array<solver::InverseMass, 4> mass{};
  collision::ContactList list;

  // Robots beside each other, `by` too close.
  CrowdedRow(int robots, double by, double side)
      : world(collision::make_static_world(nullptr, {}, {}, robots, false)) {
    for (int i = 0; i < robots; ++i) {
      bodies[i].position = {side * i * (world.parameters.robot_side - by), 0.0};
      mass[i] = world.free_robot;
      if (i > 0) add_contacts(world, pair_of(i, i - 1), bodies, 1e-9, list);
    }
  }
};

TEST(PositionProjection, RemovesOverlaps) {
  const auto problem = std::make_unique<solver::RegularizedQp>();
  for (const double side : {1.0, -1.0}) {
    CrowdedRow row(4, overlap, side);
    project_positions(row.list.contacts(), row.mass, row.bodies, *problem);
    for (int i = 1; i < 4; ++i) {
      const double left = gap(row.world, pair_of(i, i - 1), row.bodies[i], row.bodies[i - 1]);
      EXPECT_NEAR(left, 0.0, 1e-10);
    }
    EXPECT_NEAR(row.bodies[0].position.x(), -side * 1.5 * overlap, 1e-10);
    EXPECT_NEAR(row.bodies[0].position.y(), 0.0, 1e-15);
  }
}

// A robot between two that cannot be moved, with less room than it needs. Catches shifts that grow
// without limit: bodies were thrown about by a hundred times their overlap.
TEST(PositionProjection, MovesLittleWhereThereIsNoRoom) {
  const auto problem = std::make_unique<solver::RegularizedQp>();
  for (const double side : {1.0, -1.0}) {
    CrowdedRow row(3, overlap, side);
    row.mass[0] = row.mass[2] = {};
    project_positions(row.list.contacts(), row.mass, row.bodies, *problem);
    for (int i = 0; i < 3; ++i) {
      const double begin = side * i * (row.world.parameters.robot_side - overlap);
      EXPECT_LT(std::abs(row.bodies[i].position.x() - begin), 2.0 * overlap);
      EXPECT_LT(std::abs(row.bodies[i].position.y()), 2.0 * overlap);
      EXPECT_LT(std::abs(row.bodies[i].heading.sin), 1e-4);
    }
  }
}

}  // namespace
}  // namespace mirocup::simulator::impact
