// SPDX-License-Identifier: MIT
//
// SHA-256 digests, base64 (RFC 4648, with padding), and random bytes that nobody can guess.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

struct evp_md_ctx_st;  // EVP_MD_CTX of OpenSSL

namespace mirocup::system {

// Returns the bytes as lower-case hexadecimal digits.
std::string hexadecimal(std::string_view bytes);

// Returns the digest as 64 lower-case hexadecimal digits.
std::string sha256(std::string_view bytes);

// Returns the digest's 32 bytes in base64, as a content security policy names a script.
std::string sha256_base64(std::string_view bytes);

std::string base64(std::string_view bytes);

// The SHA-256 of bytes that come in parts.
class Sha256 {
 public:
  Sha256();

  void add(std::string_view bytes);

  // Returns the digest of all parts as 64 lower-case hexadecimal digits. To be called only once.
  std::string digits();

 private:
  std::unique_ptr<evp_md_ctx_st, void (*)(evp_md_ctx_st*)> context_;
};

// Returns bytes from the random numbers of the kernel, for keys and names that nobody can guess.
std::string random_bytes(std::size_t count);

// Returns the bytes in base32 (RFC 4648, without padding): letters A to Z and digits 2 to 7. 16
// bytes make 26 characters.
std::string base32(std::string_view bytes);

}  // namespace mirocup::system
