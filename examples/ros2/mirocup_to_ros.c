/* SPDX-License-Identifier: MIT
 *
 * Lets ROS 2 watch a match: reads the states and events of a match and writes them as the messages
 * of mirocup_msgs, on the topics /mirocup/world_state and /mirocup/event. It needs no ROS.
 * Usage: mirocup_to_ros MATCH [SERVER [DDS_DOMAIN]]; the ROS 2 domain is $ROS_DOMAIN_ID, or 0.
 *
 * It ends with the match. README.md says what ROS needs to see these topics.
 */
#include <dds/dds.h>

#include <mirocup.h>
#include <mirocup_msgs.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef mirocup_msgs_msg_dds__WorldState_ RosState;
typedef mirocup_msgs_msg_dds__MatchEvent_ RosEvent;
typedef mirocup_msgs_msg_dds__RobotState_ RosRobot;

static dds_entity_t need(dds_entity_t made, const char* what) {
  if (made >= 0) return made;
  fprintf(stderr, "mirocup_to_ros: %s: %s\n", what, dds_strretcode(made));
  exit(3);
}

static dds_qos_t* qos_of(bool reliable, bool late, int32_t depth) {
  dds_qos_t* qos = dds_create_qos();
  dds_qset_reliability(qos, reliable ? DDS_RELIABILITY_RELIABLE : DDS_RELIABILITY_BEST_EFFORT,
                       DDS_MSECS(100));
  dds_qset_durability(qos, late ? DDS_DURABILITY_TRANSIENT_LOCAL : DDS_DURABILITY_VOLATILE);
  dds_qset_history(qos, DDS_HISTORY_KEEP_LAST, depth);
  if (late) dds_qset_durability_service(qos, 0, DDS_HISTORY_KEEP_LAST, depth, -1, -1, -1);
  return qos;
}

/* The match servers of a host listen on ten ports of their domain. */
static void open_match_domain(const char* server, uint32_t domain) {
  const bool is_local = strncmp(server, "127.", 4) == 0;
  char peers[2048] = "", xml[4096];
  for (unsigned i = 0; i < 10; ++i) {
    char* end = peers + strlen(peers);
    snprintf(end, sizeof peers - (size_t)(end - peers), "<Peer Address=\"%.64s:%u\"/>", server,
             7410 + 250 * domain + 2 * i);
  }
  snprintf(xml, sizeof xml,
           "<CycloneDDS><Domain Id=\"any\"><General>%s<AllowMulticast>false</AllowMulticast>"
           "</General><Discovery><ParticipantIndex>none</ParticipantIndex><SPDPInterval>500ms"
           "</SPDPInterval><LeaseDuration>3s</LeaseDuration><Peers>%s</Peers></Discovery></Domain>"
           "</CycloneDDS>",
           is_local ? "<Interfaces><NetworkInterface name=\"lo\"/></Interfaces>" : "", peers);
  need(dds_create_domain(domain, xml), "the domain of the match");
}

static std_msgs_msg_dds__Header_ header(void) {
  const dds_time_t now = dds_time();
  return (std_msgs_msg_dds__Header_){
      {(int32_t)(now / DDS_NSECS_IN_SEC), (uint32_t)(now % DDS_NSECS_IN_SEC)}, (char*)"field"};
}

static void write_state(dds_entity_t writer, const mirocup_v1_WorldState* s) {
  RosState r = {.header = header(), .leg = s->leg, .tick = s->tick};
  r.time = s->time;
  r.clock = s->clock;
  r.state = (uint8_t)s->state;
  r.phase = (uint8_t)s->phase;
  r.restart = (uint8_t)s->restart;
  r.taker = (uint8_t)s->taker;
  r.left = (uint8_t)s->left;
  r.score_blue = s->score[0];
  r.score_yellow = s->score[1];
  r.ball_x = s->ball_x;
  r.ball_y = s->ball_y;
  r.ball_vx = s->ball_vx;
  r.ball_vy = s->ball_vy;
  /* RobotState_ has the members of mirocup's RobotState. */
  const uint32_t robots = s->robots <= mirocup_v1_MAX_ROBOTS ? s->robots : 0;
  r.blue._length = r.blue._maximum = r.yellow._length = r.yellow._maximum = robots;
  r.blue._buffer = (RosRobot*)s->blue;
  r.yellow._buffer = (RosRobot*)s->yellow;
  dds_write(writer, &r);
}

