// SPDX-License-Identifier: MIT
#include "system/tls.hpp"

#include <climits>
#include <openssl/bio.h>
#include <openssl/err.h>
#include <openssl/pem.h>
#include <openssl/ssl.h>
#include <openssl/x509.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <ctime>
#include <fcntl.h>
#include <poll.h>

namespace mirocup::system {

namespace {

using std::chrono::steady_clock;

std::string reason() {
  const unsigned long code = ERR_get_error();
  ERR_clear_error();
  const char* text = code != 0 ? ERR_reason_error_string(code) : nullptr;
  return text != nullptr ? text : "it cannot be read";
}

bool waits_for(int socket, short event, steady_clock::time_point until) {
  while (true) {
    const auto left =
        std::chrono::duration_cast<std::chrono::milliseconds>(until - steady_clock::now()).count();
    if (left <= 0) return false;
    pollfd waiting{.fd = socket, .events = event, .revents = 0};
    const int ready = poll(&waiting, 1, static_cast<int>(std::min<long>(left, INT_MAX)));
    if (ready > 0) return true;
    if (ready == 0 || errno != EINTR) return false;
  }
}

std::shared_ptr<SSL_CTX> new_context(const SSL_METHOD* method) {
  ERR_clear_error();
  std::shared_ptr<SSL_CTX> context(SSL_CTX_new(method), SSL_CTX_free);
  SSL_CTX_set_min_proto_version(context.get(), TLS1_2_VERSION);
  SSL_CTX_set_mode(context.get(), SSL_MODE_ACCEPT_MOVING_WRITE_BUFFER);
  return context;
}

}  // namespace

TlsConnection::TlsConnection() : ssl_(nullptr, SSL_free) {}

template <class Call>
int TlsConnection::repeat(int ms, const Call& call) {
  const auto until = steady_clock::now() + std::chrono::milliseconds(ms);
  while (true) {
    ERR_clear_error();
    const int result = call();
    if (result > 0) return result;
    const int error = SSL_get_error(ssl_.get(), result);
    if (error == SSL_ERROR_ZERO_RETURN) return 0;
    if (error != SSL_ERROR_WANT_READ && error != SSL_ERROR_WANT_WRITE) return -1;
    if (!waits_for(socket_, error == SSL_ERROR_WANT_READ ? POLLIN : POLLOUT, until)) return -1;
  }
}

ssize_t TlsConnection::read(char* bytes, std::size_t size, int ms) {
  const int most = static_cast<int>(std::min<std::size_t>(size, INT_MAX));
  return repeat(ms, [&] { return SSL_read(ssl_.get(), bytes, most); });
}

ssize_t TlsConnection::write(std::string_view bytes, int ms) {
  if (bytes.empty()) return 0;
  const int size = static_cast<int>(std::min<std::size_t>(bytes.size(), INT_MAX));
  const int done = repeat(ms, [&] { return SSL_write(ssl_.get(), bytes.data(), size); });
  return done > 0 ? done : -1;
}

void TlsConnection::say_end() {
  ERR_clear_error();
  SSL_shutdown(ssl_.get());
}

bool TlsConnection::attach(ssl_ctx_st* context, int socket) {
  socket_ = socket;
  ssl_.reset(SSL_new(context));
  const int flags = fcntl(socket, F_GETFL);
  return ssl_ != nullptr && flags >= 0 && fcntl(socket, F_SETFL, flags | O_NONBLOCK) == 0 &&
         SSL_set_fd(ssl_.get(), socket) == 1;
}

Result<TlsServer> TlsServer::load(const std::string& certificate, const std::string& key) {
  TlsServer server;
  server.context_ = new_context(TLS_server_method());
  SSL_CTX* const context = server.context_.get();
  // Viewers come and go; nobody keeps state for them.
  SSL_CTX_set_session_cache_mode(context, SSL_SESS_CACHE_OFF);
  SSL_CTX_set_options(context, SSL_OP_NO_RENEGOTIATION | SSL_OP_IGNORE_UNEXPECTED_EOF);
  if (SSL_CTX_use_certificate_chain_file(context, certificate.c_str()) != 1)
    return fail(Errc::input, certificate + " is no certificate in a PEM file: " + reason());
  if (SSL_CTX_use_PrivateKey_file(context, key.c_str(), SSL_FILETYPE_PEM) != 1)
    return fail(Errc::input,
                key + " is not the key of " + certificate + " in a PEM file: " + reason());
  return server;
}

std::optional<TlsConnection> TlsServer::accept(int socket, int ms) const {
  TlsConnection connection;
  if (!connection.attach(context_.get(), socket)) return std::nullopt;
  SSL* const ssl = connection.ssl_.get();
  if (connection.repeat(ms, [ssl] { return SSL_accept(ssl); }) != 1) return std::nullopt;
  return connection;
}

Result<TlsClient> TlsClient::load(const std::string& authority) {
  TlsClient client;
  client.context_ = new_context(TLS_client_method());
  SSL_CTX* const context = client.context_.get();
  SSL_CTX_set_options(context, SSL_OP_NO_RENEGOTIATION);
  SSL_CTX_set_verify(context, SSL_VERIFY_PEER, nullptr);
  if (authority.empty()) {
    SSL_CTX_set_default_verify_paths(context);
  } else if (SSL_CTX_load_verify_file(context, authority.c_str()) != 1) {
    return fail(Errc::input, authority + " is no certificate in a PEM file: " + reason());
  }
  return client;
}

tl::expected<TlsConnection, TlsRefusal> TlsClient::connect(int socket, const std::string& host,
                                                           int ms) const {
  TlsConnection connection;
  const tl::unexpected not_tls(TlsRefusal::not_tls);
  if (!connection.attach(context_.get(), socket)) return not_tls;
  SSL* const ssl = connection.ssl_.get();
  X509_VERIFY_PARAM* const terms = SSL_get0_param(ssl);
  if (X509_VERIFY_PARAM_set1_ip_asc(terms, host.c_str()) != 1 &&
      (SSL_set1_host(ssl, host.c_str()) != 1 || SSL_set_tlsext_host_name(ssl, host.c_str()) != 1))
    return not_tls;
  if (connection.repeat(ms, [ssl] { return SSL_connect(ssl); }) == 1) return connection;
  if (SSL_get_verify_result(ssl) == X509_V_OK) return not_tls;
  return tl::unexpected(TlsRefusal::not_trusted);
}

std::optional<std::int64_t> certificate_end(std::string_view pem) {
  const std::unique_ptr<BIO, int (*)(BIO*)> text(
      BIO_new_mem_buf(pem.data(), static_cast<int>(pem.size())), BIO_free);
  if (text == nullptr) return std::nullopt;
  const std::unique_ptr<X509, void (*)(X509*)> certificate(
      PEM_read_bio_X509(text.get(), nullptr, nullptr, nullptr), X509_free);
  tm end{};
  if (certificate == nullptr || ASN1_TIME_to_tm(X509_get0_notAfter(certificate.get()), &end) != 1) {
    return std::nullopt;
  }
  return timegm(&end);
}

}  // namespace mirocup::system
