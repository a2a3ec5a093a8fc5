// SPDX-License-Identifier: MIT
//
// What Cyclone DDS has to say, kept for our own sentences instead of the user's terminal. Whoever
// can send packets can make it talk without end, so only the last few messages are kept, each once.
// It also talks of strangers: of packets that make no sense, of processes without credentials, of
// the servers and teams of another league on this host. Of each kind the last message is kept, and
// it gives way to whatever may be the team's own trouble.
#pragma once

#include <mutex>
#include <string>
#include <vector>

namespace mirocup::dds {

// One at a time: the library has one log for the whole process.
class CycloneLog {
 public:
  CycloneLog();
  CycloneLog(const CycloneLog&) = delete;
  CycloneLog& operator=(const CycloneLog&) = delete;
  ~CycloneLog();

  // The last different warnings and errors, oldest first, printable and short, with "; " between
  // them; of malformed packets only if there is nothing else; "" if there was none.
  std::string last_error() const;

  // The same as the end of a sentence, " (DDS: ...)"; "" if there was none.
  std::string last_error_suffix() const;

 private:
  void keep(std::string text);

  mutable std::mutex mutex_;  // Cyclone writes from threads of its own
  std::vector<std::string> last_;
};

}  // namespace mirocup::dds
