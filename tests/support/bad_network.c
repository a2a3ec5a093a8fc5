/* SPDX-License-Identifier: MIT
 *
 * Simulates a network that loses and changes packets, for processes that load this library with
 * LD_PRELOAD:
 *   BAD_NETWORK_LOSS=P    loses each packet that the process sends with probability P
 *   BAD_NETWORK_DELAY=MS  each packet that the process sends takes this long, in milliseconds
 *   BAD_NETWORK_GARBAGE=N sends N changed copies before each packet: other bits, lengths, ends,
 *                         senders
 *   BAD_NETWORK_LIMIT=N   sends at most N changed copies, and writes to standard error when it has
 *   BAD_NETWORK_NAT=N     the process is behind a router that translates addresses: its packets
 *                         come from another address, and it receives only replies, from where it
 *                         has sent to. After N packets the router takes another address and port
 *                         (0: never)
 *   BAD_NETWORK_CUT=N     from the packet N of the process, nothing comes or goes for 4 s
 *   BAD_NETWORK_JUMP=N    sends a copy with a far higher sequence number before its packet N with a
 *                         sample: a receiver that believes it takes all true samples for old
 * The random numbers are the same in each run. */
#define _GNU_SOURCE
#include <arpa/inet.h>
#include <dlfcn.h>
#include <netinet/in.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/uio.h>
#include <time.h>

enum { largest = 65536, most_delayed = 4096, most_peers = 64 };

typedef ssize_t send_function(int, const struct msghdr*, int);

static unsigned long next(void) { /* xorshift; threads may get the same number */
  static unsigned long state = 88172645463325252UL;
  state ^= state << 13;
  state ^= state >> 7;
  state ^= state << 17;
  return state;
}

static double number(const char* name) {
  const char* text = getenv(name);
  return text == NULL ? 0.0 : atof(text);
}

static size_t change(unsigned char* packet, size_t size) {
  unsigned long i;
  const unsigned long changes = 1 + next() % 4;
  if (size < 21) return size;
  for (i = 0; i < changes; ++i) {
    switch (next() % 6) {
      case 0: /* a bit */
        packet[next() % size] ^= (unsigned char)(1U << (next() % 8));
        break;
      case 1: /* a byte behind the header */
        packet[20 + next() % (size - 20)] = (unsigned char)next();
        break;
      case 2: /* a length, a count, a sequence number */
        memset(packet + 20 + (next() % (size - 20)) / 4 * 4, next() % 2 ? 0xff : 0x00,
               size >= 24 ? 1 + next() % 2 : 1);
        break;
      case 3: /* the sender */
        packet[8 + next() % 12] = (unsigned char)next();
        break;
      case 4: /* the end is missing */
        size = 21 + next() % (size - 20);
        break;
      default: /* something twice */
        memmove(packet + 20, packet + 20 + (next() % (size - 20)) / 2, (size - 20) / 2);
    }
    if (size < 21) return size;
  }
  return size;
}

/* The number of the sample in a packet of RTPS with one from a writer of the application, or
 * null. */
static unsigned char* sample_number(unsigned char* packet, size_t size) {
  const unsigned char data = 0x15, user_writer = 0x03;
  size_t at = 20;
  while (at + 24 <= size) {
    const size_t length = packet[at + 2] + 256U * packet[at + 3]; /* little-endian, as ours are */
    if (packet[at] == data && packet[at + 15] == user_writer) return packet + at + 16;
    if (length == 0) return NULL;
    at += 4 + length;
  }
  return NULL;
}

static size_t gather(const struct msghdr* message, unsigned char* packet) {
  size_t size = 0, i;
  for (i = 0; i < message->msg_iovlen; ++i) {
    const struct iovec* part = &message->msg_iov[i];
    if (size + part->iov_len > largest) return 0;
    memcpy(packet + size, part->iov_base, part->iov_len);
    size += part->iov_len;
  }
  return size;
}

static void send_copy(send_function* real, int socket, const struct msghdr* message, int flags,
                      unsigned char* packet, size_t size) {
  struct iovec whole = {packet, size};
  struct msghdr changed = *message;
  changed.msg_iov = &whole;
  changed.msg_iovlen = 1;
  real(socket, &changed, flags);
}

static void jump(send_function* real, int socket, const struct msghdr* message, int flags) {
  static long samples = 0;
  static unsigned char copy[largest];
  const size_t size = gather(message, copy);
  unsigned char* sample = sample_number(copy, size);
  if (sample == NULL || ++samples != (long)number("BAD_NETWORK_JUMP")) return;
  sample[6] = 0x7f; /* of the lower half */
  send_copy(real, socket, message, flags, copy, size);
}

