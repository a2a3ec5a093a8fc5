// SPDX-License-Identifier: MIT
//
// What Cyclone DDS has to say, kept for our own sentences instead of the user's terminal. Whoever
// can send packets can make it talk without end, so only the last message is kept, and none about
// malformed packets while there is another.
#pragma once

#include <mutex>
#include <string>

namespace mirocup::dds {

// One at a time: the library has one log for the whole process.
class Log {
 public:
  Log();
  Log(const Log&) = delete;
  Log& operator=(const Log&) = delete;
  ~Log();

  // The last warning or error, printable and short; "" if there was none.
  std::string last() const;

 private:
  void keep(std::string text);

  mutable std::mutex mutex_;  // Cyclone writes from threads of its own
  std::string last_;
};

}  // namespace mirocup::dds
