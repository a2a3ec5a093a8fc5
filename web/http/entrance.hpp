// SPDX-License-Identifier: MIT
//
// Decides which connections enter, wait or give way if many come. This class only counts; the
// server owns the sockets. The numbers of sockets name the connections.
//
// As long as at most half of the capacity is taken, everybody may enter. If more than half is
// taken, the server answers an address that has many streams or connections a few requests at a
// time, and grants it no further stream. Its further connections wait, or take the place of its own
// oldest: of a slow answer, or of a request that has not arrived if the address has many of these.
// So nobody is locked out by neighbours behind the same address who send half requests. If no
// capacity is left, a connection of any address gives way to the new one: the oldest that waits,
// otherwise the oldest whose request has not arrived, otherwise the oldest with a slow answer.
//
// Threads: one at a time.
#pragma once

#include <chrono>
#include <map>
#include <string>
#include <vector>

namespace mirocup::web {

using Instant = std::chrono::steady_clock::time_point;

struct EntranceLimits {
  int capacity = 256;         // the most connections in all
  int many_streams = 8;       // from this number on, an address has many streams
  int many_connections = 32;  // from this number on, an address has many connections
  // The most requests answered at once for an address with many connections.
  int at_once = 4;
  int most_arriving = 32;  // from this number on, half requests of an address give way to its next
  int most_waiting = 32;   // the most waiting connections of an address
  std::chrono::milliseconds longest_wait{5000};
  std::chrono::milliseconds request_time{10'000};
  std::chrono::milliseconds request_time_if_crowded{2000};
};

// Returns the capacity for this machine: 256 connections for each processor, at most 1024, and at
// most half as many as this process may open files.
int connection_capacity();

enum class Stage {
  waiting,    // waits until its address has fewer requests
  receiving,  // the head of its request has not arrived
  answering,
  uploading,  // the server has asked for the body of its request
  streaming,
  leaving,  // the connection gave way, and its thread is about to end
};

class Entrance {
 public:
  explicit Entrance(EntranceLimits limits) : limits_(limits) {}

  // To be called when a connection has come. Returns its first stage, or Stage::leaving if the
  // connection is refused.
  Stage arrive(int connection, const std::string& address, Instant now);

  // Sets the address of the viewer for whom a proxy has made this connection.
  void name(int connection, const std::string& address);

  void set_stage(int connection, Stage stage, Instant now);

  // Makes the connection a stream, if there is room for a stream. `is_for_known`: the viewer has
  // shown who it is, so it has more room.
  bool begin_stream(int connection, bool is_for_known, Instant now);

  void leave(int connection);

  // Returns connections that waited and may enter now; the connections are then in
  // Stage::receiving.
  std::vector<int> let_in(Instant now);

  // Returns connections that have to end now: those that gave way, waited too long, or took too
  // long to send their request. Each connection is returned once, and is then in Stage::leaving.
  std::vector<int> to_end(Instant now);

  // True if a thread serves the connection. No thread serves a connection that waits, or that gave
  // way while it waited.
  bool has_entered(int connection) const { return guests_.at(connection).has_entered; }

  std::vector<int> all() const;

  // Returns the number of connections, of an address or (null) of all, that are not in
  // Stage::leaving.
  int present(const std::string* address = nullptr) const;

  bool is_crowded() const { return present() > limits_.capacity / 2; }
  int streams() const;

 private:
  struct Guest {
    std::string address;  // the address for which the connection counts
    Stage stage = Stage::receiving;
    bool is_known = false;
    bool has_entered = true;
    Instant since{};
  };

  int count(auto matches) const;
  int count(const std::string& address, Stage stage) const;
  bool has_many(const std::string& address) const;
  bool let_oldest_go(Stage stage, Instant before, const std::string* address = nullptr);
  bool make_room(Instant now);

  const EntranceLimits limits_;
  std::map<int, Guest> guests_;
  std::vector<int> given_way_;
};

}  // namespace mirocup::web
