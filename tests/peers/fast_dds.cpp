// SPDX-License-Identifier: MIT
//
// A team over DDS as server/dds/README.md tells it, with eProsima's Fast DDS in place of Cyclone:
// its robots chase the ball. Usage: fast_dds MATCH COLOUR NAME. It prints how many ticks it
// answered; exit code 0 when the match has ended, 3 without a seat within 30 s.
#include "mirocupPubSubTypes.h"

#include <chrono>
#include <cmath>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <fastrtps/utils/IPLocator.h>
#include <iostream>
#include <memory>
#include <random>
#include <string>

using namespace eprosima::fastdds::dds;
using eprosima::fastrtps::Duration_t;
using eprosima::fastrtps::rtps::IPLocator;
using eprosima::fastrtps::rtps::Locator_t;
namespace idl = mirocup::v1;

namespace {

constexpr double pi = 3.14159265358979323846;

// Discovery is a star on this host: the server's ten places are asked, and nothing is multicast.
DomainParticipant* join_network() {
  DomainParticipantQos qos;
  const auto udp = std::make_shared<eprosima::fastdds::rtps::UDPv4TransportDescriptor>();
  udp->interfaceWhiteList.push_back("127.0.0.1");
  udp->maxMessageSize = 1472;
  qos.transport().use_builtin_transports = false;  // that has shared memory
  qos.transport().user_transports.push_back(udp);
  auto& wire = qos.wire_protocol();
  wire.builtin.avoid_builtin_multicast = true;
  wire.builtin.discovery_config.leaseDuration = Duration_t(3, 0);
  wire.builtin.discovery_config.leaseDuration_announcementperiod = Duration_t(0, 500000000);
  Locator_t here;
  IPLocator::setIPv4(here, "127.0.0.1");
  wire.builtin.metatrafficUnicastLocatorList.push_back(here);
  wire.default_unicast_locator_list.push_back(here);
  for (unsigned i = 0; i < 10; ++i) {
    here.port = 7410 + 2 * i;
    wire.builtin.initialPeersList.push_back(here);
  }
  return DomainParticipantFactory::get_instance()->create_participant(0, qos);
}

// The qualities of the table: reliable topics are transient local, the others volatile.
template <class Qos>
Qos quality(Qos qos, bool reliable, int depth) {
  qos.reliability().kind = reliable ? RELIABLE_RELIABILITY_QOS : BEST_EFFORT_RELIABILITY_QOS;
  qos.durability().kind = reliable ? TRANSIENT_LOCAL_DURABILITY_QOS : VOLATILE_DURABILITY_QOS;
  qos.history().kind = KEEP_LAST_HISTORY_QOS;
  qos.history().depth = depth;
  return qos;
}

Topic* topic(DomainParticipant* in, TopicDataType* of, const char* name) {
  TypeSupport type(of);
  type->auto_fill_type_information(false);
  type->auto_fill_type_object(false);
  type.register_type(in);
  return in->create_topic(name, type.get_type_name(), TOPIC_QOS_DEFAULT);
}

// Wheels towards the ball, backwards where that is shorter. Own frame, which attacks +x.
void chase(const idl::WorldState& s, bool is_yellow, idl::TeamCommand& command) {
  const bool is_turned = s.left() != (is_yellow ? idl::COLOUR_YELLOW : idl::COLOUR_BLUE);
  const double sign = is_turned ? -1.0 : 1.0;
  const auto& own = is_yellow ? s.yellow() : s.blue();
  for (int i = 0; i < s.robots(); ++i) {
    const double x = sign * (s.ball_x() - own[i].x()), y = sign * (s.ball_y() - own[i].y());
    double turn =
        std::remainder(std::atan2(y, x) - own[i].heading() - (is_turned ? pi : 0.0), 2.0 * pi);
    double forward = 25.0;
    if (std::abs(turn) > pi / 2.0) {
      turn = std::remainder(turn + pi, 2.0 * pi);
      forward = -forward;
    }
    command.left()[i] = forward * std::cos(turn) - 8.0 * turn;
    command.right()[i] = forward * std::cos(turn) + 8.0 * turn;
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  const std::string match = std::string("match-") + argv[1], colour = argv[2], name = argv[3];
  const bool is_yellow = colour == "yellow";
  DomainParticipant* network = join_network();
  if (network == nullptr) return 2;
  SubscriberQos all, own;
  PublisherQos to_server;
  all.partition().push_back(match.c_str());
  own.partition().push_back((match + "/" + colour + "/" + name).c_str());
  to_server.partition() = own.partition();
  Subscriber* public_ones = network->create_subscriber(all);
  Subscriber* mine = network->create_subscriber(own);
  Publisher* out = network->create_publisher(to_server);
  const auto read = [&](Subscriber* by, TopicDataType* type, const char* of, bool reliable, int n) {
    return by->create_datareader(topic(network, type, of), quality(DataReaderQos(), reliable, n));
  };
  const auto write = [&](TopicDataType* type, const char* of, bool reliable) {
    return out->create_datawriter(topic(network, type, of), quality(DataWriterQos(), reliable, 1));
  };
  DataReader* states = read(public_ones, new idl::WorldStatePubSubType, "WorldState", false, 1);
  DataReader* events = read(public_ones, new idl::MatchEventPubSubType, "MatchEvent", true, 1000);
  DataReader* welcomes = read(mine, new idl::WelcomePubSubType, "Welcome", true, 16);
  DataWriter* hellos = write(new idl::HelloPubSubType, "Hello", true);
  DataWriter* commands = write(new idl::TeamCommandPubSubType, "TeamCommand", false);

  idl::Hello hello;
  hello.layout(idl::LAYOUT_NUMBER);
  hello.team(is_yellow ? idl::COLOUR_YELLOW : idl::COLOUR_BLUE);
  hello.nonce((static_cast<std::uint64_t>(std::random_device{}()) << 32) | 1);
  hello.name(name.c_str());
  idl::Welcome welcome;
  idl::MatchEvent event;
  idl::WorldState state;
  idl::TeamCommand command;
  SampleInfo info;
  bool is_seated = false;
  long answers = 0;
  const auto is_taken = [&](DataReader* reader, void* to) {
    return reader->take_next_sample(to, &info) == ReturnCode_t::RETCODE_OK;
  };
  const auto begun = std::chrono::steady_clock::now();
  for (int i = 0;; ++i) {
    if (!is_seated && i % 10 == 0) hellos->write(&hello);
    if (!is_seated && std::chrono::steady_clock::now() - begun > std::chrono::seconds(30)) return 3;
    while (is_taken(welcomes, &welcome)) {
      is_seated = is_seated || (info.valid_data && welcome.nonce() == hello.nonce() &&
                                welcome.answer() == idl::ADMISSION_ACCEPTED);
    }
    while (is_taken(events, &event)) {
      if (!info.valid_data || !event.ends_match()) continue;
      std::cout << answers << " answers\n";
      return 0;
    }
    bool is_new = false;
    while (is_taken(states, &state)) is_new = is_new || info.valid_data;
    if (!is_new) {
      states->wait_for_unread_message(Duration_t(0, 20000000));
    } else if (is_seated && state.leg() == welcome.leg() && state.state() != idl::STATE_END) {
      command.nonce(hello.nonce());
      command.tick(state.tick());
      command.team(hello.team());
      chase(state, is_yellow, command);
      commands->write(&command);
      ++answers;
    }
  }
}
