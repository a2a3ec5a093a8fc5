// SPDX-License-Identifier: MIT
#include "plugins/host/sandbox/descriptor_packet.hpp"

#include <cstring>
#include <sys/socket.h>

namespace mirocup::plugins {

namespace {

// One packet and the room for the control message with its descriptor.
struct Packet {
  Packet(char* text, std::size_t size) : bytes{text, size} {
    message.msg_iov = &bytes;
    message.msg_iovlen = 1;
    message.msg_control = control;
    message.msg_controllen = sizeof control;
  }

  iovec bytes;
  alignas(cmsghdr) char control[CMSG_SPACE(sizeof(int))] = {};
  msghdr message{};
};

}  // namespace

bool send_descriptor(int socket, int descriptor) {
  char text[] = "d";  // an empty packet would look like the end
  Packet packet(text, 1);
  cmsghdr* header = CMSG_FIRSTHDR(&packet.message);
  header->cmsg_level = SOL_SOCKET;
  header->cmsg_type = SCM_RIGHTS;
  header->cmsg_len = CMSG_LEN(sizeof descriptor);
  std::memcpy(CMSG_DATA(header), &descriptor, sizeof descriptor);
  return sendmsg(socket, &packet.message, MSG_NOSIGNAL) == 1;
}

ssize_t receive_packet(int socket, char* text, std::size_t size, system::Descriptor& descriptor) {
  Packet packet(text, size);
  const ssize_t length = recvmsg(socket, &packet.message, MSG_CMSG_CLOEXEC);
  const cmsghdr* header = length < 0 ? nullptr : CMSG_FIRSTHDR(&packet.message);
  if (header != nullptr && header->cmsg_level == SOL_SOCKET && header->cmsg_type == SCM_RIGHTS) {
    int received = -1;
    std::memcpy(&received, CMSG_DATA(header), sizeof received);
    descriptor.reset(received);
  }
  return length;
}

}  // namespace mirocup::plugins
