// SPDX-License-Identifier: MIT
//
// The warnings and errors of Cyclone DDS, kept for our own error messages instead of printed on the
// user's terminal.
//
// Any host that can send packets can make Cyclone log without end, so only the last few messages
// are kept, each once. Some messages are about strangers: malformed packets, processes without
// credentials, the servers and teams of another league on this host. The log keeps the last message
// of each of these kinds, and drops it first, because any other message may be the reason why this
// team cannot play.
#pragma once

#include <mutex>
#include <string>
#include <vector>

namespace mirocup::dds {

// At most one exists at a time, because Cyclone has one log for the whole process. Safe to use from
// several threads.
class CycloneLog {
 public:
  CycloneLog();
  CycloneLog(const CycloneLog&) = delete;
  CycloneLog& operator=(const CycloneLog&) = delete;
  ~CycloneLog();

  // Returns the last different messages, oldest first, separated by "; ", in printable ASCII; "" if
  // there was none. Malformed packets are mentioned only if there is nothing else.
  std::string last_error() const;

  // Returns last_error() as the end of a sentence, " (DDS: ...)"; "" if there was no message.
  std::string last_error_suffix() const;

 private:
  void keep(std::string text);

  mutable std::mutex mutex_;  // Cyclone writes from threads of its own
  std::vector<std::string> last_;
};

}  // namespace mirocup::dds
