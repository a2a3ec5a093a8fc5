/* SPDX-License-Identifier: MIT */
/* An empty network: sockets can be opened and bound, and nothing arrives. */
#ifndef MIROCUP_SIMUROSOT_WINSOCK2_H
#define MIROCUP_SIMUROSOT_WINSOCK2_H
#include "windows.h"

typedef uintptr_t SOCKET;
typedef unsigned long u_long;
typedef struct {
  WORD wVersion;
} WSADATA, *LPWSADATA;
struct in_addr {
  union {
    struct {
      BYTE s_b1, s_b2, s_b3, s_b4;
    } S_un_b;
    DWORD S_addr;
  } S_un;
#define s_addr S_un.S_addr
};
struct sockaddr {
  USHORT sa_family;
  char sa_data[14];
};
struct sockaddr_in {
  SHORT sin_family;
  USHORT sin_port;
  struct in_addr sin_addr;
  char sin_zero[8];
};
typedef struct sockaddr SOCKADDR, *LPSOCKADDR, *PSOCKADDR;
typedef struct sockaddr_in SOCKADDR_IN, *PSOCKADDR_IN;
typedef struct in_addr IN_ADDR;
typedef struct hostent {
  char *h_name, **h_aliases;
  SHORT h_addrtype, h_length;
  char** h_addr_list;
#define h_addr h_addr_list[0]
} HOSTENT, *LPHOSTENT, *PHOSTENT;

#define INVALID_SOCKET ((SOCKET)-1)
#define SOCKET_ERROR (-1)
#define AF_INET 2
#define PF_INET 2
#define SOCK_STREAM 1
#define SOCK_DGRAM 2
#define IPPROTO_TCP 6
#define IPPROTO_UDP 17
#define SOL_SOCKET 0xffff
#define SO_REUSEADDR 4
#define SO_BROADCAST 0x20
#define SO_RCVTIMEO 0x1006
#define FIONBIO 0x8004667e
#define SD_RECEIVE 0
#define SD_SEND 1
#define SD_BOTH 2
#define INADDR_ANY 0u
#define INADDR_BROADCAST 0xffffffffu
#define WSAEWOULDBLOCK 10035

static inline USHORT htons(USHORT x) {
  return (USHORT)(x << 8 | x >> 8);
}
static inline DWORD htonl(DWORD x) {
  return __builtin_bswap32(x);
}
#define ntohs htons
#define ntohl htonl

#define MIROCUP_DOES_NOTHING(type, name, value) \
  static inline type name(...) {                \
    return value;                               \
  }
MIROCUP_DOES_NOTHING(int, WSAStartup, 0)
MIROCUP_DOES_NOTHING(int, WSACleanup, 0)
MIROCUP_DOES_NOTHING(int, WSAGetLastError, WSAEWOULDBLOCK)
MIROCUP_DOES_NOTHING(SOCKET, socket, 1)
MIROCUP_DOES_NOTHING(int, closesocket, 0)
MIROCUP_DOES_NOTHING(int, ioctlsocket, 0)
MIROCUP_DOES_NOTHING(int, setsockopt, 0)
MIROCUP_DOES_NOTHING(int, bind, 0)
MIROCUP_DOES_NOTHING(int, listen, 0)
// Some teams send their thoughts to a debugging program, and end if they cannot connect.
MIROCUP_DOES_NOTHING(int, connect, 0)
MIROCUP_DOES_NOTHING(SOCKET, accept, INVALID_SOCKET)
MIROCUP_DOES_NOTHING(int, shutdown, 0)
MIROCUP_DOES_NOTHING(int, send, SOCKET_ERROR)
MIROCUP_DOES_NOTHING(int, sendto, SOCKET_ERROR)
MIROCUP_DOES_NOTHING(int, recv, SOCKET_ERROR)
MIROCUP_DOES_NOTHING(int, recvfrom, SOCKET_ERROR)
MIROCUP_DOES_NOTHING(DWORD, inet_addr, 0)
#undef MIROCUP_DOES_NOTHING
static inline struct hostent* gethostbyname(const char*) {
  static char address[8] = {127, 0, 0, 1};
  static char* addresses[] = {address, NULL};
  static struct hostent host = {address, addresses + 1, AF_INET, 4, addresses};
  return &host;
}
static inline char* inet_ntoa(in_addr) {
  static char text[] = "127.0.0.1";
  return text;
}
#endif
