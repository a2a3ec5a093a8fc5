// SPDX-License-Identifier: MIT
//
// What Cyclone DDS has to say, kept for our own sentences instead of the user's terminal. Whoever
// can send packets can make it talk without end, so only the last few messages are kept, each once,
// and none about malformed packets while there is another. A few, since it also talks of strangers
// (the servers and teams of another league on this host) while one looks for a team's trouble.
#pragma once

#include <mutex>
#include <string>
#include <vector>

namespace mirocup::dds {

// One at a time: the library has one log for the whole process.
class Log {
 public:
  Log();
  Log(const Log&) = delete;
  Log& operator=(const Log&) = delete;
  ~Log();

  // The last different warnings and errors, oldest first, printable and short, with "; " between
  // them; "" if there was none.
  std::string said() const;

 private:
  void keep(std::string text);

  mutable std::mutex mutex_;  // Cyclone writes from threads of its own
  std::vector<std::string> last_;
};

}  // namespace mirocup::dds
