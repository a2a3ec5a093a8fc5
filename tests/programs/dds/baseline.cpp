// SPDX-License-Identifier: MIT
//
// The machine's own durations, without mirocup, for dds/benchmark.py: baseline KIND PERIOD SECONDS
// prints percentiles of durations, in seconds, as JSON.
//   udp    a datagram as large as a state to two other processes and back, once in a period
//   sleep  how late clock_nanosleep() wakes, once in a period
#include "record/durations.hpp"

#include <arpa/inet.h>
#include <csignal>
#include <cstdlib>
#include <ctime>
#include <iostream>
#include <mirocup.h>
#include <string>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <unistd.h>

namespace {

using mirocup::record::Durations;

constexpr int echoes = 2;

double now() {
  timespec t{};
  clock_gettime(CLOCK_MONOTONIC, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

void sleep_until(double time) {
  const auto whole = static_cast<time_t>(time);
  const timespec t{whole, static_cast<long>(1e9 * (time - static_cast<double>(whole)))};
  clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &t, nullptr);
}

struct Socket {
  int descriptor = socket(AF_INET, SOCK_DGRAM, 0);
  sockaddr_in address{};
  Socket() {
    socklen_t size = sizeof address;
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    bind(descriptor, reinterpret_cast<sockaddr*>(&address), size);
    getsockname(descriptor, reinterpret_cast<sockaddr*>(&address), &size);
  }
};

// Runs in a child process: answers each state with a command, until its parent ends.
void start_echo(const Socket& socket) {
  if (fork() != 0) return;
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  char packet[sizeof(mirocup_v1_WorldState)];
  sockaddr_in from{};
  while (true) {
    socklen_t size = sizeof from;
    recvfrom(socket.descriptor, packet, sizeof packet, 0, reinterpret_cast<sockaddr*>(&from),
             &size);
    sendto(socket.descriptor, packet, sizeof(mirocup_v1_TeamCommand), 0,
           reinterpret_cast<sockaddr*>(&from), size);
  }
}

class Udp {
 public:
  Udp() {
    for (const Socket& echo : echoes_) start_echo(echo);
  }

  void operator()(double /*due*/, Durations& durations) {
    char packet[sizeof(mirocup_v1_WorldState)] = {};
    const double begin = now();
    for (const Socket& echo : echoes_) {
      sendto(own_.descriptor, packet, sizeof packet, 0,
             reinterpret_cast<const sockaddr*>(&echo.address), sizeof echo.address);
    }
    for (int i = 0; i < echoes; ++i) {
      recv(own_.descriptor, packet, sizeof packet, 0);
      durations.add(now() - begin);
    }
  }

 private:
  Socket own_;
  Socket echoes_[echoes];
};

template <class Step>
Durations measure(double period, double seconds, Step step) {
  Durations durations;
  const double begin = now();
  for (int i = 1; i * period < seconds; ++i) {
    sleep_until(begin + i * period);
    step(begin + i * period, durations);
  }
  return durations;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  const double period = std::atof(argv[2]);
  const double seconds = std::atof(argv[3]);
  const Durations d =
      argv[1] == std::string("udp")
          ? measure(period, seconds, Udp())
          : measure(period, seconds, [](double due, Durations& late) { late.add(now() - due); });
  std::cout << "{\"p50\": " << d.quantile(0.5) << ", \"p99\": " << d.quantile(0.99)
            << ", \"p999\": " << d.quantile(0.999) << ", \"longest\": " << d.max() << "}\n";
  return 0;
}
