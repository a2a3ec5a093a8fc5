// SPDX-License-Identifier: MIT
//
// A file descriptor that closes itself.
#pragma once

#include <unistd.h>
#include <utility>

namespace mirocup::system {

class Descriptor {
 public:
  // Owns `fd` from now on. A negative one, as open() returns on failure, is none.
  explicit Descriptor(int fd = -1) : fd_(fd) {}
  Descriptor(Descriptor&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(fd_, other.fd_);
    return *this;
  }
  ~Descriptor() {
    if (fd_ >= 0) close(fd_);
  }

  bool is_open() const { return fd_ >= 0; }

  // The descriptor, which stays owned; negative if there is none.
  int get() const { return fd_; }

 private:
  int fd_;
};

}  // namespace mirocup::system
