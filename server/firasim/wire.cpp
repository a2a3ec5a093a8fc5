// SPDX-License-Identifier: MIT
#include "server/firasim/wire.hpp"

#include <bit>

namespace mirocup::firasim {

namespace {

// The kinds of protobuf's fields; groups (3, 4) are of an older version and malformed here.
enum class WireType : std::uint8_t { varint = 0, fixed64 = 1, bytes = 2, fixed32 = 5 };

class Writer {
 public:
  void number(int field, std::uint64_t value) {
    if (value == 0) return;  // as proto3 does
    tag(field, WireType::varint);
    varint(value);
  }
  void real(int field, double value) {
    const auto bits = std::bit_cast<std::uint64_t>(value);
    if (bits == 0) return;
    tag(field, WireType::fixed64);
    for (int i = 0; i < 8; ++i) out_.push_back(static_cast<char>(bits >> (8 * i) & 0xff));
  }
  void message(int field, const Writer& inner) {
    tag(field, WireType::bytes);
    varint(inner.out_.size());
    out_ += inner.out_;
  }
  std::string take() { return std::move(out_); }

 private:
  void tag(int field, WireType type) {
    varint(static_cast<std::uint64_t>(field) << 3 | static_cast<std::uint64_t>(type));
  }
  void varint(std::uint64_t value) {
    for (; value >= 0x80; value >>= 7) out_.push_back(static_cast<char>((value & 0x7f) | 0x80));
    out_.push_back(static_cast<char>(value));
  }
  std::string out_;
};

// Reads the fields of one message in turn. What it cannot read makes it bad, and then it has none.
class Reader {
 public:
  explicit Reader(std::string_view bytes) : left_(bytes) {}

  bool next() {
    if (bad_ || left_.empty()) return false;
    const std::uint64_t tag = varint();
    field_ = tag >> 3;
    type_ = static_cast<WireType>(tag & 7);
    if (field_ == 0 || tag > 0xffffffffU) bad_ = true;
    switch (type_) {
      case WireType::varint:
        number_ = varint();
        break;
      case WireType::fixed64:
        number_ = fixed(8);
        break;
      case WireType::fixed32:
        number_ = fixed(4);
        break;
      case WireType::bytes: {
        const std::uint64_t size = varint();
        if (size > left_.size()) bad_ = true;
        if (bad_) return false;
        bytes_ = left_.substr(0, size);
        left_.remove_prefix(size);
        break;
      }
      default:
        bad_ = true;
    }
    return !bad_;
  }

  bool is(std::uint64_t field, WireType type) const { return field_ == field && type_ == type; }
  std::uint32_t number() const { return static_cast<std::uint32_t>(number_); }
  double real() const { return std::bit_cast<double>(number_); }
  std::string_view bytes() const { return bytes_; }
  bool is_bad() const { return bad_; }
  void spoil() { bad_ = true; }

 private:
  std::uint64_t varint() {
    std::uint64_t value = 0;
    for (int shift = 0; shift < 70; shift += 7) {
      if (left_.empty()) break;
      const auto byte = static_cast<unsigned char>(left_.front());
      left_.remove_prefix(1);
      if (shift < 64) value |= static_cast<std::uint64_t>(byte & 0x7f) << shift;
      if (byte < 0x80) return value;
    }
    bad_ = true;
    return 0;
  }
  std::uint64_t fixed(std::size_t size) {
    if (left_.size() < size) bad_ = true;
    if (bad_) return 0;
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < size; ++i) {
      value |= static_cast<std::uint64_t>(static_cast<unsigned char>(left_[i])) << (8 * i);
    }
    left_.remove_prefix(size);
    return value;
  }

