// SPDX-License-Identifier: MIT
//
// Implements mirocup/team.h with dds::TeamClient.
#include "mirocup/team.h"
#include "plugins/abi/convert.hpp"
#include "plugins/abi/drawing.hpp"
#include "server/dds/team_client.hpp"

#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <cstring>

// The connection that a caller of the C interface holds.
struct mirocup_connection {
  std::unique_ptr<mirocup::dds::TeamClient> client;
  mirocup::Team team = mirocup::Team::blue;
  mirocup_setup setup{};
  mirocup_observation observation{};
  std::optional<mirocup::match::PlacementRequest> poses;  // for the answer to the present tick
  mirocup::match::ByTeam<std::int32_t> score{};
  mutable std::string text;
  bool is_finished = false;  // `text` says how the match ended
};

namespace mirocup::dds {

namespace {

void write_line(void* /*host*/, const char* text) {
  std::fprintf(stderr, "%s\n", text);
}

// A program has options of its own; a match on the network gives it no parameters.
double own_default(void*, const char*, double fallback) {
  return fallback;
}

// No shape leaves the program: a match keeps only what teams without a network draw.
void draw_nothing(void*, const match::Thought&) {}

// Stores one kind of news in the connection and returns its number in team.h.
struct Receive {
  mirocup_connection& c;

  std::int32_t operator()(const Silence&) const { return MIROCUP_TEAM_NOTHING; }
  std::int32_t operator()(const Seated&) const {
    c.setup = abi::to_setup(c.client->briefing());
    c.setup.log = write_line;
    c.setup.host = &c;
    c.setup.parameter = own_default;
    abi::give_drawing<draw_nothing>(c.setup);
    return MIROCUP_TEAM_SEATED;
  }
  std::int32_t operator()(const match::Snapshot& scene) const {
    c.observation = abi::to_observation(match::observe(scene, c.team, c.client->robots()));
    c.poses.reset();
    return MIROCUP_TEAM_TICK;
  }
  std::int32_t operator()(const MatchOver& over) const {
    c.is_finished = true;
    c.text = over.how;
    c.score = {over.score[0], over.score[1]};
    return MIROCUP_TEAM_OVER;
  }
  std::int32_t operator()(const Refused& refused) const {
    c.is_finished = true;
    c.text = refused.why;
    return MIROCUP_TEAM_REFUSED;
  }
};

// The size of a call before it had an interface.
constexpr std::size_t first_call_size = offsetof(mirocup_team_call, interface);

void put_why(char* why, std::size_t size, const std::string& text) {
  if (why != nullptr && size > 0) std::snprintf(why, size, "%s", text.c_str());
}

}  // namespace

}  // namespace mirocup::dds

namespace dds = mirocup::dds;

mirocup_connection* mirocup_team_open(const mirocup_team_call* call, char* why, std::size_t size) {
  if (call == nullptr || (call->size != sizeof *call && call->size != dds::first_call_size) ||
      call->match == nullptr || call->name == nullptr ||
      (call->team != MIROCUP_BLUE && call->team != MIROCUP_YELLOW)) {
    dds::put_why(why, size, "the call lacks a match, a team or a colour, or is of another version");
    errno = EINVAL;
    return nullptr;
  }
  const std::size_t name_size = std::strlen(call->name);
  if (name_size == 0 || name_size > dds::max_team_name) {
    dds::put_why(why, size,
                 "the name of a team has 1 to " + std::to_string(dds::max_team_name) + " bytes");
    errno = EINVAL;
    return nullptr;
  }
  dds::JoinRequest c;
  if (call->server != nullptr) c.server = call->server;
  c.match_id = call->match;
  c.team = static_cast<mirocup::Team>(call->team);
  c.name = call->name;
  if (call->credentials != nullptr) c.credentials = call->credentials;
  c.domain = call->domain;
  if (call->size > dds::first_call_size && call->interface != nullptr)
    c.interface = call->interface;
  if (c.domain < dds::default_domain || c.domain > dds::last_domain) {
    dds::put_why(why, size, "DDS domain " + std::to_string(c.domain) + " does not exist: 0 to 230");
    errno = EINVAL;
    return nullptr;
  }
  auto client = dds::TeamClient::open(c);
  if (!client) {
    dds::put_why(why, size, client.error().what);
    errno = client.error().code == mirocup::Errc::input ? EINVAL : ENETDOWN;
    return nullptr;
  }
  auto connection = std::make_unique<mirocup_connection>();
  connection->client = std::move(*client);
  connection->team = c.team;
  return connection.release();
}

std::int32_t mirocup_team_wait(mirocup_connection* connection, double seconds) {
  return std::visit(dds::Receive{*connection}, connection->client->wait(seconds));
}

const mirocup_setup* mirocup_team_setup(const mirocup_connection* connection) {
  return &connection->setup;
}

const mirocup_observation* mirocup_team_observation(const mirocup_connection* connection) {
  return &connection->observation;
}

std::uint32_t mirocup_team_version() {
  return MIROCUP_ABI_VERSION;
}

std::int32_t mirocup_team_place(mirocup_connection* connection,
                                const mirocup_placement* placement) {
  if (connection->observation.placing == 0) return -1;
  connection->poses = mirocup::abi::to_poses(*placement);
  return 0;
}

std::int32_t mirocup_team_send(mirocup_connection* connection, const mirocup_command* command) {
  if (connection->is_finished) return -1;
  mirocup::match::Command answer = mirocup::abi::to_command(*command);
  answer.placement = connection->poses;
  connection->client->send(answer, connection->observation.tick);
  return 0;
}

const char* mirocup_team_text(const mirocup_connection* connection) {
  if (!connection->is_finished) connection->text = connection->client->last_error();
  return connection->text.c_str();
}

const std::int32_t* mirocup_team_score(const mirocup_connection* connection) {
  return connection->score.data();
}

void mirocup_team_close(mirocup_connection* connection) {
  delete connection;
}
