// SPDX-License-Identifier: MIT
#include "server/dds/entity.hpp"

#include <memory>

namespace mirocup::dds {

namespace {

struct DeleteQos {
  void operator()(dds_qos_t* qos) const { dds_delete_qos(qos); }
};
using Qos = std::unique_ptr<dds_qos_t, DeleteQos>;

Qos qos_of(const idl::TopicQos& row) {
  Qos qos(dds_create_qos());
  dds_qset_reliability(qos.get(),
                       row.reliable ? DDS_RELIABILITY_RELIABLE : DDS_RELIABILITY_BEST_EFFORT,
                       DDS_MSECS(100));
  dds_qset_durability(qos.get(),
                      row.kept_for_late ? DDS_DURABILITY_TRANSIENT_LOCAL : DDS_DURABILITY_VOLATILE);
  if (row.depth > 0) {
    dds_qset_history(qos.get(), DDS_HISTORY_KEEP_LAST, row.depth);
  } else {
    dds_qset_history(qos.get(), DDS_HISTORY_KEEP_ALL, DDS_LENGTH_UNLIMITED);
  }
  if (row.kept_for_late) {
    dds_qset_durability_service(qos.get(), 0,
                                row.depth > 0 ? DDS_HISTORY_KEEP_LAST : DDS_HISTORY_KEEP_ALL,
                                row.depth > 0 ? row.depth : DDS_LENGTH_UNLIMITED,
                                DDS_LENGTH_UNLIMITED, DDS_LENGTH_UNLIMITED, DDS_LENGTH_UNLIMITED);
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
                          const idl::TopicQos& qos) {
  return created(dds_create_topic(participant.get(), &type, qos.name, qos_of(qos).get(), nullptr),
                 std::string("the topic ") + qos.name);
}

Result<Entity> make_writer(const Entity& publisher, const Entity& topic, const idl::TopicQos& qos) {
  return created(dds_create_writer(publisher.get(), topic.get(), qos_of(qos).get(), nullptr),
                 std::string("the writer of ") + qos.name);
}

Result<Entity> make_reader(const Entity& subscriber, const Entity& topic,
                           const idl::TopicQos& qos) {
  Qos with_limits = qos_of(qos);
  if (qos.most_samples > 0) {
    dds_qset_resource_limits(with_limits.get(), qos.most_samples, DDS_LENGTH_UNLIMITED,
                             DDS_LENGTH_UNLIMITED);
  }
  return created(dds_create_reader(subscriber.get(), topic.get(), with_limits.get(), nullptr),
                 std::string("the reader of ") + qos.name);
}

Result<void> keep(Entity& into, Result<Entity> made) {
  if (!made) return tl::unexpected(made.error());
  into = std::move(*made);
  return {};
}

}  // namespace mirocup::dds
