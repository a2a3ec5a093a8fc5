// SPDX-License-Identifier: MIT
#include "plugins/host/project/unpack.hpp"

#include <algorithm>
#include <archive.h>
#include <archive_entry.h>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <memory>
#include <unistd.h>
#include <vector>

namespace mirocup::plugins {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t block = 65536;  // bytes

struct Close {
  void operator()(archive* open) const { archive_read_free(open); }
};
using Reader = std::unique_ptr<archive, Close>;

// The name, for a sentence: without bytes that a terminal would obey.
std::string printable_name(const std::string& name) {
  constexpr std::size_t enough = 80;  // bytes
  std::string text = name.substr(0, enough);
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < ' ' || c > '~'; }, '?');
  return '"' + text + '"';
}

tl::unexpected<Error> refuse(const std::string& name, const std::string& why) {
  return fail(Errc::input, printable_name(name) + " in the archive " + why);
}

std::vector<std::string> parts_of(const std::string& path) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= path.size();) {
    const std::size_t end = std::min(path.find('/', begin), path.size());
    std::string part = path.substr(begin, end - begin);
    begin = end + 1;
    if (!part.empty() && part != ".") parts.push_back(std::move(part));
  }
  return parts;
}

// Returns why a name is not taken; "" if it is.
std::string objection_to_name(const std::string& path, const std::vector<std::string>& parts,
                              const UnpackLimits& limits) {
  if (path.size() > limits.path) return "has a name that is too long";
  if (path.starts_with('/')) return "has a path from the root; pack it from inside its folder";
  if (static_cast<int>(parts.size()) > limits.depth + 1) return "is below too many folders";
  for (const std::string& part : parts) {
    if (part == "..") return "leads out of the archive";
    // A compiler would read the first as an option and the second as a file of options.
    if (part.starts_with('-') || part.starts_with('@'))
      return "has a name that starts with '-' or '@'";
    const bool is_plain = std::all_of(part.begin(), part.end(), [](unsigned char c) {
      return c >= ' ' && c != 0x7f && c != '\\' && c != '"';
    });
    if (!is_plain) return "has a character in its name that is not allowed in names of files";
  }
  return "";
}

bool is_left_out(const std::vector<std::string>& parts) {
  return std::any_of(parts.begin(), parts.end(), [](const std::string& part) {
    return part.starts_with('.') || part == "build" || part == "__MACOSX";
  });
}

class Unpacking {
 public:
  Unpacking(archive* from, const std::string& folder, const UnpackLimits& limits)
      : from_(from), folder_(folder), limits_(limits) {}

  Result<void> take(archive_entry* entry) {
    const char* given = archive_entry_pathname(entry);
    const std::string name = given != nullptr ? given : "";
    if (++files_ > limits_.files)
      return fail(Errc::input,
                  "the archive has more than " + std::to_string(limits_.files) + " files");
    const auto parts = parts_of(name);
    if (const std::string why = objection_to_name(name, parts, limits_); !why.empty())
      return refuse(name, why);
    if (archive_entry_is_encrypted(entry) != 0) return refuse(name, "is encrypted");
    if (archive_entry_hardlink(entry) != nullptr || archive_entry_filetype(entry) == AE_IFLNK)
      return refuse(name, "is a link; pack the file itself");
    const auto type = archive_entry_filetype(entry);
    if (type == AE_IFDIR) return {};
    if (type != AE_IFREG) return refuse(name, "is no file");
    if (parts.empty()) return refuse(name, "has no name");
    if (is_left_out(parts)) return copy(name, -1);
    fs::path path = folder_;
    for (const std::string& part : parts) path /= part;
    std::error_code error;
    fs::create_directories(path.parent_path(), error);
    const int out = open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0644);
    if (error || out < 0) return refuse(name, "is there twice, or both as a file and as a folder");
    auto copied = copy(name, out);
    close(out);
    return copied;
  }

 private:
  // Reads a file to its end and writes it there; -1: nowhere. A hole of a file counts as its bytes.
  Result<void> copy(const std::string& name, int out) {
    std::uint64_t size = 0;
    std::vector<char> bytes(block);
    while (true) {
      const auto count = archive_read_data(from_, bytes.data(), bytes.size());
      if (count == 0) return {};
      if (count < 0)
        return refuse(name,
                      "cannot be read: it is damaged, or packed in a way that is not supported");
      const auto read = static_cast<std::uint64_t>(count);
      size += read;
      read_ += read;
      if (out >= 0) kept_ += read;
      if (read_ > limits_.read || kept_ > limits_.all || (out >= 0 && size > limits_.file))
        return refuse(name, "is too large, or makes the archive too large: a file has at most " +
                                std::to_string(limits_.file >> 20) + " MiB, and all together " +
                                std::to_string(limits_.all >> 20) + " MiB");
      if (out >= 0 && write(out, bytes.data(), read) != count)
        return fail(Errc::host, std::string("a file cannot be written: ") + std::strerror(errno));
    }
  }

  archive* from_;
  const std::string& folder_;
  const UnpackLimits& limits_;
  int files_ = 0;
  std::uint64_t read_ = 0;
  std::uint64_t kept_ = 0;
};

}  // namespace

Result<void> unpack(const std::string& path, const std::string& folder,
                    const UnpackLimits& limits) {
  const Reader reader(archive_read_new());
  archive* const from = reader.get();
  // Nothing else: no archive in an archive, and no other way of packing.
  archive_read_support_filter_gzip(from);
  archive_read_support_format_tar(from);
  archive_read_support_format_zip(from);
  constexpr const char* no_archive = "it is no archive: tar, tar.gz or zip is expected";
  if (archive_read_open_filename(from, path.c_str(), block) != ARCHIVE_OK)
    return fail(Errc::input, no_archive);
  Unpacking unpacking(from, folder, limits);
  bool is_empty = true;
  while (true) {
    archive_entry* entry = nullptr;
    const int next = archive_read_next_header(from, &entry);
    if (next == ARCHIVE_EOF) break;
    if (next != ARCHIVE_OK && next != ARCHIVE_WARN)
      return fail(Errc::input, is_empty ? no_archive : "the archive is damaged or cut off");
    is_empty = false;
    if (auto taken = unpacking.take(entry); !taken) return taken;
  }
  if (is_empty) return fail(Errc::input, "the archive is empty");
  return {};
}

}  // namespace mirocup::plugins
