// SPDX-License-Identifier: MIT
#include "web/http/entrance.hpp"

#include <algorithm>
#include <sys/resource.h>
#include <thread>

namespace mirocup::web {

namespace {

using namespace std::chrono_literals;

constexpr int for_each_processor = 256;
constexpr int most_connections = 1024;
constexpr auto slow_answer = 5s;  // after which an answer may give way

}  // namespace

int connection_capacity() {
  const int processors = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  int most = std::min(for_each_processor * processors, most_connections);
  rlimit files{};
  if (getrlimit(RLIMIT_NOFILE, &files) == 0 && files.rlim_cur / 2 < static_cast<rlim_t>(most))
    most = static_cast<int>(files.rlim_cur / 2);
  return most;
}

// Returns the number of guests for which matches(guest) is true.
int Entrance::count(auto matches) const {
  return static_cast<int>(
      std::ranges::count_if(guests_, [&](const auto& one) { return matches(one.second); }));
}

int Entrance::present(const std::string* address) const {
  return count([&](const Guest& guest) {
    return guest.stage != Stage::leaving && (address == nullptr || guest.address == *address);
  });
}

int Entrance::streams() const {
  return count([](const Guest& guest) { return guest.stage == Stage::streaming; });
}

int Entrance::count(const std::string& address, Stage stage) const {
  return count([&](const Guest& g) { return g.address == address && g.stage == stage; });
}

bool Entrance::has_many(const std::string& address) const {
  return count(address, Stage::streaming) >= limits_.many_streams ||
         present(&address) >= limits_.many_connections;
}

// Among the connections of an address (null: of all) that are in a stage since `before` or longer,
// lets the oldest give way. Returns false if there is none.
bool Entrance::let_oldest_go(Stage stage, Instant before, const std::string* address) {
  auto oldest = guests_.end();
  for (auto one = guests_.begin(); one != guests_.end(); ++one) {
    const Guest& guest = one->second;
    if (guest.stage != stage || guest.since > before ||
        (address != nullptr && guest.address != *address))
      continue;
    if (oldest == guests_.end() || guest.since < oldest->second.since) oldest = one;
  }
  if (oldest == guests_.end()) return false;
  oldest->second.stage = Stage::leaving;
  given_way_.push_back(oldest->first);
  return true;
}

bool Entrance::make_room(Instant now) {
  return let_oldest_go(Stage::waiting, now) || let_oldest_go(Stage::receiving, now) ||
         let_oldest_go(Stage::answering, now - slow_answer);
}

Stage Entrance::arrive(int connection, const std::string& address, Instant now) {
  Guest guest{.address = address, .since = now};
  if (is_crowded() && !address.empty() && has_many(address)) {
    if (count(address, Stage::answering) >= limits_.at_once &&
        !let_oldest_go(Stage::answering, now - slow_answer, &address)) {
      if (count(address, Stage::waiting) >= limits_.most_waiting) return Stage::leaving;
      guest.stage = Stage::waiting;
      guest.has_entered = false;
    } else if (count(address, Stage::receiving) >= limits_.most_arriving) {
      // Its own, since a neighbour behind the same address may have made the others.
      let_oldest_go(Stage::receiving, now, &address);
    }
  }
  // Nobody gives way to a connection that would only wait.
  if (present() >= limits_.capacity && (guest.stage == Stage::waiting || !make_room(now)))
    return Stage::leaving;
  return guests_.insert_or_assign(connection, std::move(guest)).first->second.stage;
}

void Entrance::name(int connection, const std::string& address) {
  guests_.at(connection).address = address;
}

void Entrance::set_stage(int connection, Stage stage, Instant now) {
  Guest& guest = guests_.at(connection);
  if (guest.stage == Stage::leaving) return;
  guest.stage = stage;
  guest.since = now;
}

bool Entrance::begin_stream(int connection, bool is_for_known, Instant now) {
  Guest& guest = guests_.at(connection);
  if (guest.stage == Stage::leaving) return false;
  // A quarter is for pages and files; strangers leave another quarter to teams.
  if (streams() >= limits_.capacity * 3 / 4) return false;
  if (!is_for_known) {
    const int strangers =
        count([](const Guest& g) { return g.stage == Stage::streaming && !g.is_known; });
    if (strangers >= limits_.capacity / 2) return false;
    if (is_crowded() && count(guest.address, Stage::streaming) >= limits_.many_streams)
      return false;
  }
  guest.is_known = is_for_known;
  set_stage(connection, Stage::streaming, now);
  return true;
}

void Entrance::leave(int connection) {
  guests_.erase(connection);
  std::erase(given_way_, connection);
}

std::vector<int> Entrance::all() const {
  std::vector<int> all;
  for (const auto& [connection, guest] : guests_) all.push_back(connection);
  return all;
}

std::vector<int> Entrance::let_in(Instant now) {
  std::vector<int> may_enter;
  while (true) {
    auto first = guests_.end();
    for (auto one = guests_.begin(); one != guests_.end(); ++one) {
      if (one->second.stage != Stage::waiting ||
          (is_crowded() &&
           count(one->second.address, Stage::answering) + static_cast<int>(may_enter.size()) >=
               limits_.at_once))
        continue;
      if (first == guests_.end() || one->second.since < first->second.since) first = one;
    }
    if (first == guests_.end()) return may_enter;
    first->second.stage = Stage::receiving;
    first->second.has_entered = true;
    first->second.since = now;
    may_enter.push_back(first->first);
  }
}

std::vector<int> Entrance::to_end(Instant now) {
  std::vector<int> ending = std::move(given_way_);
  given_way_.clear();
  const auto most = is_crowded() ? limits_.request_time_if_crowded : limits_.request_time;
  for (auto& [connection, guest] : guests_) {
    const auto time = now - guest.since;
    if ((guest.stage == Stage::waiting && time > limits_.longest_wait) ||
        (guest.stage == Stage::receiving && time > most)) {
      guest.stage = Stage::leaving;
      ending.push_back(connection);
    }
  }
  return ending;
}

}  // namespace mirocup::web