static void write_event(dds_entity_t writer, mirocup_v1_MatchEvent* e) {
  const RosEvent r = {header(),    e->leg, e->number, e->tick,     e->clock,   e->ends_match,
                      e->decision, e->law, e->reason, e->score[0], e->score[1]};
  dds_write(writer, &r);
}

int main(int argc, char** argv) {
  if (argc < 2 || argc > 4) {
    fprintf(stderr, "usage: mirocup_to_ros MATCH [SERVER [DDS_DOMAIN]]\n");
    return 2;
  }
  const char* ros_domain = getenv("ROS_DOMAIN_ID");
  const uint32_t from = argc > 3 ? (uint32_t)atoi(argv[3]) : 0;
  const uint32_t to = ros_domain != NULL ? (uint32_t)atoi(ros_domain) : 0;
  char partition[256];
  snprintf(partition, sizeof partition, "match-%s", argv[1]);

  open_match_domain(argc > 2 ? argv[2] : "127.0.0.1", from);
  const dds_entity_t match = need(dds_create_participant(from, NULL, NULL), "the match");
  dds_qos_t* in = dds_create_qos();
  dds_qset_partition1(in, partition);
  const dds_entity_t subscriber = need(dds_create_subscriber(match, in, NULL), "a subscriber");
  const dds_entity_t states =
      need(dds_create_reader(
               subscriber,
               dds_create_topic(match, &mirocup_v1_WorldState_desc, "WorldState", NULL, NULL),
               qos_of(false, false, 1), NULL),
           "WorldState");
  const dds_entity_t events =
      need(dds_create_reader(
               subscriber,
               dds_create_topic(match, &mirocup_v1_MatchEvent_desc, "MatchEvent", NULL, NULL),
               qos_of(true, true, 1000), NULL),
           "MatchEvent");

  /* A reader of ROS is reliable and volatile unless it asks for less or for more. */
  const dds_entity_t ros = need(dds_create_participant(to, NULL, NULL), "ROS 2");
  const dds_entity_t ros_states =
      need(dds_create_writer(ros,
                             dds_create_topic(ros, &mirocup_msgs_msg_dds__WorldState__desc,
                                              "rt/mirocup/world_state", NULL, NULL),
                             qos_of(true, false, 10), NULL),
           "rt/mirocup/world_state");
  const dds_entity_t ros_events =
      need(dds_create_writer(ros,
                             dds_create_topic(ros, &mirocup_msgs_msg_dds__MatchEvent__desc,
                                              "rt/mirocup/event", NULL, NULL),
                             qos_of(true, true, 1000), NULL),
           "rt/mirocup/event");

  const dds_entity_t wake = need(dds_create_waitset(match), "a waitset");
  dds_waitset_attach(wake, dds_create_readcondition(states, DDS_ANY_STATE), 0);
  dds_waitset_attach(wake, dds_create_readcondition(events, DDS_ANY_STATE), 0);
  bool is_over = false;
  while (!is_over) {
    dds_waitset_wait(wake, NULL, 0, DDS_SECS(1));
    mirocup_v1_WorldState state;
    mirocup_v1_MatchEvent event;
    void *at_state = &state, *at_event = &event;
    dds_sample_info_t info;
    while (dds_take(states, &at_state, &info, 1, 1) == 1) {
      if (info.valid_data && state.layout == mirocup_v1_LAYOUT_NUMBER)
        write_state(ros_states, &state);
    }
    while (dds_take(events, &at_event, &info, 1, 1) == 1) {
      if (!info.valid_data || event.layout != mirocup_v1_LAYOUT_NUMBER) continue;
      write_event(ros_events, &event);
      is_over = is_over || event.ends_match;
    }
  }
  dds_wait_for_acks(ros_events, DDS_SECS(1));
  return 0;
}
