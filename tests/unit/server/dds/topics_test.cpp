// SPDX-License-Identifier: MIT
//
// Catches topics that describe their types on the network: a forged announcement could add to the
// description of WorldState a part that no process has, and no team would match it any more
// (idl/CMakeLists.txt).
#include <gtest/gtest.h>

#include <mirocup.h>

namespace mirocup::dds {
namespace {

TEST(Topics, DoNotDescribeTheirTypesOnTheNetwork) {
  for (const auto* topic :
       {&mirocup_v2_WorldState_desc, &mirocup_v2_TeamCommand_desc, &mirocup_v2_Hello_desc,
        &mirocup_v2_Welcome_desc, &mirocup_v2_MatchEvent_desc}) {
    EXPECT_EQ(topic->m_flagset & DDS_TOPIC_XTYPES_METADATA, 0U) << topic->m_typename;
  }
}

}  // namespace
}  // namespace mirocup::dds