static void send_garbage(send_function* real, int socket, const struct msghdr* message, int flags) {
  static long sent = 0;
  static unsigned char original[largest], copy[largest];
  const long copies = (long)number("BAD_NETWORK_GARBAGE");
  const long limit = (long)number("BAD_NETWORK_LIMIT");
  const size_t size = gather(message, original);
  long n;
  for (n = 0; n < copies && (limit == 0 || sent < limit); ++n) {
    memcpy(copy, original, size);
    send_copy(real, socket, message, flags, copy, change(copy, size));
    if (++sent == limit) fprintf(stderr, "%ld changed packets were sent\n", sent);
  }
}

static void send_out(send_function* real, int socket, const struct msghdr* message, int flags);

/* Packets on their way, in the order in which they were sent. */
static struct delayed {
  struct timespec due;
  int socket;
  struct sockaddr_storage to;
  socklen_t to_size;
  size_t size;
  unsigned char* bytes;
} on_the_way[most_delayed];
static unsigned long first_on_the_way, behind_last_on_the_way;
static pthread_mutex_t way = PTHREAD_MUTEX_INITIALIZER;
static pthread_cond_t more = PTHREAD_COND_INITIALIZER;

static void* deliver(void* real_function) {
  send_function* real = NULL;
  *(void**)&real = real_function;
  for (;;) {
    struct delayed packet;
    struct iovec whole;
    struct msghdr message = {0};
    pthread_mutex_lock(&way);
    while (first_on_the_way == behind_last_on_the_way) pthread_cond_wait(&more, &way);
    packet = on_the_way[first_on_the_way++ % most_delayed];
    pthread_mutex_unlock(&way);
    clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &packet.due, NULL);
    whole.iov_base = packet.bytes;
    whole.iov_len = packet.size;
    message.msg_name = &packet.to;
    message.msg_namelen = packet.to_size;
    message.msg_iov = &whole;
    message.msg_iovlen = 1;
    send_out(real, packet.socket, &message, MSG_NOSIGNAL);
    free(packet.bytes);
  }
  return NULL;
}

/* Returns 0 if the packet cannot be delayed. */
static int delay(send_function* real, int socket, const struct msghdr* message, double ms) {
  static int is_running = 0;
  static unsigned char packet[largest];
  struct delayed* last;
  const long ns = (long)(1e6 * ms);
  pthread_t thread;
  int is_kept = 0;
  if (message->msg_name == NULL || message->msg_namelen > sizeof last->to) return 0;
  pthread_mutex_lock(&way);
  if (behind_last_on_the_way - first_on_the_way < most_delayed) {
    last = &on_the_way[behind_last_on_the_way % most_delayed];
    last->size = gather(message, packet);
    last->bytes = malloc(last->size + 1);
    memcpy(last->bytes, packet, last->size);
    memcpy(&last->to, message->msg_name, message->msg_namelen);
    last->to_size = message->msg_namelen;
    last->socket = socket;
    clock_gettime(CLOCK_MONOTONIC, &last->due);
    last->due.tv_sec += (last->due.tv_nsec + ns) / 1000000000L;
    last->due.tv_nsec = (last->due.tv_nsec + ns) % 1000000000L;
    ++behind_last_on_the_way;
    is_kept = 1;
  }
  if (!is_running) {
    is_running = 1;
    pthread_create(&thread, NULL, deliver, *(void**)&real);
    pthread_detach(thread);
  }
  pthread_cond_signal(&more);
  pthread_mutex_unlock(&way);
  return is_kept;
}

/* The router: `outside` is its socket on the internet, `inside` the one from which the process gets
 * what is let in. */
static struct {
  pthread_mutex_t lock;
  int outside, inside;
  long sent;
  struct sockaddr_in process; /* where the process receives */
  struct sockaddr_in peers[most_peers];
  unsigned count;
} router = {PTHREAD_MUTEX_INITIALIZER, -1, -1, 0, {0}, {{0}}, 0};
static const char* const outside_address[] = {"127.0.0.77", "127.0.0.79"}; /* before and after */
static const char* const inside_address = "127.0.0.78";

static int socket_at(const char* address) {
  struct sockaddr_in own = {0};
  const int made = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  own.sin_family = AF_INET;
  own.sin_addr.s_addr = inet_addr(address);
  bind(made, (struct sockaddr*)&own, sizeof own);
  return made;
}

static int is_same(const struct sockaddr_in* a, const struct sockaddr_in* b) {
  return a->sin_addr.s_addr == b->sin_addr.s_addr && a->sin_port == b->sin_port;
}

