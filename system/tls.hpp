// SPDX-License-Identifier: MIT
//
// TLS for a server and for a client: their certificates, and one encrypted connection. TLS 1.2 or
// later.
//
// Threads: a TlsServer and a TlsClient may be used in several threads at once; one thread uses a
// TlsConnection.
#pragma once

#include "core/base/error.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <sys/types.h>

struct ssl_ctx_st;  // SSL_CTX of OpenSSL
struct ssl_st;      // SSL of OpenSSL

namespace mirocup::system {

// An encrypted connection over a socket that the caller owns. Not to be used after an error.
class TlsConnection {
 public:
  // Reads up to `size` bytes. Returns the number of read bytes; 0 after the other end's last byte;
  // a negative number after an error or if nothing comes within `ms`.
  ssize_t read(char* bytes, std::size_t size, int ms);

  // Writes all bytes. Returns the number of bytes; a negative number after an error or if the other
  // end receives nothing for `ms`.
  ssize_t write(std::string_view bytes, int ms);

  // Tells the other end that no more bytes follow.
  void say_end();

 private:
  friend class TlsServer;
  friend class TlsClient;
  TlsConnection();
  // Attaches the session to the socket, which then does not wait. Returns false after an error.
  bool attach(ssl_ctx_st* context, int socket);
  // Repeats a call of the library, which does not wait, until it is done. Returns its result; 0 at
  // the end of the connection, negative after an error or at the end of the time.
  template <class Call>
  int repeat(int ms, const Call& call);

  std::unique_ptr<ssl_st, void (*)(ssl_st*)> ssl_;
  int socket_ = -1;
};

class TlsServer {
 public:
  // Reads two PEM files: `certificate` (the server's, then the certificates up to its root) and
  // `key` (the server's). The error (Errc::input) names the file and the reason.
  static Result<TlsServer> load(const std::string& certificate, const std::string& key);

  // Agrees on the encryption of a new connection. Returns nothing if the other end does not speak
  // TLS or needs more than `ms`.
  std::optional<TlsConnection> accept(int socket, int ms) const;

 private:
  std::shared_ptr<ssl_ctx_st> context_;
};

// Why a TlsClient does not trust a server or cannot talk to it.
enum class TlsRefusal { not_tls, not_trusted };

class TlsClient {
 public:
  // Reads the certificates that may sign for a server: those in the PEM file `authority`, or the
  // system's if `authority` is "". The error (Errc::input) names the file and the reason.
  static Result<TlsClient> load(const std::string& authority);

  // Agrees on the encryption of a new connection with the server `host`, a name or an IP address,
  // within `ms`. The server's certificate must be valid for `host`.
  tl::expected<TlsConnection, TlsRefusal> connect(int socket, const std::string& host,
                                                  int ms) const;

 private:
  std::shared_ptr<ssl_ctx_st> context_;
};

// Returns the moment until which a certificate (PEM) is valid, in seconds since 1970 UTC; nothing
// if the text is not a certificate.
std::optional<std::int64_t> certificate_end(std::string_view pem);

}  // namespace mirocup::system
