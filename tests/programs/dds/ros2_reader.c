/* SPDX-License-Identifier: MIT
 *
 * Reads the topics of examples/ros2 as a node of ROS 2 with rmw_cyclonedds does: by the mangled
 * names, in the default partition, with rmw's default QoS and XCDR1 alone. Prints how many states
 * came, the last one's robots and ball, and the last event, when that ends the match.
 */
#include <dds/dds.h>

#include <mirocup_msgs.h>
#include <stdio.h>
#include <stdlib.h>

/* rmw_qos_profile_default: reliable, volatile, keep-last 10, everything else infinite. */
static dds_qos_t* rmw_qos_profile_default(void) {
  static const dds_data_representation_id_t xcdr1[] = {DDS_DATA_REPRESENTATION_XCDR1};
  dds_qos_t* qos = dds_create_qos();
  dds_qset_reliability(qos, DDS_RELIABILITY_RELIABLE, DDS_INFINITY);
  dds_qset_durability(qos, DDS_DURABILITY_VOLATILE);
  dds_qset_history(qos, DDS_HISTORY_KEEP_LAST, 10);
  dds_qset_deadline(qos, DDS_INFINITY);
  dds_qset_lifespan(qos, DDS_INFINITY);
  dds_qset_liveliness(qos, DDS_LIVELINESS_AUTOMATIC, DDS_INFINITY);
  dds_qset_data_representation(qos, 1, xcdr1);
  return qos;
}

static dds_entity_t reader_of(dds_entity_t node, const dds_topic_descriptor_t* type,
                              const char* name) {
  dds_qos_t* qos = rmw_qos_profile_default();
  const dds_entity_t topic = dds_create_topic(node, type, name, NULL, NULL);
  const dds_entity_t reader = dds_create_reader(node, topic, qos, NULL);
  dds_delete_qos(qos);
  if (reader < 0) exit(3);
  return reader;
}

int main(void) {
  const char* domain = getenv("ROS_DOMAIN_ID");
  const dds_entity_t node =
      dds_create_participant(domain != NULL ? (dds_domainid_t)atoi(domain) : 0, NULL, NULL);
  const dds_entity_t states =
      reader_of(node, &mirocup_msgs_msg_dds__WorldState__desc, "rt/mirocup/world_state");
  const dds_entity_t events =
      reader_of(node, &mirocup_msgs_msg_dds__MatchEvent__desc, "rt/mirocup/event");
  fprintf(stderr, "there\n");
  int count = 0, gaps = 0;
  unsigned last_tick = 0, robots = 0;
  double ball_x = 0.0;
  for (;;) {
    void* sample = NULL;
    dds_sample_info_t info;
    while (dds_take(states, &sample, &info, 1, 1) == 1) {
      const mirocup_msgs_msg_dds__WorldState_* state = sample;
      if (info.valid_data) {
        if (count++ > 0 && state->tick > last_tick + 1) ++gaps;
        last_tick = state->tick;
        robots = state->blue._length + state->yellow._length;
        ball_x = state->ball_x;
      }
      dds_return_loan(states, &sample, 1);
      sample = NULL;
    }
    while (dds_take(events, &sample, &info, 1, 1) == 1) {
      const mirocup_msgs_msg_dds__MatchEvent_* event = sample;
      const bool is_over = info.valid_data && event->ends_match;
      if (is_over) {
        printf("%d states, %d gaps, %u robots, ball %g, %s %s %d:%d\n", count, gaps, robots, ball_x,
               event->decision, event->reason, event->score_blue, event->score_yellow);
        fflush(stdout);
      }
      dds_return_loan(events, &sample, 1);
      sample = NULL;
      if (is_over) return 0;
    }
    dds_sleepfor(DDS_MSECS(2));
  }
}
