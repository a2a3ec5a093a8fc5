// SPDX-License-Identifier: MIT
//
// A server's answer to programs that were built with the topics of v2. They write another Hello,
// which no reader of v3 matches, and would wait until they give up. So each seat has a reader for
// that Hello, and refuses it by a Welcome that such a program understands and shows.
#pragma once

#include "server/dds/entity.hpp"

#include <string>

namespace mirocup::dds {

class FormerClient {
 public:
  // `partition` is that of a team.
  Result<void> open(const Entity& participant, const std::string& partition);

  // Refuses the programs that have asked since the last call. Returns true the first time that one
  // has asked.
  bool refuse();

 private:
  Entity publisher_, subscriber_, hello_topic_, welcome_topic_;
  Entity hellos_, welcomes_;
  bool has_asked_ = false;
};

}  // namespace mirocup::dds
