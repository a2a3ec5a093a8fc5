// SPDX-License-Identifier: MIT
//
// DDS entities that delete themselves, and functions that make entities with the QoS in a topic's
// row of idl/qos.hpp. A class that owns entities declares parents before children, so that children
// are deleted first.
#pragma once

#include "core/base/error.hpp"
#include "idl/qos.hpp"

#include <dds/dds.h>

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace mirocup::dds {

// Owns one DDS entity.
class Entity {
 public:
  Entity() = default;
  explicit Entity(dds_entity_t handle) : handle_(handle) {}
  Entity(Entity&& other) noexcept : handle_(std::exchange(other.handle_, 0)) {}
  Entity& operator=(Entity&& other) noexcept {
    if (this != &other) {
      reset();
      handle_ = std::exchange(other.handle_, 0);
    }
    return *this;
  }
  ~Entity() { reset(); }

  dds_entity_t get() const { return handle_; }
  void reset() {
    if (handle_ > 0) dds_delete(handle_);
    handle_ = 0;
  }
  void abandon() { handle_ = 0; }  // the entity then lives until the process ends

 private:
  dds_entity_t handle_ = 0;
};

struct DeleteQos {
  void operator()(dds_qos_t* qos) const { dds_delete_qos(qos); }
};
using Qos = std::unique_ptr<dds_qos_t, DeleteQos>;

// Converts the result of a dds_create function to an entity or an error. `what` names the entity in
// the error.
Result<Entity> created(dds_entity_t handle, const std::string& what);

Result<Entity> make_publisher(const Entity& participant, const std::string& partition);
Result<Entity> make_subscriber(const Entity& participant, const std::string& partition);
Result<Entity> make_topic(const Entity& participant, const dds_topic_descriptor_t& type,
                          const idl::TopicQos& row);
Result<Entity> make_writer(const Entity& publisher, const Entity& topic, const idl::TopicQos& row);
Result<Entity> make_reader(const Entity& subscriber, const Entity& topic, const idl::TopicQos& row);

// Attaches a reader to a waitset, which then wakes while the reader has samples.
Result<void> attach(const Entity& waitset, const Entity& reader);

// Identifies the process of a writer: DDS gives every participant a different key.
using ParticipantKey = std::array<std::uint8_t, 16>;

// Returns the key of the process of a writer, or nothing if the reader is not matched with that
// writer at this moment.
std::optional<ParticipantKey> participant_of(const Entity& reader, dds_instance_handle_t writer);

// Takes the next valid sample. Returns false if no valid sample is there. `writer` becomes the
// handle of the sample's writer.
template <class Sample>
bool take(const Entity& reader, Sample& sample, dds_instance_handle_t* writer = nullptr) {
  while (true) {
    void* into = &sample;
    dds_sample_info_t info;
    if (dds_take(reader.get(), &into, &info, 1, 1) <= 0) return false;
    if (!info.valid_data) continue;
    if (writer != nullptr) *writer = info.publication_handle;
    return true;
  }
}

}  // namespace mirocup::dds
