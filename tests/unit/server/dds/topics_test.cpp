// SPDX-License-Identifier: MIT
//
// Pins what is on the network. Catches a layout that was changed without a new number: two
// processes of different layouts would read garbage from each other. And it catches topics that
// describe their types on the network: a forged announcement could add to the description of
// WorldState a part that no process has, and no team would match it any more (idl/CMakeLists.txt).
#include <dds/ddsi/ddsi_cdrstream.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <fstream>
#include <iterator>
#include <mirocup.h>
#include <string>

namespace mirocup::dds {
namespace {

// If one of these fails, you changed the layout: give LAYOUT_NUMBER in idl/mirocup.idl another
// number (or, for an incompatible change, the module), and then correct the numbers here. Programs
// in other languages rely on them.
static_assert(mirocup_v1_LAYOUT_NUMBER == 1);
static_assert(sizeof(mirocup_v1_RobotState) == 48);
static_assert(sizeof(mirocup_v1_TeamCounts) == 40);
static_assert(offsetof(mirocup_v1_WorldState, layout) == 0);
static_assert(offsetof(mirocup_v1_WorldState, tick) == 4);
static_assert(offsetof(mirocup_v1_WorldState, leg) == 8);
static_assert(offsetof(mirocup_v1_WorldState, state) == 32);
static_assert(offsetof(mirocup_v1_Hello, layout) == 0);
static_assert(offsetof(mirocup_v1_Welcome, layout) == 0);
static_assert(offsetof(mirocup_v1_MatchInfo, layout) == 0);
static_assert(offsetof(mirocup_v1_MatchEvent, layout) == 0);

// Returns the number of bytes of a sample that is all zero, as XCDR1 has them.
template <class Sample>
std::uint32_t bytes_of(const dds_topic_descriptor_t& type, const Sample& sample) {
  dds_ostreamLE_t stream;
  dds_ostreamLE_init(&stream, 0, 1);
  EXPECT_NE(dds_stream_writeLE(&stream, reinterpret_cast<const char*>(&sample), type.m_ops),
            nullptr);
  const std::uint32_t bytes = stream.x.m_index;
  dds_ostreamLE_fini(&stream);
  return bytes;
}

TEST(Topics, HaveTheSizesOfTheirLayout) {
  EXPECT_EQ(bytes_of(mirocup_v1_WorldState_desc, mirocup_v1_WorldState{}), 1260U);
  EXPECT_EQ(bytes_of(mirocup_v1_TeamCommand_desc, mirocup_v1_TeamCommand{}), 472U);
  EXPECT_EQ(bytes_of(mirocup_v1_Hello_desc, mirocup_v1_Hello{}), 21U);
  EXPECT_EQ(bytes_of(mirocup_v1_Welcome_desc, mirocup_v1_Welcome{}), 616U);
  EXPECT_EQ(bytes_of(mirocup_v1_MatchInfo_desc, mirocup_v1_MatchInfo{}), 616U);
  EXPECT_EQ(bytes_of(mirocup_v1_MatchEvent_desc, mirocup_v1_MatchEvent{}), 57U);
}

std::string text_of(const std::string& name) {
  std::ifstream file(std::string(MIROCUP_SOURCE_FOLDER) + "/idl/" + name);
  return {std::istreambuf_iterator<char>(file), {}};
}

// The number stands for the text of the IDL without comments and white space: for names, types and
// order, which the sizes do not tell.
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
  EXPECT_EQ(hash_of_text(text_of("mirocup.idl")), 18364874238391176012U)
      << "if a structure was changed, give LAYOUT_NUMBER another one; then correct this one";
}

// A WorldState is followed by the signatures of its readers. Measured: 56 bytes of RTPS headers and
// 4 of the encapsulation; 48 of the signature and 20 for each reader.
TEST(Topics, AStateFitsOneEthernetFrame) {
  constexpr std::uint32_t udp_payload = 1500 - 20 - 8;
  constexpr std::uint32_t rtps = 60, signature = 48, for_each_reader = 20, readers = 5;
  const std::uint32_t state = bytes_of(mirocup_v1_WorldState_desc, mirocup_v1_WorldState{});
  const std::uint32_t padded = (state + 3) / 4 * 4;
  EXPECT_LE(padded + rtps + signature + readers * for_each_reader, udp_payload);
}

TEST(Topics, DoNotDescribeTheirTypesOnTheNetwork) {
  for (const auto* topic :
       {&mirocup_v1_WorldState_desc, &mirocup_v1_TeamCommand_desc, &mirocup_v1_Hello_desc,
        &mirocup_v1_Welcome_desc, &mirocup_v1_MatchInfo_desc, &mirocup_v1_MatchEvent_desc}) {
    EXPECT_EQ(topic->m_flagset & DDS_TOPIC_XTYPES_METADATA, 0U) << topic->m_typename;
  }
}

}  // namespace
}  // namespace mirocup::dds
