// SPDX-License-Identifier: MIT
//
// A team in the server's own process (`--trusted`): without protection from it, and without cost.
#pragma once

#include "plugins/host/plugin.hpp"

#include <memory>

namespace mirocup::plugins {

class TrustedController final : public match::Controller {
 public:
  // Loads the library at `path`, which must contain a slash, and creates its team.
  static tl::expected<std::unique_ptr<TrustedController>, match::Fault> load(
      const std::string& path, const match::Briefing& briefing);

  void post(const match::Observation& observation) override;
  match::Answer collect() override;

 private:
  TrustedController(std::unique_ptr<mirocup_setup> setup, Plugin plugin);

  std::unique_ptr<mirocup_setup> setup_;
  Plugin plugin_;
  mirocup_observation observation_{};
};

}  // namespace mirocup::plugins
