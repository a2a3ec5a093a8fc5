// SPDX-License-Identifier: MIT
#include "server/dds/entity.hpp"

#include <algorithm>
#include <iterator>

namespace mirocup::dds {

namespace {

Qos qos_of(const idl::TopicQos& row, std::int32_t depth) {
  Qos qos(dds_create_qos());
  dds_qset_reliability(qos.get(),
                       row.reliable ? DDS_RELIABILITY_RELIABLE : DDS_RELIABILITY_BEST_EFFORT,
                       DDS_MSECS(100));
  dds_qset_durability(qos.get(),
                      row.kept_for_late ? DDS_DURABILITY_TRANSIENT_LOCAL : DDS_DURABILITY_VOLATILE);
  dds_qset_history(qos.get(), DDS_HISTORY_KEEP_LAST, depth);
  if (row.kept_for_late) {
    dds_qset_durability_service(qos.get(), 0, DDS_HISTORY_KEEP_LAST, depth, DDS_LENGTH_UNLIMITED,
                                DDS_LENGTH_UNLIMITED, DDS_LENGTH_UNLIMITED);
  }
  return qos;
}

Qos partition_qos(const std::string& partition) {
  Qos qos(dds_create_qos());
  dds_qset_partition1(qos.get(), partition.c_str());
  return qos;
}

}  // namespace

Result<Entity> created(dds_entity_t handle, const std::string& what) {
  if (handle > 0) return Entity(handle);
  if (handle == DDS_RETCODE_NOT_ALLOWED_BY_SECURITY) {
    return fail(Errc::input, "the credentials do not allow " + what + ": they are somebody else's");
  }
  return fail(Errc::unavailable, "DDS: " + what + " cannot be made: " + dds_strretcode(handle));
}

Result<Entity> make_publisher(const Entity& participant, const std::string& partition) {
  return created(dds_create_publisher(participant.get(), partition_qos(partition).get(), nullptr),
                 "the publisher of " + partition);
}

Result<Entity> make_subscriber(const Entity& participant, const std::string& partition) {
  return created(dds_create_subscriber(participant.get(), partition_qos(partition).get(), nullptr),
                 "the subscriber of " + partition);
}

Result<Entity> make_topic(const Entity& participant, const dds_topic_descriptor_t& type,
                          const idl::TopicQos& row) {
  return created(dds_create_topic(participant.get(), &type, row.name,
                                  qos_of(row, row.written_depth).get(), nullptr),
                 std::string("the topic ") + row.name);
}

Result<Entity> make_writer(const Entity& publisher, const Entity& topic, const idl::TopicQos& row) {
  return created(dds_create_writer(publisher.get(), topic.get(),
                                   qos_of(row, row.written_depth).get(), nullptr),
                 std::string("the writer of ") + row.name);
}

Result<Entity> make_reader(const Entity& subscriber, const Entity& topic,
                           const idl::TopicQos& row) {
  return created(
      dds_create_reader(subscriber.get(), topic.get(), qos_of(row, row.read_depth).get(), nullptr),
      std::string("the reader of ") + row.name);
}

Result<void> attach(const Entity& waitset, const Entity& reader) {
  // The condition belongs to the reader and is deleted with it.
  const dds_entity_t condition = dds_create_readcondition(reader.get(), DDS_ANY_STATE);
  const dds_return_t attached =
      condition > 0 ? dds_waitset_attach(waitset.get(), condition, 0) : condition;
  if (attached == DDS_RETCODE_OK) return {};
  return fail(Errc::unavailable,
              std::string("DDS: waiting for samples is not possible: ") + dds_strretcode(attached));
}

std::optional<ParticipantKey> participant_of(const Entity& reader, dds_instance_handle_t writer) {
  dds_builtintopic_endpoint_t* endpoint = dds_get_matched_publication_data(reader.get(), writer);
  if (endpoint == nullptr) return std::nullopt;
  ParticipantKey key{};
  std::copy(std::begin(endpoint->participant_key.v), std::end(endpoint->participant_key.v),
            key.begin());
  dds_builtintopic_free_endpoint(endpoint);
  return key;
}

}  // namespace mirocup::dds
