// SPDX-License-Identifier: MIT
#include "system/digest.hpp"

#include <climits>
#include <openssl/evp.h>
#include <openssl/sha.h>

#include <array>
#include <cassert>
#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <sys/random.h>

namespace mirocup::system {

namespace {

std::array<unsigned char, SHA256_DIGEST_LENGTH> digest_of(std::string_view bytes) {
  std::array<unsigned char, SHA256_DIGEST_LENGTH> digest;
  EVP_Digest(bytes.data(), bytes.size(), digest.data(), nullptr, EVP_sha256(), nullptr);
  return digest;
}

std::string hexadecimal(const std::array<unsigned char, SHA256_DIGEST_LENGTH>& digest) {
  constexpr char digits[] = "0123456789abcdef";
  std::string text(2 * digest.size(), '0');
  char* next = text.data();  // books of leagues have a digest in each line
  for (const unsigned char byte : digest) {
    *next++ = digits[byte >> 4];
    *next++ = digits[byte & 15];
  }
  return text;
}

}  // namespace

std::string sha256(std::string_view bytes) {
  return hexadecimal(digest_of(bytes));
}

std::string sha256_base64(std::string_view bytes) {
  const auto digest = digest_of(bytes);
  return base64({reinterpret_cast<const char*>(digest.data()), digest.size()});
}

std::string base64(std::string_view bytes) {
  assert(bytes.size() < INT_MAX / 2);
  const std::size_t size = (bytes.size() + 2) / 3 * 4;
  std::string text(size + 1, '\0');  // with the zero that EVP_EncodeBlock() writes
  EVP_EncodeBlock(reinterpret_cast<unsigned char*>(text.data()),
                  reinterpret_cast<const unsigned char*>(bytes.data()),
                  static_cast<int>(bytes.size()));
  text.resize(size);
  return text;
}

struct Sha256::Context {
  EVP_MD_CTX* handle = EVP_MD_CTX_new();
  ~Context() { EVP_MD_CTX_free(handle); }
};

Sha256::Sha256() : context_(std::make_unique<Context>()) {
  EVP_DigestInit_ex(context_->handle, EVP_sha256(), nullptr);
}
Sha256::~Sha256() = default;
Sha256::Sha256(Sha256&&) noexcept = default;
Sha256& Sha256::operator=(Sha256&&) noexcept = default;

void Sha256::add(std::string_view bytes) {
  EVP_DigestUpdate(context_->handle, bytes.data(), bytes.size());
}

std::string Sha256::digits() {
  std::array<unsigned char, SHA256_DIGEST_LENGTH> digest{};
  EVP_DigestFinal_ex(context_->handle, digest.data(), nullptr);
  return hexadecimal(digest);
}

std::string random_bytes(std::size_t count) {
  std::string bytes(count, '\0');
  std::size_t done = 0;
  while (done < count) {
    const ssize_t got = getrandom(bytes.data() + done, count - done, 0);
    if (got < 0 && errno != EINTR) std::abort();  // a key that could be guessed is worse
    if (got > 0) done += static_cast<std::size_t>(got);
  }
  return bytes;
}

std::string base32(std::string_view bytes) {
  constexpr char letters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZ234567";
  constexpr unsigned bits_of_letter = 5;
  std::string text;
  std::uint32_t waiting = 0;  // bits that are not written yet, the last ones lowest
  unsigned count = 0;         // of them
  for (const unsigned char byte : bytes) {
    waiting = waiting << 8 | byte;
    for (count += 8; count >= bits_of_letter; count -= bits_of_letter)
      text += letters[waiting >> (count - bits_of_letter) & 31];
    waiting &= (1u << count) - 1;
  }
  if (count > 0) text += letters[waiting << (bits_of_letter - count) & 31];
  return text;
}

}  // namespace mirocup::system
