// SPDX-License-Identifier: MIT
#include "system/digest.hpp"

#include <climits>
#include <openssl/evp.h>
#include <openssl/sha.h>

#include <cassert>
#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <sys/random.h>

namespace mirocup::system {

namespace {

// Returns the 32 bytes of the digest.
std::string digest_of(std::string_view bytes) {
  std::string digest(SHA256_DIGEST_LENGTH, '\0');
  EVP_Digest(bytes.data(), bytes.size(), reinterpret_cast<unsigned char*>(digest.data()), nullptr,
             EVP_sha256(), nullptr);
  return digest;
}

}  // namespace

std::string hexadecimal(std::string_view bytes) {
  constexpr char digits[] = "0123456789abcdef";
  std::string text(2 * bytes.size(), '0');
  char* next = text.data();  // books of leagues have a digest in each line
  for (const char c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    *next++ = digits[byte >> 4];
    *next++ = digits[byte & 15];
  }
  return text;
}

std::string sha256(std::string_view bytes) {
  return hexadecimal(digest_of(bytes));
}

std::string sha256_base64(std::string_view bytes) {
  return base64(digest_of(bytes));
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

Sha256::Sha256() : context_(EVP_MD_CTX_new(), EVP_MD_CTX_free) {
  EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr);
}

void Sha256::add(std::string_view bytes) {
  EVP_DigestUpdate(context_.get(), bytes.data(), bytes.size());
}

std::string Sha256::digits() {
  std::string digest(SHA256_DIGEST_LENGTH, '\0');
  EVP_DigestFinal_ex(context_.get(), reinterpret_cast<unsigned char*>(digest.data()), nullptr);
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
