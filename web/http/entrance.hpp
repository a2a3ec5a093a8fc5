// SPDX-License-Identifier: MIT
//
// Decides which connections enter, wait or give way if many come. It only counts: the server owns
// the sockets, whose numbers name the connections.
//
// As long as at most half of the capacity is taken, everybody may enter. Above that, an address
// that has many streams or connections waits: its further requests are served a few at a time, and
// it gets no further stream. Its earlier connections stay. If no capacity is left, the oldest
// request that has not arrived completely gives way.
//
// Threads: one at a time.
#pragma once

#include <chrono>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace mirocup::web {

using Instant = std::chrono::steady_clock::time_point;

struct EntranceLimits {
  int capacity = 256;         // connections in all
  int many_streams = 8;       // of an address
  int many_connections = 32;  // of an address
  int at_once = 4;            // served requests of an address that has many connections
  int most_waiting = 32;      // connections of an address
  std::chrono::milliseconds longest_wait{5000};
  std::chrono::milliseconds request_time{10'000};
  std::chrono::milliseconds request_time_if_crowded{2000};
};

// 256 connections for each processor, at most 1024, and at most half of the files that this process
// may open.
int connection_capacity();

enum class Stage {
  waiting,    // until its address has fewer requests
  receiving,  // the head of its request has not arrived
  answering,
  uploading,  // it was asked for its body
  streaming,
  leaving,  // it gave way, and its thread is about to end
};

class Entrance {
 public:
  explicit Entrance(EntranceLimits limits) : limits_(limits) {}

  // A connection has come. Returns the stage in which it begins, or Stage::leaving if it is
  // refused.
  Stage arrive(int connection, const std::string& address, Instant now);

  // Sets the address of the viewer for whom a proxy has made this connection.
  void name(int connection, const std::string& address);

  void set_stage(int connection, Stage stage, Instant now);

  // Makes the connection a stream, if there is room for one. With `is_for_known`, the viewer has
  // shown who it is, and has more room.
  bool begin_stream(int connection, bool is_for_known, Instant now);

  void leave(int connection);

  // Returns connections that waited and may enter now; they are in Stage::receiving.
  std::vector<int> let_in(Instant now);

  // Returns connections that have to end now, because they waited or took too long, or gave way.
  // Each is returned once, and is in Stage::leaving.
  std::vector<int> to_end(Instant now);

  // True if a thread serves the connection: it does not wait, and did not give way while it waited.
  bool has_entered(int connection) const { return guests_.at(connection).has_entered; }

  std::vector<int> all() const;

  // The number of connections, without those that are leaving.
  int present() const;

  bool is_crowded() const { return present() > limits_.capacity / 2; }
  int streams() const { return count_streams(nullptr, false); }

 private:
  struct Guest {
    std::string address;  // as it is counted
    Stage stage = Stage::receiving;
    bool is_known = false;
    bool has_entered = true;
    Instant since{};
  };

  int count_streams(const std::string* address, bool is_for_strangers) const;
  int count(const std::string& address, Stage stage) const;
  int at_once(const std::string& address) const;
  bool has_many(const std::string& address) const;
  bool make_room(Instant now);

  const EntranceLimits limits_;
  std::map<int, Guest> guests_;
  std::vector<int> given_way_;
};

}  // namespace mirocup::web
