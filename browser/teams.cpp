// SPDX-License-Identifier: MIT
#include "browser/teams.hpp"

#include "core/replay/recorded.hpp"
#include "plugins/abi/convert.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

extern "C" {
// The compiler renames the entry of each team (browser/CMakeLists.txt); the sources are unchanged.
const mirocup_strategy* mirocup_entry_idle(void);
const mirocup_strategy* mirocup_entry_chaser(void);
const mirocup_strategy* mirocup_entry_keeper(void);
const mirocup_strategy* mirocup_entry_striker(void);
const mirocup_strategy* mirocup_entry_navigator(void);
const mirocup_strategy* mirocup_entry_tactician(void);
const mirocup_strategy* mirocup_entry_planner(void);
const mirocup_strategy* mirocup_entry_drill_attacker(void);
const mirocup_strategy* mirocup_entry_drill_crowd(void);
const mirocup_strategy* mirocup_entry_drill_keeper(void);
}

namespace mirocup::browser {

namespace {

using Entry = const mirocup_strategy* (*)();
constexpr std::pair<std::string_view, Entry> entries[]{
    {"idle", mirocup_entry_idle},
    {"chaser", mirocup_entry_chaser},
    {"keeper", mirocup_entry_keeper},
    {"striker", mirocup_entry_striker},
    {"navigator", mirocup_entry_navigator},
    {"tactician", mirocup_entry_tactician},
    {"planner", mirocup_entry_planner},
    {"drill:attacker", mirocup_entry_drill_attacker},
    {"drill:crowd", mirocup_entry_drill_crowd},
    {"drill:keeper", mirocup_entry_drill_keeper}};

}  // namespace

const mirocup_strategy* house_team(std::string_view name) {
  for (const auto& [known, entry] : entries) {
    if (known == name) return entry();
  }
  return nullptr;
}

Driver::Driver(const match::Briefing& briefing, const mirocup_strategy* strategy,
               const replay::Recording* recording)
    : team_(briefing.team),
      strategy_(strategy),
      recording_(recording),
      setup_(abi::to_setup(briefing)) {
  give_host();
  if (strategy_ != nullptr) state_ = strategy_->create(&setup_);
}

template <match::ThoughtKind kind>
void Driver::draw(void* driver, const char* layer, std::uint32_t colour,
                  std::span<const double> numbers, std::string_view text) {
  auto& self = *static_cast<Driver*>(driver);
  if (!self.is_watched_ || !match::is_complete(kind, numbers.size()) || !match::is_finite(numbers))
    return;
  self.thoughts_ += self.line_.write(
      self.now_.tick,
      {.kind = kind, .colour = colour, .layer = layer, .numbers = numbers, .text = text});
}

void Driver::give_host() {
  using match::ThoughtKind;
  using Layer = const char*;
  using Colour = std::uint32_t;
  setup_.host = this;
  setup_.log = [](void*, const char*) {};
  setup_.parameter = [](void*, const char*, double fallback) { return fallback; };
  setup_.draw_line = [](void* to, Layer layer, Colour colour, double x1, double y1, double x2,
                        double y2) {
    draw<ThoughtKind::line>(to, layer, colour, std::array{x1, y1, x2, y2});
  };
  setup_.draw_circle = [](void* to, Layer layer, Colour colour, double x, double y, double r) {
    draw<ThoughtKind::circle>(to, layer, colour, std::array{x, y, r});
  };
  setup_.draw_polygon = [](void* to, Layer layer, Colour colour, const double* points,
                           std::int32_t corners) {
    draw<ThoughtKind::polygon>(to, layer, colour,
                               {points, 2 * static_cast<std::size_t>(std::max(corners, 0))});
  };
  setup_.draw_text = [](void* to, Layer layer, Colour colour, double x, double y,
                        const char* text) {
    draw<ThoughtKind::text>(to, layer, colour, std::array{x, y}, text);
  };
}

Driver::~Driver() {
  if (state_ != nullptr && strategy_->destroy != nullptr) strategy_->destroy(state_);
}

void Driver::post(const match::Observation& observation) {
  now_ = abi::to_observation(observation);
  thoughts_.clear();
}

match::Command Driver::own_command() {
  if (state_ == nullptr) {
    if (recording_ == nullptr || now_.tick >= recording_->ticks.size()) return {};
    return std::get<match::Command>(
        replay::recorded_answers(*recording_, now_.tick)[index_of(team_)]);
  }
  std::optional<match::PlacementRequest> poses;
  if (now_.placing != 0 && strategy_->place != nullptr) {
    mirocup_placement placement{};
    placement.ball_x = now_.ball_x;
    placement.ball_y = now_.ball_y;
    for (int i = 0; i < now_.robots; ++i) {
      placement.robots[i] = {now_.own[i].x, now_.own[i].y, now_.own[i].heading};
    }
    strategy_->place(state_, &now_, &placement);
    poses = abi::to_poses(placement);
  }
  mirocup_command decided{};
  strategy_->decide(state_, &now_, &decided);
  match::Command command = abi::to_command(decided);
  command.placement = poses;
  return command;
}

match::Answer Driver::collect() {
  match::Command command = own_command();
  for (std::size_t i = 0; i < by_hand_.size(); ++i) {
    if (by_hand_[i]) command.wheels[i] = *by_hand_[i];
  }
  return command;
}

}  // namespace mirocup::browser
