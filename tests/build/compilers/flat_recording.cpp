// SPDX-License-Identifier: MIT
#include "tests/build/compilers/flat_recording.hpp"

#include <cstring>
#include <type_traits>

namespace mirocup::test_support {

namespace {

using match::LoggedDecision;
using match::TeamFault;

class Writer {
 public:
  template <class T>
  void value(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    plain(value);
  }
  // A value without pointers, such as one with Eigen's vectors of fixed size.
  template <class T>
  void plain(const T& value) {
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  void text(const std::string& text) {
    value(static_cast<std::uint64_t>(text.size()));
    bytes_ += text;
  }
  template <class T, class Each>
  void list(const std::vector<T>& list, Each each) {
    value(static_cast<std::uint64_t>(list.size()));
    for (const T& item : list) each(*this, item);
  }
  std::string bytes() && { return std::move(bytes_); }

 private:
  std::string bytes_;
};

// If the bytes end too early, every later value that is read is a default.
class Reader {
 public:
  explicit Reader(const std::string& bytes) : bytes_(bytes) {}

  template <class T>
  void value(T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    plain(value);
  }
  template <class T>
  void plain(T& value) {
    if (bytes_.size() - at_ < sizeof value) {
      at_ = bytes_.size();
      is_good_ = false;
      return;
    }
    std::memcpy(static_cast<void*>(&value), bytes_.data() + at_, sizeof value);
    at_ += sizeof value;
  }
  void text(std::string& text) {
    text.resize(count());
    for (char& c : text) value(c);
  }
  template <class T, class Each>
  void list(std::vector<T>& list, Each each) {
    list.resize(count());
    for (T& item : list) each(*this, item);
  }
  bool is_at_end() const { return is_good_ && at_ == bytes_.size(); }

 private:
  std::size_t count() {
    std::uint64_t count = 0;
    value(count);
    is_good_ = is_good_ && count <= bytes_.size();
    return is_good_ ? count : 0;
  }

  const std::string& bytes_;
  std::size_t at_ = 0;
  bool is_good_ = true;
};

// Visits everything that verify() compares, in one order for writing and reading.
template <class File, class R>
void visit(File& file, R& r) {
  file.value(r.setup.league);
  file.value(r.setup.rules);
  file.value(r.setup.stage);
  file.value(r.setup.seed);
  file.value(r.setup.control_period);
  file.value(r.setup.parameters);
  file.value(r.setup.tolerances);
  file.value(r.setup.conditions);
  file.value(r.setup.left);
  file.plain(r.setup.start);
  file.list(r.ticks, [](File& f, auto& tick) { f.value(tick); });
  file.list(r.placement_requests, [](File& f, auto& request) { f.value(request); });
  file.list(r.decisions, [](File& f, auto& d) {
    f.value(d.tick);
    f.value(d.decision.clock);
    f.value(d.decision.law);
    f.value(d.decision.verdict);
    f.text(d.decision.reason);
    f.value(d.decision.ball.x());
    f.value(d.decision.ball.y());
    f.value(d.decision.restart);
    f.value(d.team);
    f.value(d.taker);
    f.value(d.robots);
    f.value(d.parties);
    f.value(d.credit);
    f.value(d.score);
  });
  file.value(r.outcome.score);
  file.value(r.outcome.played);
  file.value(r.outcome.winner);
  file.value(r.outcome.shoot_out);
  file.value(r.outcome.kind);
  file.list(r.outcome.faults, [](File& f, auto& fault) {
    f.value(fault.team);
    f.value(fault.fault.code);
    f.text(fault.fault.text);
  });
  file.text(r.outcome.why_void);
  file.value(r.state_hash);
}

}  // namespace

std::string flat(const replay::Recording& recording) {
  Writer writer;
  visit(writer, recording);
  return std::move(writer).bytes();
}

std::optional<replay::Recording> recording_from(const std::string& bytes) {
  Reader reader(bytes);
  replay::Recording recording;
  visit(reader, recording);
  if (!reader.is_at_end()) return std::nullopt;
  return recording;
}

}  // namespace mirocup::test_support
