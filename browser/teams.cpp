// SPDX-License-Identifier: MIT
#include "browser/teams.hpp"

#include "core/replay/recorded.hpp"
#include "plugins/abi/convert.hpp"
#include "plugins/abi/drawing.hpp"

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

void Driver::draw(void* driver, const match::Thought& shape) {
  auto& self = *static_cast<Driver*>(driver);
  if (!self.is_watched_ || !match::is_complete(shape.kind, shape.numbers.size()) ||
      !match::is_finite(shape.numbers))
    return;
  self.thoughts_ += self.line_.write(self.now_.tick, shape);
}

void Driver::give_host() {
  setup_.host = this;
  setup_.log = [](void*, const char*) {};
  setup_.parameter = [](void*, const char*, double fallback) { return fallback; };
  abi::give_drawing<draw>(setup_);
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
