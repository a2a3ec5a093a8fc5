// SPDX-License-Identifier: MIT
//
// The warnings and errors of Cyclone DDS, kept for our own error messages instead of printed on the
// user's terminal.
//
// Any host that can send packets can make Cyclone log without end, so the log keeps only the last
// few different messages. Some messages are about strangers: malformed packets, processes without
// credentials, the servers and teams of another league on this host. The log keeps only the last
// message of each of these kinds, and drops such messages first, because any other message may say
// why this team cannot play.
#pragma once

#include <mutex>
#include <string>
#include <string_view>
#include <vector>

namespace mirocup::dds {

// At most one object exists at a time, because Cyclone has one log for the whole process. Threads:
// any.
class CycloneLog {
 public:
  CycloneLog();
  CycloneLog(const CycloneLog&) = delete;
  CycloneLog& operator=(const CycloneLog&) = delete;
  ~CycloneLog();

  // Returns the kept messages, oldest first, separated by "; ", in printable ASCII; "" if no
  // message came. Malformed packets are mentioned only if there is no other message. Without any,
  // participants are mentioned that have announced themselves and then told nothing else.
  std::string last_error() const;

  // Returns last_error() as the end of a sentence, " (DDS: ...)"; "" if there was no message.
  std::string last_error_suffix() const;

 private:
  void keep(std::string text);
  void follow(std::string_view line);  // of the trace of Cyclone's discovery

  mutable std::mutex mutex_;  // because Cyclone writes from its own threads
  std::vector<std::string> last_;
  std::vector<std::string> unanswered_;  // announced participants that have told nothing else
};

}  // namespace mirocup::dds
