// SPDX-License-Identifier: MIT
//
// Pins what is on the network. Catches a layout that was changed without a new number: two
// processes of different layouts would read garbage from each other. If a test fails, you changed
// the layout: give LAYOUT_NUMBER in idl/mirocup.idl another number (or, for an incompatible change,
// the module), and then correct the bytes or the number here. Programs in other languages rely on
// them.
#include <dds/ddsi/ddsi_cdrstream.h>
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <iterator>
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

// The bytes of each topic's samples, in which every member has another value. Catches a member that
// moves, that gets another type, or that is encoded in another way.
TEST(Topics, HaveTheBytesOfTheirLayout) {
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

// The number stands for the text of the IDL without comments and white space: for names and
// constants, which the bytes do not tell.
std::uint64_t hash_of_text(const std::string& idl) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (std::size_t i = 0; i < idl.size(); ++i) {
    if (idl.compare(i, 2, "//") == 0) i = idl.find('\n', i);
    if (idl[i] == ' ' || idl[i] == '\n') continue;
    hash = (hash ^ static_cast<unsigned char>(idl[i])) * 0x100000001b3U;
  }
  return hash;
}

TEST(Topics, HaveTheTextOfTheirLayout) {
  std::ifstream file(MIROCUP_SOURCE_FOLDER "/idl/mirocup.idl");
  EXPECT_EQ(hash_of_text({std::istreambuf_iterator<char>(file), {}}), 18364874238391176012U);
}

// A WorldState is followed by the signatures of its readers. Measured: 56 bytes of RTPS headers and
// 4 of the encapsulation; 48 of the signature and 20 for each reader.
TEST(Topics, AStateFitsOneEthernetFrame) {
  constexpr std::uint32_t udp_payload = 1500 - 20 - 8;
  constexpr std::uint32_t rtps = 60, signature = 48, for_each_reader = 20, readers = 5;
  const mirocup_v1_WorldState zeros{};
  const std::size_t state = bytes_of(mirocup_v1_WorldState_desc, &zeros).size() / 2;  // digits
  const std::size_t padded = (state + 3) / 4 * 4;
  EXPECT_LE(padded + rtps + signature + readers * for_each_reader, udp_payload);
}

// A forged announcement could add to the description of WorldState a part that no process has, and
// no team would match it any more (idl/CMakeLists.txt).
TEST(Topics, DoNotDescribeTheirTypesOnTheNetwork) {
  for (const auto* topic :
       {&mirocup_v1_WorldState_desc, &mirocup_v1_TeamCommand_desc, &mirocup_v1_Hello_desc,
        &mirocup_v1_Welcome_desc, &mirocup_v1_MatchInfo_desc, &mirocup_v1_MatchEvent_desc}) {
    EXPECT_EQ(topic->m_flagset & DDS_TOPIC_XTYPES_METADATA, 0U) << topic->m_typename;
  }
}

}  // namespace
}  // namespace mirocup::dds
