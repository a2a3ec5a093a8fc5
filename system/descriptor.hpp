// SPDX-License-Identifier: MIT
//
// A file descriptor that closes itself.
#pragma once

#include <unistd.h>
#include <utility>

namespace mirocup::system {

class Descriptor {
 public:
  // Owns `fd` from now on. A negative number, as open() returns on failure, means no descriptor.
  explicit Descriptor(int fd = -1) : fd_(fd) {}
  Descriptor(Descriptor&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    reset(std::exchange(other.fd_, -1));
    return *this;
  }
  ~Descriptor() { reset(); }

  bool is_open() const { return fd_ >= 0; }

  // Returns the descriptor, which this object still owns; negative if there is none.
  int get() const { return fd_; }

  // Closes the descriptor and owns `fd` from now on.
  void reset(int fd = -1) {
    if (fd_ >= 0) close(fd_);
    fd_ = fd;
  }

 private:
  int fd_;
};

}  // namespace mirocup::system
