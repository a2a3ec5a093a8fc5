/* SPDX-License-Identifier: MIT
 *
 * A wire between two hosts that loses and delays packets: lossy_wire HOST LOSS DELAY JITTER NAME.
 * Hosts are network namespaces. Makes a TUN device NAME on this host and a device eth0 on the host
 * of the file HOST, says "ready", and carries IP packets between them, in either direction. Each
 * packet, and so each fragment of a larger one, is lost with the probability LOSS, and takes DELAY
 * ms, with a deviation of up to JITTER ms that keeps the order. Ends when it is killed.
 */
#define _GNU_SOURCE
#include <errno.h>
#include <fcntl.h>
#include <linux/if.h>
#include <linux/if_tun.h>
#include <poll.h>
#include <sched.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <time.h>
#include <unistd.h>

enum { max_packet = 2048, max_waiting = 1024 };

struct packet {
  double due;
  ssize_t size;
  char bytes[max_packet];
};

/* One direction: packets wait in a ring. */
struct direction {
  int from, to;
  int first, count;
  double last_due;
  struct packet waiting[max_waiting];
};

static double now(void) {
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Uniform in [0, 1), the same sequence in each run. */
static double chance(void) {
  static uint64_t state = 88172645463325252u;
  state ^= state << 13;
  state ^= state >> 7;
  state ^= state << 17;
  return (double)(state >> 11) * 0x1p-53;
}

static int need(int result, const char* what) {
  if (result >= 0) return result;
  perror(what);
  exit(1);
}

static int open_device(const char* name) {
  const int device = need(open("/dev/net/tun", O_RDWR | O_NONBLOCK | O_CLOEXEC), "/dev/net/tun");
  struct ifreq request;
  memset(&request, 0, sizeof request);
  request.ifr_flags = IFF_TUN | IFF_NO_PI;
  strncpy(request.ifr_name, name, IFNAMSIZ - 1);
  need(ioctl(device, TUNSETIFF, &request), name);
  return device;
}

static void take(struct direction* d, double loss, double delay, double jitter) {
  while (d->count < max_waiting) {
    struct packet* p = &d->waiting[(d->first + d->count) % max_waiting];
    p->size = read(d->from, p->bytes, sizeof p->bytes);
    if (p->size <= 0) return;
    if (chance() < loss) continue;
    p->due = now() + delay + jitter * (2.0 * chance() - 1.0);
    if (p->due < d->last_due) p->due = d->last_due;
    d->last_due = p->due;
    ++d->count;
  }
}

/* Writing fails with EIO as long as a device is down. */
static void deliver(struct direction* d) {
  while (d->count > 0 && d->waiting[d->first].due <= now()) {
    const struct packet* p = &d->waiting[d->first];
    if (write(d->to, p->bytes, (size_t)p->size) < 0 && errno != EIO) perror("lossy_wire");
    d->first = (d->first + 1) % max_waiting;
    --d->count;
  }
}

int main(int argc, char** argv) {
  if (argc != 6) return 2;
  const double loss = atof(argv[2]), delay = 1e-3 * atof(argv[3]), jitter = 1e-3 * atof(argv[4]);
  const int here = open_device(argv[5]);
  need(setns(need(open(argv[1], O_RDONLY | O_CLOEXEC), argv[1]), CLONE_NEWNET), "setns");
  const int there = open_device("eth0");
  static struct direction go, come;
  go.from = come.to = here;
  go.to = come.from = there;
  puts("ready");
  fflush(stdout);
  for (;;) {
    double wait = 1.0;
    const struct direction* both[] = {&go, &come};
    for (int i = 0; i < 2; ++i) {
      if (both[i]->count == 0) continue;
      const double left = both[i]->waiting[both[i]->first].due - now();
      wait = left < wait ? left : wait;
    }
    if (wait > 0.0) {
      struct pollfd ends[] = {{here, POLLIN, 0}, {there, POLLIN, 0}};
      const struct timespec pause = {(time_t)wait, (long)(1e9 * (wait - (double)(time_t)wait))};
      ppoll(ends, 2, &pause, NULL);
    }
    take(&go, loss, delay, jitter);
    take(&come, loss, delay, jitter);
    deliver(&go);
    deliver(&come);
  }
}
