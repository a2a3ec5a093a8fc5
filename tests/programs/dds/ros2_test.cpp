// SPDX-License-Identifier: MIT
//
// The example that lets ROS 2 watch. Catches names, types, partitions or qualities of service that
// a node of ROS 2 does not match, and messages that are laid out in another way than the .msg files
// say.
#include "tests/programs/dds/network.hpp"

#include <gtest/gtest.h>

#include <map>

namespace mirocup {
namespace {

using namespace test_support;

TEST(Ros2, ANodeWithDefaultQosWatchesAMatch) {
  const std::string id = match_id("ros");
  const auto in_domain = [](const std::string& name, const std::vector<std::string>& arguments) {
    std::vector<std::string> command{"/usr/bin/env", "ROS_DOMAIN_ID=3", program(name)};
    command.insert(command.end(), arguments.begin(), arguments.end());
    return command;
  };
  Running node(in_domain("dds/ros2_reader", {}));
  Running bridge(in_domain("examples/mirocup_to_ros", {id, "127.0.0.1", "5"}));
  ASSERT_TRUE(has_said(node, "there"));
  Running match({program("mirocup"), "match", "--blue", "dds:ours", "--yellow", "idle", "--half",
                 "3", "--speed", "2", "--match", id, "--dds-domain", "5"});
  ASSERT_TRUE(is_there(bridge));
  auto team = join(id, "blue", "ours", "idle");
  team.insert(team.end(), {"--dds-domain", "5"});
  EXPECT_EQ(run(team).exit_code, 0);
  EXPECT_EQ(match.wait().exit_code, 0);
  EXPECT_EQ(bridge.wait().exit_code, 0);
  const Outcome seen = expect_exit(0, node.wait());
  EXPECT_TRUE(contains(seen.out, " 6 robots, ball "));
  EXPECT_TRUE(contains(seen.out, "MATCH_END full_time 0:0"));
  EXPECT_GT(std::stoi(seen.out), 100) << seen.out;
}

// Returns the members of a message, "type name" each, as the IDL would have them.
std::vector<std::string> members_of_message(const std::string& text) {
  const std::map<std::string, std::string> types{
      {"float64", "double"},
      {"bool", "boolean"},
      {"std_msgs/Header", "std_msgs::msg::dds_::Header_"},
      {"RobotState[<=11]", "sequence<mirocup_msgs::msg::dds_::RobotState_,11>"}};
  std::vector<std::string> members;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line.substr(0, line.find('#')));
    std::string type, name;
    if (!(words >> type >> name) || name.find('=') != std::string::npos) continue;
    members.push_back((types.count(type) != 0 ? types.at(type) : type) + " " + name);
  }
  return members;
}

std::vector<std::string> members_of_struct(const std::string& idl, const std::string& name) {
  const std::string begin = "struct " + name + " {\n";
  const std::size_t from = idl.find(begin);
  if (from == std::string::npos) return {};
  std::istringstream lines(
      idl.substr(from + begin.size(), idl.find("};", from) - from - begin.size()));
  std::vector<std::string> members;
  for (std::string line; std::getline(lines, line, ';');) {
    const std::size_t last = line.find_last_of(' ');
    if (last == std::string::npos) continue;
    std::string type = line.substr(0, last);
    type.erase(std::remove_if(type.begin(), type.end(), [](char c) { return std::isspace(c); }),
               type.end());
    members.push_back(type + line.substr(last));
  }
  return members;
}

TEST(Ros2, TheMessagesAreLaidOutAsTheirFilesSay) {
  const std::string folder = MIROCUP_SOURCE_FOLDER "/examples/ros2/";
  const std::string idl = read_file(folder + "mirocup_msgs.idl");
  for (const std::string name : {"RobotState", "WorldState", "MatchEvent"}) {
    const auto members =
        members_of_message(read_file(folder + "mirocup_msgs/msg/" + name + ".msg"));
    EXPECT_FALSE(members.empty()) << name;
    EXPECT_EQ(members, members_of_struct(idl, name + "_")) << name;
  }
}

}  // namespace
}  // namespace mirocup
