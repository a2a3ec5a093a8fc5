// SPDX-License-Identifier: MIT
//
// The C interface of libmirocup_training: no exception leaves it, and every error has a sentence.
#include "labs/training/batch.hpp"

#include <algorithm>
#include <cstring>
#include <dlfcn.h>
#include <exception>
#include <filesystem>
#include <memory>
#include <string>

using mirocup::Errc;
using mirocup::Error;
using mirocup::Result;
using mirocup::training::Batch;

struct mirocup_training {
  explicit mirocup_training(mirocup::training::Config config) : batch(std::move(config)) {}

  Batch batch;
  mutable std::string error;
};

namespace {

// The folder of this library, or of the program that it is a part of.
std::string own_folder() {
  Dl_info info{};
  if (dladdr(reinterpret_cast<const void*>(&mirocup_training_create), &info) == 0) return "";
  std::error_code none;
  const auto path = std::filesystem::canonical(info.dli_fname, none);
  return path.parent_path().string();
}

// Runs a call on a batch; keeps the sentence of its error, and returns the error's exit code.
template <class Call>
std::int32_t guarded(const mirocup_training* training, Call call) {
  try {
    const Result<void> result = call();
    if (result) return 0;
    training->error = result.error().what;
    return exit_code(result.error().code);
  } catch (const std::exception& e) {
    training->error = e.what();
  }
  return exit_code(Errc::host);
}

mirocup_training* create(const char* configuration) {
  auto config = mirocup::training::parse_config(configuration, own_folder());
  if (!config) throw std::runtime_error(config.error().what);
  return new mirocup_training(std::move(*config));
}

}  // namespace

uint32_t mirocup_training_version() {
  return MIROCUP_TRAINING_VERSION;
}

mirocup_training* mirocup_training_create(const char* configuration, char* error, size_t size) {
  try {
    return create(configuration);
  } catch (const std::exception& e) {
    if (size > 0) std::snprintf(error, size, "%s", e.what());
  }
  return nullptr;
}

void mirocup_training_destroy(mirocup_training* training) {
  delete training;
}

const mirocup_training_sizes* mirocup_training_get_sizes(const mirocup_training* training) {
  return &training->batch.sizes();
}

const char* mirocup_training_spec(const mirocup_training* training) {
  return training->batch.spec().c_str();
}

const char* mirocup_training_error(const mirocup_training* training) {
  return training->error.c_str();
}

std::int32_t mirocup_training_bind(mirocup_training* training,
                                   const mirocup_training_buffers* buffers) {
  return guarded(training, [&]() -> Result<void> {
    // Programs of an older header know fewer arrays, those of a newer one more.
    mirocup_training_buffers known{};
    if (buffers->size < sizeof buffers->size)
      return mirocup::fail(Errc::input, "bind(): `size` must be sizeof(mirocup_training_buffers)");
    std::memcpy(&known, buffers, std::min<std::size_t>(buffers->size, sizeof known));
    training->batch.bind(known);
    return {};
  });
}

std::int32_t mirocup_training_reset(mirocup_training* training, const uint8_t* mask,
                                    const uint64_t* seeds) {
  return guarded(training, [&] { return training->batch.reset(mask, seeds); });
}

std::int32_t mirocup_training_step(mirocup_training* training) {
  return guarded(training, [&] { return training->batch.step(); });
}

std::int32_t mirocup_training_set_weights(mirocup_training* training, const double* weights) {
  mirocup::training::Weights all{};
  std::copy_n(weights, all.size(), all.begin());
  training->batch.set_weights(all);
  return 0;
}

std::int32_t mirocup_training_bodies(const mirocup_training* training, std::int32_t match,
                                     double* bodies) {
  return guarded(training, [&]() -> Result<void> {
    MIROCUP_TRY(const auto now, training->batch.snapshot(match));
    double* to = bodies;
    const auto put = [&](const mirocup::match::ObservedRobot& r) {
      for (const double value :
           {r.position.x(), r.position.y(), r.heading, r.velocity.x(), r.velocity.y(), r.turn}) {
        *to++ = value;
      }
    };
    for (const auto& team : now.robots) {
      std::for_each_n(team.begin(), training->batch.sizes().robots, put);
    }
    put({.position = now.ball.position, .velocity = now.ball.velocity});
    return {};
  });
}

std::int32_t mirocup_training_record(mirocup_training* training, std::int32_t match,
                                     std::int32_t episode, const char* path) {
  return guarded(training, [&] {
    return training->batch.record(match, episode == MIROCUP_TRAINING_LAST_EPISODE, path);
  });
}

size_t mirocup_training_save(const mirocup_training* training, std::int32_t match, void* copy,
                             size_t size) {
  size_t needed = 0;
  guarded(training, [&]() -> Result<void> {
    MIROCUP_TRY(const auto found, training->batch.match(match));
    const std::string bytes = found->save();
    if (size >= bytes.size()) std::memcpy(copy, bytes.data(), bytes.size());
    needed = bytes.size();
    return {};
  });
  return needed;
}

std::int32_t mirocup_training_restore(mirocup_training* training, std::int32_t match,
                                      const void* copy, size_t size) {
  return guarded(training, [&] {
    return training->batch.restore(match, {static_cast<const char*>(copy), size});
  });
}
