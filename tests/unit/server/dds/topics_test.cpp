// SPDX-License-Identifier: MIT
//
// Catches topics that describe their types on the network: there anybody can add to the description
// of WorldState a part that nobody has, and no team is matched with it any more (idl/CMakeLists.txt).
#include <gtest/gtest.h>

#include <mirocup.h>

namespace mirocup::dds {
namespace {

TEST(Topics, AreToldApartByTheNamesOfTheirTypesAlone) {
  for (const auto* topic :
       {&mirocup_v2_WorldState_desc, &mirocup_v2_TeamCommand_desc, &mirocup_v2_Hello_desc,
        &mirocup_v2_Welcome_desc, &mirocup_v2_MatchEvent_desc}) {
    EXPECT_EQ(topic->m_flagset & DDS_TOPIC_XTYPES_METADATA, 0U) << topic->m_typename;
  }
}

}  // namespace
}  // namespace mirocup::dds
