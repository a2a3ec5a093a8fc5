// SPDX-License-Identifier: MIT
#include "server/dds/former_client.hpp"

#include "server/dds/convert.hpp"

#include <mirocup_former.h>

namespace mirocup::dds {

Result<void> FormerClient::open(const Entity& participant, const std::string& partition) {
  return keep(publisher_, make_publisher(participant, partition))
      .and_then([&] { return keep(subscriber_, make_subscriber(participant, partition)); })
      .and_then([&] {
        return keep(hello_topic_, make_topic(participant, mirocup_v2_Hello_desc, idl::hello));
      })
      .and_then([&] {
        return keep(welcome_topic_, make_topic(participant, mirocup_v2_Welcome_desc, idl::welcome));
      })
      .and_then([&] { return keep(hellos_, make_reader(subscriber_, hello_topic_, idl::hello)); })
      .and_then(
          [&] { return keep(welcomes_, make_writer(publisher_, welcome_topic_, idl::welcome)); });
}

bool FormerClient::refuse() {
  constexpr std::uint8_t refused = 2;
  bool is_first = false;
  mirocup_v2_Hello hello;
  while (take(hellos_, hello)) {
    mirocup_v2_Welcome welcome{};
    welcome.team = hello.team;
    welcome.nonce = hello.nonce;
    welcome.answer = refused;
    copy_text(welcome.reason,
              "you speak v2 of the topics, the match server v3: use the mirocup or "
              "libmirocup_team of the match server's version");
    dds_write(welcomes_.get(), &welcome);
    is_first = is_first || !has_asked_;
    has_asked_ = true;
  }
  return is_first;
}

}  // namespace mirocup::dds