  std::string_view left_, bytes_;
  std::uint64_t field_ = 0, number_ = 0;
  WireType type_ = WireType::varint;
  bool bad_ = false;
};

Writer ball_of(const Vision& vision) {
  Writer ball;
  ball.real(1, vision.ball_x);
  ball.real(2, vision.ball_y);
  ball.real(3, vision.ball_z);
  ball.real(4, vision.ball_vx);
  ball.real(5, vision.ball_vy);
  return ball;
}

// Clients take robots by their place in the list, so all are sent, in the order of their numbers.
void add_robots(Writer& frame, int field, const Vision& vision, Team team) {
  for (int i = 0; i < vision.robots_per_team; ++i) {
    const SeenRobot& seen = vision.robots[index_of(team)][i];
    Writer robot;
    robot.number(1, static_cast<std::uint64_t>(i));
    robot.real(2, seen.x);
    robot.real(3, seen.y);
    robot.real(4, seen.orientation);
    robot.real(5, seen.vx);
    robot.real(6, seen.vy);
    robot.real(7, seen.turn);
    frame.message(field, robot);
  }
}

bool read_command(std::string_view bytes, WheelCommand& command) {
  Reader in(bytes);
  while (in.next()) {
    if (in.is(1, WireType::varint)) command.id = in.number();
    if (in.is(2, WireType::varint)) command.team = in.number() != 0 ? Team::yellow : Team::blue;
    if (in.is(6, WireType::fixed64)) command.left = in.real();
    if (in.is(7, WireType::fixed64)) command.right = in.real();
  }
  return !in.is_bad();
}

bool read_commands(std::string_view bytes, std::vector<WheelCommand>& commands) {
  Reader in(bytes);
  while (in.next()) {
    if (!in.is(1, WireType::bytes)) continue;
    if (commands.size() == max_entries || !read_command(in.bytes(), commands.emplace_back())) {
      in.spoil();
    }
  }
  return !in.is_bad();
}

// A replacement is refused, so only its form is looked at, as deep as a client may send it.
bool is_message(std::string_view bytes) {
  Reader in(bytes);
  while (in.next()) continue;
  return !in.is_bad();
}

bool read_robot(std::string_view bytes, PlacedRobot& robot) {
  Reader in(bytes);
  while (in.next()) {
    if (in.is(1, WireType::varint)) robot.id = in.number();
    if (in.is(2, WireType::fixed64)) robot.x = in.real();
    if (in.is(3, WireType::fixed64)) robot.y = in.real();
    if (in.is(4, WireType::fixed64)) robot.orientation = in.real();
  }
  return !in.is_bad();
}

bool read_world(std::string_view bytes, std::uint32_t& colour, std::vector<PlacedRobot>& robots) {
  Reader in(bytes);
  while (in.next()) {
    if (in.is(1, WireType::varint)) colour = in.number();
    if (!in.is(2, WireType::bytes)) continue;
    if (robots.size() == max_entries || !read_robot(in.bytes(), robots.emplace_back())) in.spoil();
  }
  return !in.is_bad();
}

}  // namespace

std::string encode(const Vision& vision) {
  Writer frame;
  frame.message(1, ball_of(vision));
  add_robots(frame, 2, vision, Team::yellow);
  add_robots(frame, 3, vision, Team::blue);
  Writer field;
  field.real(1, vision.field.width);
  field.real(2, vision.field.length);
  field.real(3, vision.field.goal_width);
  field.real(4, vision.field.goal_depth);
  field.real(5, vision.field.center_radius);
  field.real(6, vision.field.penalty_width);
  field.real(7, vision.field.penalty_depth);
  field.real(8, vision.field.penalty_point);
  Writer environment;
  environment.number(1, vision.step);
  environment.message(2, frame);
  environment.message(3, field);
  environment.number(4, vision.goals[index_of(Team::blue)]);
  environment.number(5, vision.goals[index_of(Team::yellow)]);
  return environment.take();
}

std::string encode(const RefereeCommand& command) {
  Writer out;
  out.number(1, static_cast<std::uint64_t>(command.foul));
  out.number(2, static_cast<std::uint64_t>(command.colour));
  out.number(3, static_cast<std::uint64_t>(command.quadrant));
  out.real(4, command.timestamp);
  out.number(5, static_cast<std::uint64_t>(command.half));
  return out.take();
}

std::optional<Packet> decode_packet(std::string_view bytes) {
  Packet packet;
  Reader in(bytes);
  while (in.next()) {
    if (in.is(1, WireType::bytes) && !read_commands(in.bytes(), packet.commands)) in.spoil();
    if (in.is(2, WireType::bytes)) {
      packet.has_replacement = true;
      if (!is_message(in.bytes())) in.spoil();
    }
    if (in.is(15, WireType::varint)) packet.step = in.number();
  }
  if (in.is_bad() || (packet.commands.empty() && !packet.has_replacement)) return std::nullopt;
  return packet;
}

std::optional<TeamPlacement> decode_placement(std::string_view bytes) {
  std::uint32_t colour = 0;
  bool has_world = false;
  TeamPlacement placement;
  Reader in(bytes);
  while (in.next()) {
    if (!in.is(1, WireType::bytes)) continue;
    has_world = true;
    if (!read_world(in.bytes(), colour, placement.robots)) in.spoil();
  }
  if (in.is_bad() || !has_world || colour > 1) return std::nullopt;
  placement.team = colour == 1 ? Team::yellow : Team::blue;
  return placement;
}

}  // namespace mirocup::firasim
