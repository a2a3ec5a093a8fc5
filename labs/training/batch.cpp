// SPDX-License-Identifier: MIT
#include "labs/training/batch.hpp"

#include "plugins/host/floating_point.hpp"
#include "record/json_reader.hpp"

#include <algorithm>
#include <cfenv>
#include <mutex>
#include <optional>
#include <utility>

namespace mirocup::training {

namespace {

int threads_of(const Config& config) {
  const int processors = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  const int wanted = config.threads > 0 ? config.threads : processors;
  return std::min(wanted, config.matches);
}

template <class T>
T* row(T* buffer, int match, int size) {
  if (buffer == nullptr) return nullptr;
  return buffer + static_cast<std::ptrdiff_t>(match) * size;
}

// How often a thread looks for a change before it sleeps: some 50 us. A step of many matches
// follows the one before at once, and to be woken takes about as long.
constexpr int looks_before_sleep = 2000;

template <class T>
void wait_while(const std::atomic<T>& value, T old) {
  for (int i = 0; i < looks_before_sleep; ++i) {
    if (value.load(std::memory_order_acquire) != old) return;
#if defined(__x86_64__)
    __builtin_ia32_pause();
#elif defined(__aarch64__)
    asm volatile("yield");
#endif
  }
  value.wait(old, std::memory_order_acquire);
}

}  // namespace

Batch::Batch(Config config)
    : config_(std::move(config)),
      field_(field::make_field(config_.setup.league)),
      slots_(config_),
      observer_(config_, field_),
      workers_(threads_of(config_)) {
  const int slots = static_cast<int>(slots_.learners.size());
  sizes_ = {.size = sizeof sizes_,
            .matches = config_.matches,
            .slots = slots,
            .rows = config_.matches * slots,
            .robots = field_.robots_per_team,
            .observation = static_cast<int>(observer_.quantities().size()),
            .action = slots_.action,
            .terms = terms,
            .statistics = statistics,
            .threads = workers_.threads()};
  for (int i = 0; i < workers_.threads(); ++i) worlds_.push_back(make_world(config_.setup, field_));
  for (int i = 0; i < config_.matches; ++i) {
    const auto seed = static_cast<std::uint64_t>(i) + 1;
    matches_.push_back(std::make_unique<Match>(config_, slots_, observer_, seed));
  }
  spec_ = make_spec();
}

Rows Batch::rows_of(int match) const {
  const int slots = sizes_.slots;
  return {.actions = row(buffers_.actions, match, slots * sizes_.action),
          .observations = row(buffers_.observations, match, slots * sizes_.observation),
          .rewards = row(buffers_.rewards, match, slots),
          .terminations = row(buffers_.terminations, match, slots),
          .truncations = row(buffers_.truncations, match, slots),
          .final_observations = row(buffers_.final_observations, match, slots * sizes_.observation),
          .terms = row(buffers_.terms, match, slots * sizes_.terms),
          .statistics = row(buffers_.statistics, match, slots * sizes_.statistics)};
}

// Returns the error of the first match that has one.
Result<void> Batch::on_all(const Act& act) {
  std::mutex mutex;
  std::optional<std::pair<int, Error>> first;
  // What a thread takes at once: several pieces for each thread, so that none waits long for the
  // others, and matches enough that their rows fill whole cache lines.
  const int of_a_piece = std::clamp(sizes_.matches / (8 * sizes_.threads), 1, 32);
  const int pieces = (sizes_.matches + of_a_piece - 1) / of_a_piece;
  workers_.run(pieces, [&](int piece, int thread) {
    simulator::World& world = *worlds_[static_cast<std::size_t>(thread)];
    const int end = std::min(sizes_.matches, (piece + 1) * of_a_piece);
    for (int i = piece * of_a_piece; i < end; ++i) {
      const auto acted = act(i, world);
      if (acted) continue;
      const std::lock_guard lock(mutex);
      if (!first || i < first->first) first = {i, acted.error()};
    }
  });
  if (!first) return {};
  return fail(first->second.code,
              "match " + std::to_string(first->first) + ": " + first->second.what);
}

Result<void> Batch::reset(const std::uint8_t* mask, const std::uint64_t* seeds) {
  return on_all([&](int i, simulator::World& world) -> Result<void> {
    if (mask != nullptr && mask[i] == 0) return {};
    return matches_[static_cast<std::size_t>(i)]->reset(
        seeds == nullptr ? std::nullopt : std::optional(seeds[i]), rows_of(i), world);
  });
}

Result<void> Batch::step() {
  if (buffers_.actions == nullptr) return fail(Errc::input, "no buffer of actions is bound");
  return on_all([&](int i, simulator::World& world) -> Result<void> {
    Match& match = *matches_[static_cast<std::size_t>(i)];
    if (!match.has_started()) return fail(Errc::input, "the match has not been reset yet");
    return match.step(rows_of(i), config_.weights, world);
  });
}

Result<Match*> Batch::match(int number) const {
  if (number < 0 || number >= sizes_.matches) {
    return fail(Errc::input, "there is no match " + std::to_string(number) + ", only 0 to " +
                                 std::to_string(sizes_.matches - 1));
  }
  Match* match = matches_[static_cast<std::size_t>(number)].get();
  if (!match->has_started()) {
    return fail(Errc::input, "match " + std::to_string(number) + " has not been reset yet");
  }
  return match;
}

Result<match::Snapshot> Batch::snapshot(int number) const {
  MIROCUP_TRY(const auto found, match(number));
  return found->snapshot(*worlds_.front());
}

Result<void> Batch::record(int number, bool last, const std::string& path) const {
  MIROCUP_TRY(const auto found, match(number));
  if (!last) return save_record(config_, found->episode(), path);
  if (!found->last_episode()) {
    return fail(Errc::input, "no episode of match " + std::to_string(number) + " has ended yet");
  }
  return save_record(config_, *found->last_episode(), path);
}

Result<void> Batch::restore(int number, std::string_view copy) {
  if (number < 0 || number >= sizes_.matches) {
    return fail(Errc::input, "there is no match " + std::to_string(number));
  }
  Result<void> restored;
  workers_.run(1, [&](int, int thread) {
    restored = matches_[static_cast<std::size_t>(number)]->restore(
        copy, rows_of(number), *worlds_[static_cast<std::size_t>(thread)]);
  });
  return restored;
}

std::string Batch::make_spec() const {
  using Json = record::JsonReader::Json;
  Json observation = Json::array();
  for (const Quantity& q : observer_.quantities()) {
    observation.push_back(
        {{"name", q.name}, {"unit", q.unit}, {"scale", q.scale}, {"low", q.low}, {"high", q.high}});
  }
  Json slots = Json::array();
  for (const Learner& learner : slots_.learners) {
    Json robots = Json::array();
    for (int i = 0; i < field_.robots_per_team; ++i) {
      if (learner.robots[static_cast<std::size_t>(i)]) robots.push_back(i);
    }
    const std::string team(to_string(learner.team));
    const std::string name =
        config_.agents == Agents::team ? team : team + "_" + record::json_text(robots.front());
    slots.push_back({{"name", name}, {"team", team}, {"robots", robots}});
  }
  Json action = Json::array();
  for (int i = 0; i < slots_.action / 2; ++i) {
    const std::string robot = "robot_" + std::to_string(i) + "_";
    const bool drives = config_.action == ActionKind::drive;
    for (const char* part : {drives ? "forward" : "left", drives ? "turn" : "right"}) {
      action.push_back({{"name", robot + part},
                        {"unit", "rad/s"},
                        {"scale", config_.setup.parameters.wheel_speed_limit},
                        {"low", -1.0},
                        {"high", 1.0}});
    }
  }
  Json rewards = Json::array();
  for (int i = 0; i < terms; ++i) {
    const Term term = static_cast<Term>(i);
    rewards.push_back({{"name", to_string(term)},
                       {"unit", text_of(term).unit},
                       {"weight", config_.weights[static_cast<std::size_t>(i)]},
                       {"meaning", text_of(term).meaning}});
  }
  Json counted = Json::array();
  for (const std::string_view name : first_statistics) counted.push_back(name);
  for (const std::string_view name : enum_names<Term>) counted.push_back(name);
  const field::Field& f = field_;
  const simulator::Parameters& p = config_.setup.parameters;
  return record::json_text({{"schema", "mirocup/training-spec/1"},
                            {"league", to_string(config_.setup.league)},
                            {"control_period", config_.setup.control_period},
                            {"step_seconds", config_.setup.control_period * config_.ticks_per_step},
                            {"matches", sizes_.matches},
                            {"autoreset", to_string(config_.autoreset)},
                            {"agents", to_string(config_.agents)},
                            {"observation_kind", to_string(config_.observation)},
                            {"action_kind", to_string(config_.action)},
                            {"ticks_per_step", config_.ticks_per_step},
                            {"slots", slots},
                            {"observation", observation},
                            {"action", action},
                            {"rewards", rewards},
                            {"statistics", counted},
                            {"field",
                             {{"half_length", f.half_length},
                              {"half_width", f.half_width},
                              {"corner_leg", f.corner_leg},
                              {"goal_half_width", f.goal_half_width},
                              {"goal_depth", f.goal_depth},
                              {"goal_area_depth", f.goal_area.depth},
                              {"goal_area_half_width", f.goal_area.half_width},
                              {"centre_circle_radius", f.centre_circle_radius},
                              {"robots", f.robots_per_team}}},
                            {"bodies",
                             {{"robot_side", p.robot_side},
                              {"wheel_distance", p.wheel_distance},
                              {"wheel_radius", p.wheel_radius},
                              {"wheel_speed_limit", p.wheel_speed_limit},
                              {"ball_radius", p.ball_radius}}}},
                           1);
}

Workers::Workers(int threads) : shares_(static_cast<std::size_t>(threads)) {
  for (int i = 1; i < threads; ++i) others_.emplace_back([this, i] { wait_for_work(i); });
}

Workers::~Workers() {
  is_closing_ = true;
  runs_.fetch_add(1, std::memory_order_release);
  runs_.notify_all();
  for (std::thread& other : others_) other.join();
}

void Workers::run(int pieces, const DoPiece& do_piece) {
  const bool alone = others_.empty() || pieces <= 1;
  const int sharing = alone ? 1 : threads();
  for (int i = 0; i < threads(); ++i) {
    Share& share = shares_[static_cast<std::size_t>(i)];
    share.next.store(pieces * std::min(i, sharing) / sharing, std::memory_order_relaxed);
    share.end = pieces * std::min(i + 1, sharing) / sharing;
  }
  if (alone) return work(do_piece, 0);
  do_piece_ = &do_piece;
  busy_.store(static_cast<int>(others_.size()), std::memory_order_relaxed);
  runs_.fetch_add(1, std::memory_order_release);
  runs_.notify_all();
  work(do_piece, 0);
  for (int busy = busy_.load(std::memory_order_acquire); busy != 0;
       busy = busy_.load(std::memory_order_acquire)) {
    wait_while(busy_, busy);
  }
}

void Workers::wait_for_work(int thread) {
  for (std::uint32_t done = 0;; ++done) {
    wait_while(runs_, done);
    if (is_closing_) return;
    work(*do_piece_, thread);
    if (busy_.fetch_sub(1, std::memory_order_acq_rel) == 1) busy_.notify_one();
  }
}

void Workers::work(const DoPiece& do_piece, int thread) {
  // A library that was built with -Ofast may have changed the mode of the thread that loaded it.
  const plugins::FloatingPointGuard guard;
  std::fesetenv(FE_DFL_ENV);
  for (int i = 0; i < threads(); ++i) {
    Share& share = shares_[static_cast<std::size_t>((thread + i) % threads())];
    for (int piece = share.next++; piece < share.end; piece = share.next++) do_piece(piece, thread);
  }
}

}  // namespace mirocup::training
