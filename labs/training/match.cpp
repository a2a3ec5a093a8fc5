// SPDX-License-Identifier: MIT
#include "labs/training/match.hpp"

#include "plugins/host/parameter_table.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>
#include <utility>

namespace mirocup::training {

namespace {

constexpr std::uint64_t endless = std::numeric_limits<std::uint64_t>::max();

std::uint64_t ticks_in(double seconds, double period) {
  const double ticks = std::nearbyint(seconds / period);
  if (!(ticks < 1e15)) return endless;
  return std::max<std::uint64_t>(1, static_cast<std::uint64_t>(ticks));
}

// The wheel speeds of one robot, rad/s, for two numbers of an action.
simulator::WheelSpeeds asked_wheels(ActionKind kind, const float* action,
                                    const simulator::Parameters& p) {
  constexpr double dead_zone = 0.05;  // m/s: rSoccer's
  const double a = action[0];
  const double b = action[1];
  const double limit = p.wheel_speed_limit;
  const auto wheel = [&](double share) { return limit * std::clamp(share, -1.0, 1.0); };
  if (!std::isfinite(a) || !std::isfinite(b)) return {a, b};  // the leg counts it
  if (kind == ActionKind::drive) return {wheel(a - b), wheel(a + b)};
  simulator::WheelSpeeds wheels{wheel(a), wheel(b)};
  if (kind == ActionKind::vss) {
    if (std::abs(wheels.left) * p.wheel_radius < dead_zone) wheels.left = 0.0;
    if (std::abs(wheels.right) * p.wheel_radius < dead_zone) wheels.right = 0.0;
  }
  return wheels;
}

constexpr double theta = 0.17;  // 1/s
constexpr double sigma = 0.5;   // 1/sqrt(s)

// Sets these draws apart from the other uses of a leg's seed.
constexpr std::uint64_t domain = 0x747261696e6f6973ULL;

}  // namespace

Slots::Slots(const Config& config) {
  for (const Team team : both_teams) {
    const std::vector<int>& robots = config.sides[index_of(team)].learners;
    if (robots.empty()) continue;
    Learner learner{.team = team, .robots = {}};
    for (const int robot : robots) {
      learner.robots.set(static_cast<std::size_t>(robot));
      if (config.agents == Agents::team) continue;
      learners.push_back(std::exchange(learner, Learner{.team = team, .robots = {}}));
    }
    if (config.agents == Agents::team) learners.push_back(learner);
  }
  action = 2 * static_cast<int>(learners.front().robots.count());
}

Match::Match(const Config& config, const Slots& slots, const Observer& observer, std::uint64_t seed)
    : config_(config),
      slots_(slots),
      observer_(observer),
      first_seed_(seed),
      max_play_ticks_(ticks_in(config.episode_s, config.setup.control_period)),
      measures_(slots.learners.size()) {}

std::uint64_t Match::next_seed() {
  const std::uint64_t episode = episodes_++;
  return episode == 0 ? first_seed_ : mix_seed(mix_seed(first_seed_) + episode);
}

std::unique_ptr<simulator::World> make_world(const match::Setup& setup, const field::Field& field) {
  return std::make_unique<simulator::World>(&field, setup.parameters, setup.tolerances,
                                            2 * field.robots_per_team, true);
}

Result<void> Match::reset(std::optional<std::uint64_t> seed, const Rows& rows,
                          simulator::World& world) {
  if (seed) {
    first_seed_ = *seed;
    episodes_ = 0;
  }
  auto started = start_episode(rows, world);
  lay_aside();
  return started;
}

Result<void> Match::start_episode(const Rows& rows, simulator::World& world) {
  if (leg_) last_ = std::move(episode_);
  if (auto begun = begin(next_seed(), world); !begun) return begun;
  if (config_.skips_stops) skip_stop();
  if (auto known = expect_known_parameters(); !known) return known;
  for (std::size_t i = 0; i < measures_.size(); ++i) {
    measures_[i] = {};
    measures_[i].meter.start(*leg_, slots_.learners[i]);
  }
  observe(rows.observations);
  write_no_rewards(rows);
  write_ends(rows);
  return {};
}

// Starts a leg and its teams.
Result<void> Match::begin(std::uint64_t seed, simulator::World& world) {
  counts_ = {};
  episode_ = {};
  episode_.seed = seed;
  const auto setup = setup_of(config_, seed);
  if (!setup) {
    leg_.reset();
    return tl::unexpected(setup.error());
  }
  if (shares_world()) {
    leg_.emplace(*setup, match::TickLogs::dropped, world);
  } else {
    leg_.emplace(*setup, match::TickLogs::dropped);
  }
  for (const Team team : both_teams) noise_[index_of(team)] = Noise(seed, team);
  return start_teams();
}

Result<void> Match::start_teams() {
  for (const Team team : both_teams) {
    const Side& side = config_.sides[index_of(team)];
    if (side.library.empty()) continue;
    teams_[index_of(team)].reset();
    auto started =
        plugins::TrustedController::load(side.library, leg_->briefing(team), side.parameters);
    if (!started) {
      return fail(Errc::unavailable, side.library + ": " + started.error().text);
    }
    teams_[index_of(team)] = std::move(*started);
  }
  return {};
}

// A name with a slip in it would have no effect. A team asks by the time play begins.
Result<void> Match::expect_known_parameters() const {
  for (const Team team : both_teams) {
    const Side& side = config_.sides[index_of(team)];
    if (side.library.empty()) continue;
    const auto unknown =
        plugins::not_asked_for(side.parameters, teams_[index_of(team)]->asked_parameters());
    if (unknown.empty()) continue;
    return fail(Errc::input, side.library + " asked for no parameter " + unknown.begin()->first);
  }
  return {};
}

void Match::take_up(simulator::World& world) {
  if (shares_world()) leg_->take_up(world);
}

void Match::lay_aside() {
  if (leg_ && shares_world()) leg_->lay_aside();
}

void Match::skip_stop() {
  while (!leg_->is_over() && leg_->state() == match::State::READY) play_tick({});
}

Result<void> Match::step(const Rows& rows, const Weights& weights, simulator::World& world) {
  take_up(world);
  auto played = play_step(rows, weights, world);
  lay_aside();
  return played;
}

match::Snapshot Match::snapshot(simulator::World& world) {
  take_up(world);
  const match::Snapshot now = leg_->snapshot();
  lay_aside();
  return now;
}

Result<void> Match::play_step(const Rows& rows, const Weights& weights, simulator::World& world) {
  if (is_done()) {
    if (config_.autoreset != Autoreset::disabled) return start_episode(rows, world);
    write_no_rewards(rows);
    return {};
  }
  const Commands commands = commands_of(rows.actions);
  const std::uint32_t begin = leg_->tick();
  // An action is for play or for a stop, in which robots stand: the step ends with either.
  const match::State state = leg_->state();
  const Commands played = state == match::State::PLAY ? commands : Commands{};
  for (int i = 0; i < config_.ticks_per_step; ++i) {
    play_tick(played);
    ++counts_.play_ticks;
    if (leg_->is_over() || leg_->state() != state || is_too_long()) break;
  }
  if (config_.skips_stops) skip_stop();
  ++counts_.steps;
  counts_.is_terminated = leg_->is_over();
  counts_.is_truncated = !counts_.is_terminated && is_too_long();
  write_rewards(rows, weights, leg_->tick() - begin);
  write_ends(rows);
  if (!is_done() || config_.autoreset != Autoreset::same_step) {
    observe(rows.observations);
    if (is_done()) write_statistics(rows.statistics);
    return {};
  }
  observe(rows.final_observations);
  write_statistics(rows.statistics);
  // The rewards and ends of the old episode stay in their buffers.
  return start_episode({.observations = rows.observations}, world);
}

void Match::play_tick(const Commands& commands) {
  const std::size_t decisions = leg_->decisions().size();
  const std::uint32_t tick = leg_->tick();
  std::optional<match::Snapshot> view;
  if (teams_[0] || teams_[1]) view.emplace(leg_->view());
  const match::ByTeam<match::Answer> answers{answer_of(Team::blue, commands[0], view),
                                             answer_of(Team::yellow, commands[1], view)};
  leg_->advance(answers);
  if (leg_->tick() == tick) {  // a team made a fault, which ended the leg
    episode_.faults = leg_->outcome().faults;
    return;
  }
  episode_.add_tick(*leg_);
  for (std::size_t i = 0; i < measures_.size(); ++i) {
    const Learner& learner = slots_.learners[i];
    measures_[i].meter.add_tick(*leg_, learner, commands[index_of(learner.team)].wheels, decisions);
  }
}

match::Answer Match::answer_of(Team team, const match::Command& learned,
                               const std::optional<match::Snapshot>& view) {
  const Side& side = config_.sides[index_of(team)];
  const int robots = leg_->field().robots_per_team;
  match::Answer answer;
  if (plugins::TrustedController* controller = teams_[index_of(team)].get()) {
    controller->post(match::observe(*view, team, robots));
    answer = controller->collect();
  } else if (static_cast<int>(side.learners.size()) < robots) {
    const match::Setup& setup = leg_->setup();
    answer = noise_[index_of(team)].next(robots, setup.control_period,
                                         setup.parameters.wheel_speed_limit);
  }
  if (auto* command = std::get_if<match::Command>(&answer)) {
    for (const int i : side.learners) {
      command->wheels[static_cast<std::size_t>(i)] = learned.wheels[static_cast<std::size_t>(i)];
    }
  }
  return answer;
}

Match::Commands Match::commands_of(const float* actions) const {
  Commands commands;
  const float* action = actions;
  for (const Learner& learner : slots_.learners) {
    match::Command& command = commands[index_of(learner.team)];
    for (int i = 0; i < leg_->field().robots_per_team; ++i) {
      const auto robot = static_cast<std::size_t>(i);
      if (!learner.robots[robot]) continue;
      command.wheels[robot] = asked_wheels(config_.action, action, config_.setup.parameters);
      action += 2;
    }
  }
  return commands;
}

void Match::observe(float* to) const {
  if (to == nullptr) return;
  const std::size_t size = observer_.quantities().size();
  for (const Learner& learner : slots_.learners) {
    const bool is_one =
        config_.agents == Agents::robot || config_.observation == ObservationKind::relative;
    int first = 0;
    while (is_one && !learner.robots[static_cast<std::size_t>(first)]) ++first;
    observer_.write(*leg_, learner.team, first, {to, size});
    to += size;
  }
}

void Match::write_rewards(const Rows& rows, const Weights& weights, std::uint32_t ticks) {
  const double seconds = ticks * config_.setup.control_period;
  for (std::size_t i = 0; i < measures_.size(); ++i) {
    Measures& measures = measures_[i];
    const Terms step = measures.meter.take_step(*leg_, slots_.learners[i], seconds);
    double reward = 0.0;
    for (std::size_t k = 0; k < step.size(); ++k) {
      reward += weights[k] * step[k];
      measures.sums[k] += step[k];
      if (rows.terms != nullptr) rows.terms[i * terms + k] = static_cast<float>(step[k]);
    }
    measures.total += reward;
    if (rows.rewards != nullptr) rows.rewards[i] = static_cast<float>(reward);
  }
}

void Match::write_no_rewards(const Rows& rows) const {
  if (rows.rewards != nullptr) std::fill_n(rows.rewards, measures_.size(), 0.0F);
  if (rows.terms != nullptr) std::fill_n(rows.terms, measures_.size() * terms, 0.0F);
}

void Match::write_ends(const Rows& rows) const {
  const auto fill = [&](std::uint8_t* to, bool is_end) {
    if (to != nullptr) std::fill_n(to, measures_.size(), is_end ? 1 : 0);
  };
  fill(rows.terminations, counts_.is_terminated);
  fill(rows.truncations, counts_.is_truncated);
}

void Match::write_statistics(float* to) const {
  if (to == nullptr) return;
  const auto put = [&](double value) { *to++ = static_cast<float>(value); };
  // By team first: g++ 12 at -O3 makes wrong indices of the ends inside the loop.
  const referee::ByEnd<int>& by_end = leg_->referee().score();
  const match::ByTeam<int> score{by_end[index_of(leg_->end_of(Team::blue))],
                                 by_end[index_of(leg_->end_of(Team::yellow))]};
  for (std::size_t i = 0; i < measures_.size(); ++i) {
    const Team team = slots_.learners[i].team;
    put(measures_[i].total);
    put(static_cast<double>(counts_.steps));
    put(leg_->tick() * config_.setup.control_period);
    put(score[index_of(team)]);
    put(score[index_of(opponent_of(team))]);
    for (const double sum : measures_[i].sums) put(sum);
  }
}

namespace {

// Values one after the other as bytes.
class Writer {
 public:
  template <class T>
  void add(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  template <class T>
  void add_all(const std::vector<T>& values) {
    static_assert(std::is_trivially_copyable_v<T>);
    add(values.size());
    bytes_.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
  }
  std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

class Reader {
 public:
  explicit Reader(std::string_view bytes) : bytes_(bytes) {}

  template <class T>
  void read(T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    if (!has(sizeof value)) return;
    std::memcpy(static_cast<void*>(&value), bytes_.data(), sizeof value);
    bytes_.remove_prefix(sizeof value);
  }
  template <class T>
  void read_all(std::vector<T>& values) {
    std::size_t count = 0;
    read(count);
    if (count > bytes_.size() / sizeof(T)) is_good_ = false;
    if (!is_good_) return;
    values.resize(count);
    if (count > 0) std::memcpy(static_cast<void*>(values.data()), bytes_.data(), count * sizeof(T));
    bytes_.remove_prefix(count * sizeof(T));
  }
  bool is_at_end() const { return is_good_ && bytes_.empty(); }

 private:
  bool has(std::size_t size) {
    is_good_ = is_good_ && bytes_.size() >= size;
    return is_good_;
  }
  std::string_view bytes_;
  bool is_good_ = true;
};

// A fault without its text.
struct SavedFault {
  Team team = Team::blue;
  match::FaultCode code = match::FaultCode::crash;
};

// The beginning of every copy: its layout, and a hash of the configuration that it belongs to.
std::uint64_t fingerprint(const Config& config) {
  StateHash hash(0x6d69726f74723031ULL);
  for (const char c : config.text)
    hash.add(static_cast<std::uint64_t>(static_cast<unsigned char>(c)));
  return hash.value();
}

}  // namespace

std::string Match::save() const {
  Writer to;
  to.add(fingerprint(config_));
  to.add(first_seed_);
  to.add(episodes_);
  to.add(counts_);
  to.add(episode_.seed);
  to.add_all(episode_.wheels);
  to.add_all(episode_.requests);
  std::vector<SavedFault> faults;
  for (const match::TeamFault& f : episode_.faults) faults.push_back({f.team, f.fault.code});
  to.add_all(faults);
  to.add_all(measures_);
  return to.take();
}

Result<void> Match::restore(std::string_view copy, const Rows& rows, simulator::World& world) {
  Reader from(copy);
  std::uint64_t belongs_to = 0;
  std::uint64_t first_seed = 0;
  std::uint64_t episodes = 0;
  Counts counts;
  Episode episode;
  std::vector<SavedFault> faults;
  std::vector<Measures> measures;
  from.read(belongs_to);
  if (belongs_to != fingerprint(config_)) {
    return fail(Errc::damaged, "the copy is that of a match with another configuration");
  }
  from.read(first_seed);
  from.read(episodes);
  from.read(counts);
  from.read(episode.seed);
  from.read_all(episode.wheels);
  from.read_all(episode.requests);
  from.read_all(faults);
  from.read_all(measures);
  if (!from.is_at_end() || measures.size() != measures_.size()) {
    return fail(Errc::damaged, "the copy of a match is not whole");
  }
  const auto begun = begin(episode.seed, world);
  if (!begun) {
    lay_aside();
    return begun;
  }
  first_seed_ = first_seed;
  episodes_ = episodes;
  const int robots = leg_->field().robots_per_team;
  const std::uint32_t ticks = episode.ticks(robots);
  while (!leg_->is_over() && leg_->tick() < ticks) {
    std::optional<match::Snapshot> view;
    if (teams_[0] || teams_[1]) view.emplace(leg_->view());
    // The teams are asked, so that they remember the same; what they answered is known.
    for (const Team team : both_teams) (void)answer_of(team, {}, view);
    leg_->advance(episode.answers(leg_->tick(), robots));
  }
  for (const SavedFault& f : faults) episode.faults.push_back({f.team, {f.code, ""}});
  if (!leg_->is_over() && !faults.empty()) leg_->forfeit(episode.faults);
  counts_ = counts;
  episode_ = std::move(episode);
  measures_ = std::move(measures);
  observe(rows.observations);
  write_ends(rows);
  lay_aside();
  return {};
}

Noise::Noise(std::uint64_t seed, Team team)
    : random_(mix_seed(mix_seed(seed ^ domain) + static_cast<unsigned>(index_of(team)))) {}

match::Command Noise::next(int robots, double period, double limit) {
  match::Command command;
  const double step = sigma * std::sqrt(period);
  for (int i = 0; i < robots; ++i) {
    const auto robot = static_cast<std::size_t>(i);
    for (double& x : share_[robot]) {
      x += -theta * x * period + step * match::cut_normal(random_);
    }
    command.wheels[robot] = {limit * std::clamp(share_[robot][0], -1.0, 1.0),
                             limit * std::clamp(share_[robot][1], -1.0, 1.0)};
  }
  return command;
}

}  // namespace mirocup::training