static void* let_replies_in(void* number) {
  const int own = *(int*)number;
  static unsigned char packet[2][largest]; /* of each of the router's two ports */
  unsigned char* const bytes = packet[router.sent > 0];
  for (;;) {
    struct sockaddr_in from;
    socklen_t size = sizeof from;
    const ssize_t length = recvfrom(own, bytes, largest, 0, (struct sockaddr*)&from, &size);
    int is_reply = 0;
    unsigned i;
    pthread_mutex_lock(&router.lock);
    for (i = 0; i < router.count; ++i) is_reply = is_reply || is_same(&router.peers[i], &from);
    is_reply = is_reply && own == router.outside;
    pthread_mutex_unlock(&router.lock);
    if (length > 0 && is_reply)
      sendto(router.inside, bytes, (size_t)length, 0, (struct sockaddr*)&router.process,
             sizeof router.process);
  }
  return NULL;
}

/* Sends a packet through the router. Returns 0 if it does not leave the process. */
static int translate(send_function* real, int socket, const struct msghdr* message, int flags) {
  struct msghdr sent = *message;
  struct sockaddr_in own = {0}, to;
  socklen_t size = sizeof own;
  unsigned i;
  if (message->msg_name == NULL || message->msg_namelen != sizeof to) return 0;
  memcpy(&to, message->msg_name, sizeof to);
  if (to.sin_family != AF_INET || getsockname(socket, (struct sockaddr*)&own, &size) != 0) return 0;
  if (own.sin_addr.s_addr == 0) own.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  if (is_same(&own, &to)) return 0;
  pthread_mutex_lock(&router.lock);
  if (router.outside < 0 || router.sent == (long)number("BAD_NETWORK_NAT")) {
    static int outside[2];
    int* const next_port = &outside[router.sent > 0];
    pthread_t thread;
    if (router.inside < 0) router.inside = socket_at(inside_address);
    router.outside = *next_port = socket_at(outside_address[router.sent > 0]);
    router.count = 0;
    pthread_create(&thread, NULL, let_replies_in, next_port);
    pthread_detach(thread);
  }
  ++router.sent;
  router.process = own;
  for (i = 0; i < router.count && !is_same(&router.peers[i], &to); ++i) {
  }
  if (i == router.count && i < most_peers) router.peers[router.count++] = to;
  pthread_mutex_unlock(&router.lock);
  real(router.outside, &sent, flags);
  return 1;
}

static void send_out(send_function* real, int socket, const struct msghdr* message, int flags) {
  if (getenv("BAD_NETWORK_NAT") == NULL || !translate(real, socket, message, flags))
    real(socket, message, flags);
}

/* Counts a packet of the process. True while the wire is cut. */
static int is_cut(int packets) {
  static long sent, end; /* packets, ms */
  struct timespec now;
  long ms;
  if (getenv("BAD_NETWORK_CUT") == NULL) return 0;
  clock_gettime(CLOCK_MONOTONIC, &now);
  ms = 1000 * now.tv_sec + now.tv_nsec / 1000000;
  sent += packets;
  if (end == 0 && sent >= (long)number("BAD_NETWORK_CUT")) end = ms + 4000;
  return ms < end;
}

/* What does not come through the router, does not come. */
ssize_t recvmsg(int socket, struct msghdr* message, int flags) {
  ssize_t (*real)(int, struct msghdr*, int) = NULL;
  *(void**)&real = dlsym(RTLD_NEXT, "recvmsg");
  for (;;) {
    const socklen_t space = message->msg_namelen;
    const ssize_t length = real(socket, message, flags);
    struct sockaddr_in from;
    if (length < 0 || message->msg_name == NULL) return length;
    memcpy(&from, message->msg_name, sizeof from);
    if (!is_cut(0) &&
        (getenv("BAD_NETWORK_NAT") == NULL || from.sin_family != AF_INET ||
         from.sin_addr.s_addr == inet_addr(inside_address) || is_same(&from, &router.process)))
      return length;
    message->msg_namelen = space;
  }
}

ssize_t sendmsg(int socket, const struct msghdr* message, int flags) {
  send_function* real = NULL;
  size_t size = 0, i;
  *(void**)&real = dlsym(RTLD_NEXT, "sendmsg");
  if (getenv("BAD_NETWORK_GARBAGE") != NULL) send_garbage(real, socket, message, flags);
  if (getenv("BAD_NETWORK_JUMP") != NULL) jump(real, socket, message, flags);
  for (i = 0; i < message->msg_iovlen; ++i) size += message->msg_iov[i].iov_len;
  if (is_cut(1) || (double)(next() % 1000000) < 1e6 * number("BAD_NETWORK_LOSS"))
    return (ssize_t)size;
  if (getenv("BAD_NETWORK_DELAY") != NULL &&
      delay(real, socket, message, number("BAD_NETWORK_DELAY"))) {
    return (ssize_t)size;
  }
  send_out(real, socket, message, flags);
  return (ssize_t)size;
}
