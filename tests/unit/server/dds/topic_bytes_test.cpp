// SPDX-License-Identifier: MIT
//
// The bytes of each topic's samples on the network, which programs in other languages rely on.
// Every member has another value, so this catches a member that moves, that gets another type, or
// that is encoded in another way; sizes and the text of the IDL (topics_test.cpp) do not tell all
// of that.
#include <dds/ddsi/ddsi_cdrstream.h>
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <map>
#include <mirocup.h>
#include <string>
#include <type_traits>

namespace mirocup::dds {
namespace {

// Gives members, in the order of the calls, the values 1, 2, 3 and so on; real numbers a quarter
// more, texts "t1", "t2".
class Filler {
 public:
  template <class... Members>
  void fill(Members&... members) {
    (put(members), ...);
  }

 private:
  template <class Number>
  requires std::is_arithmetic_v<Number>
  void put(Number& number) {
    ++last_;
    if constexpr (std::is_same_v<Number, bool>) {
      number = true;
    } else if constexpr (std::is_floating_point_v<Number>) {
      number = last_ + 0.25;
    } else {
      number = static_cast<Number>(last_);
    }
  }
  template <std::size_t size>
  void put(char (&text)[size]) {
    std::snprintf(text, size, "t%d", ++last_);
  }
  template <class Member, std::size_t size>
  requires(!std::is_same_v<Member, char>) void put(Member (&members)[size]) {
    for (Member& member : members) put(member);
  }
  void put(mirocup_v1_RobotState& r) { fill(r.x, r.y, r.heading, r.vx, r.vy, r.turn); }
  void put(mirocup_v1_Pose& p) { fill(p.x, p.y, p.heading); }
  void put(mirocup_v1_NamedNumber& n) { fill(n.name, n.value); }
  void put(mirocup_v1_TeamCounts& c) {
    fill(c.two_defenders_s, c.four_defenders_s, c.two_attackers_s, c.keeper_hold_s, c.defenders,
         c.area_defenders, c.attackers, c.keeper, c.advantage_against);
  }
  void put(mirocup_v1_LegFacts& f) {
    fill(f.league, f.robots, f.control_period, f.half_seconds, f.half_length, f.half_width,
         f.corner_leg, f.goal_half_width, f.goal_depth, f.goal_area_depth, f.goal_area_half_width,
         f.penalty_area_depth, f.penalty_area_half_width, f.centre_circle_radius, f.robot_side,
         f.robot_mass, f.wheel_distance, f.wheel_radius, f.wheel_speed_limit, f.motor_time_constant,
         f.grip, f.ball_radius, f.ball_mass, f.conditions, f.pitch, f.named, f.numbers);
  }

  int last_ = 0;
};

std::string bytes_of(const dds_topic_descriptor_t& type, const void* sample) {
  dds_ostreamLE_t stream;
  dds_ostreamLE_init(&stream, 0, 1);
  EXPECT_NE(dds_stream_writeLE(&stream, static_cast<const char*>(sample), type.m_ops), nullptr);
  std::string digits;
  for (std::uint32_t i = 0; i < stream.x.m_index; ++i) {
    std::array<char, 3> two{};
    std::snprintf(two.data(), two.size(), "%02x", stream.x.m_buffer[i]);
    digits += two.data();
  }
  dds_ostreamLE_fini(&stream);
  return digits;
}

// Reads `topic_bytes.txt`: the name of a topic, then its bytes in lines of digits.
std::map<std::string, std::string> pinned() {
  std::ifstream file(MIROCUP_SOURCE_FOLDER "/tests/unit/server/dds/topic_bytes.txt");
  std::map<std::string, std::string> topics;
  std::string name;
  for (std::string word; file >> word;) {
    if (word.starts_with("topic:")) {
      name = word.substr(6);
    } else {
      topics[name] += word;
    }
  }
  return topics;
}

void expect_pinned(const dds_topic_descriptor_t& type, const void* sample) {
  const std::string name = std::string(type.m_typename).substr(13);  // behind "mirocup::v1::"
  EXPECT_EQ(bytes_of(type, sample), pinned()[name]) << name;
}

TEST(TopicBytes, AreThoseOfTheLayout) {
  mirocup_v1_WorldState state{};
  Filler().fill(state.layout, state.tick, state.leg, state.time, state.clock, state.state,
                state.phase, state.restart, state.taker, state.left, state.placing, state.robots,
                state.score, state.heard, state.ball_x, state.ball_y, state.ball_vx, state.ball_vy,
                state.stalemate_s, state.advantage_s, state.blue, state.yellow, state.counts,
                state.ball_age, state.blue_age, state.yellow_age);
  expect_pinned(mirocup_v1_WorldState_desc, &state);

  mirocup_v1_TeamCommand command{};
  Filler().fill(command.nonce, command.tick, command.team, command.places, command.left,
                command.right, command.place_ball_x, command.place_ball_y, command.place);
  expect_pinned(mirocup_v1_TeamCommand_desc, &command);

  mirocup_v1_Hello hello{};
  Filler().fill(hello.layout, hello.team, hello.nonce, hello.name);
  expect_pinned(mirocup_v1_Hello_desc, &hello);

  mirocup_v1_Welcome welcome{};
  Filler().fill(welcome.layout, welcome.team, welcome.answer, welcome.nonce, welcome.leg,
                welcome.reason, welcome.seed, welcome.facts);
  expect_pinned(mirocup_v1_Welcome_desc, &welcome);

  mirocup_v1_MatchInfo info{};
  Filler().fill(info.layout, info.leg, info.blue, info.yellow, info.speed, info.facts);
  expect_pinned(mirocup_v1_MatchInfo_desc, &info);

  mirocup_v1_MatchEvent event{};
  Filler().fill(event.layout, event.number, event.leg, event.tick, event.ends_match, event.clock,
                event.score, event.decision, event.law, event.reason);
  expect_pinned(mirocup_v1_MatchEvent_desc, &event);
}

}  // namespace
}  // namespace mirocup::dds
