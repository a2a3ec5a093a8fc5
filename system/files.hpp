// SPDX-License-Identifier: MIT
//
// Access to the disk. A reading caller gives the largest size of the file, and whether its name may
// be a link. Only regular files are read, so no reader waits for a pipe or reads a device without
// an end. A file that write() replaces is at any moment either the old or the new file, also after
// a crash. Appended bytes are on disk when append() returns. Tests replace the disk by a disk with
// faults.
//
// Below the folders of follow_no_links_below() (links.hpp) each function refuses every link of a
// path, apart from a file that the host names (Links::followed).
//
// Errors name the file and the reason: Errc::input if the file is of the wrong kind, too large or
// a link; Errc::unavailable if the system refuses.
#pragma once

#include "core/base/error.hpp"
#include "system/descriptor.hpp"
#include "system/digest.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <sys/types.h>
#include <vector>

namespace mirocup::system {

// The largest size of a file of each kind, bytes. Each limit is several times larger than a useful
// file, and small enough for memory.
namespace size_limit {
inline constexpr std::uint64_t entry = 32u << 20;        // a handed-in strategy
inline constexpr std::uint64_t scene = 64u << 20;        // a scene, or one situation of a league
inline constexpr std::uint64_t trace = 256u << 20;       // situations, one a line
inline constexpr std::uint64_t record = 64u << 20;       // the JSON of a leg
inline constexpr std::uint64_t replay = 256u << 20;      // the commands of a leg, compressed
inline constexpr std::uint64_t league_file = 4u << 20;   // league.json
inline constexpr std::uint64_t journal = 256u << 20;     // the journal of a league
inline constexpr std::uint64_t page = 256u << 20;        // a page that our programs have made
inline constexpr std::uint64_t note = 4u << 20;          // verdicts, plans and other small JSON
inline constexpr std::uint64_t certificate = 1u << 20;   // a file of credentials
inline constexpr std::uint64_t log = 16u << 20;          // the output of a child process
inline constexpr std::uint64_t system_file = 64u << 20;  // a file of the installation
}  // namespace size_limit

enum class Links {
  refused,   // a user who may write into the folder could link to a file that only the host reads
  followed,  // for a file that the host itself has named, on the command line
};

enum class Growth {
  refused,  // an error: the file must not change while it is read
  ignored,  // another process may append: only the bytes that the file had when opened are read
};

// Limits of a file that is read.
struct ReadOptions {
  std::uint64_t max_size;  // bytes; a larger file is refused before its first byte is read
  Links links = Links::refused;
  Growth growth = Growth::refused;
  std::string_view if_too_large = "";  // end of the message: a remedy for the file's owner
};

// A regular file that is open for reading, and its properties at the time of opening.
struct OpenFile {
  std::string path;
  ReadOptions options;
  Descriptor descriptor{};
  std::uint64_t size = 0;     // bytes
  std::int64_t modified = 0;  // ns since 1970 of the last change of its bytes
};

// Opens a file without waiting, neither for the other end of a pipe nor for the holder of a lease.
Result<OpenFile> open_file(const std::string& path, const ReadOptions& options);

// True if the path names a device, a pipe or something that is already open, for example /dev/null
// or /dev/stdout. Such a target is written in place: a file must not replace it, and no temporary
// file can stand beside it. False if the path, for example a link, belongs to another user.
bool is_written_in_place(const std::string& path);

// Returns a copy of the bytes in memory: a file without a name that can be run and that nobody can
// change. Errors: Errc::unavailable.
Result<Descriptor> sealed_copy(std::string_view bytes);

// Reads the file from `offset` to its size at the time of opening.
Result<std::string> read_file(const OpenFile& file, std::uint64_t offset = 0);

// The users who may read a written file. Only its owner may write it again.
enum class Readers {
  everybody,  // mode 0644, folders 0755, without the bits of the umask
  owner,      // mode 0600, folders 0700
};

class Files {
 public:
  virtual ~Files() = default;

  virtual Result<std::string> read(const std::string& path, const ReadOptions& options) = 0;

  // Reads a file that the host has named, for example on the command line: its name may be a link.
  Result<std::string> read_named(const std::string& path, std::uint64_t max_size) {
    return read(path, {.max_size = max_size, .links = Links::followed});
  }

  // Returns the file's bytes from `offset` on.
  virtual Result<std::string> read_from(const std::string& path, std::size_t offset,
                                        const ReadOptions& options);

  // Reads a file that a program of ours keeps; returns nothing if no file has that name. If the
  // file is there but cannot be read, the error is Errc::damaged if it is of the wrong kind, too
  // large or a link, and otherwise Errc::unavailable.
  Result<std::optional<std::string>> read_if_there(const std::string& path,
                                                   const ReadOptions& options,
                                                   std::size_t offset = 0);

  // Replaces the file: writes a temporary file in the same folder, flushes it to disk, renames it
  // and flushes the folder. The temporary file is always a new file, with a name that nobody can
  // guess. If another user has put a link at `path`, the link is replaced and its target untouched.
  // If is_written_in_place(path), writes the bytes into `path` itself.
  virtual Result<void> write(const std::string& path, std::string_view bytes,
                             Readers readers = Readers::everybody) = 0;

  // Writes the file unless it has these bytes already.
  Result<void> update(const std::string& path, std::string_view bytes);

  // Removes the temporary files of killed writers from the folder and all folders below it. Files
  // that are being written stay.
  virtual Result<void> remove_unfinished(const std::string& folder) = 0;

  // Appends to a regular file and flushes to disk. A link is refused.
  virtual Result<void> append(const std::string& path, std::string_view bytes) = 0;

  // Cuts the file to its first `size` bytes.
  virtual Result<void> truncate(const std::string& path, std::size_t size) = 0;

  // Returns false only if no file has the name. If the system cannot tell, or if a link on the way
  // leads to nothing, returns true; reading the file then gives the reason.
  virtual bool exists(const std::string& path) = 0;

  // Makes the folder and its missing parents. With Readers::owner the folder, but not its parents,
  // is closed to other users, even if it existed before; a folder of another user is refused.
  virtual Result<void> make_folder(const std::string& path,
                                   Readers readers = Readers::everybody) = 0;

  // Returns the names in a folder, sorted by their bytes.
  virtual Result<std::vector<std::string>> names_in(const std::string& folder) = 0;

  // Like the function above, but returns no names if the folder does not exist.
  Result<std::vector<std::string>> names_if_there(const std::string& folder);

  // Removes a file, or a folder with the files in it, but no folder with a folder in it. A link is
  // not followed. A missing file is not an error.
  virtual Result<void> remove(const std::string& path) = 0;
};

// True if the name is that of a temporary file of Files::write() or IncomingFile: a process is
// writing this file, or died and left it.
bool is_unfinished(const std::string& path);

// A file that arrives in parts, for example over a network, and is hashed on its way. It has a
// temporary name in the folder of its later path until keep() moves the file to its path. The
// destructor removes a file that is not kept; after a crash Files::remove_unfinished() does.
class IncomingFile {
 public:
  // Begins a file that only its owner can read. The folder must exist.
  static Result<IncomingFile> begin(const std::string& path);
  IncomingFile(IncomingFile&& other) noexcept = default;
  IncomingFile& operator=(IncomingFile&& other) noexcept = default;
  ~IncomingFile();

  // Errc::no_room if the disk is full.
  Result<void> add(std::string_view bytes);
  std::uint64_t size() const { return size_; }

  // Flushes the file to disk and returns its SHA-256. After this call nothing can be added.
  Result<std::string> finish();

  // Renames the finished file to a path on the same disk; the new name is then also on disk.
  Result<void> keep(const std::string& path);

 private:
  IncomingFile() = default;

  std::string path_;  // the temporary name
  Descriptor descriptor_{};
  std::uint64_t size_ = 0;
  Sha256 digest_;
};

// The real disk. The class has no state, so any number of objects may be used from any thread.
class Disk : public Files {
 public:
  Result<std::string> read(const std::string& path, const ReadOptions& options) override;
  Result<std::string> read_from(const std::string& path, std::size_t offset,
                                const ReadOptions& options) override;
  Result<void> write(const std::string& path, std::string_view bytes,
                     Readers readers = Readers::everybody) override;
  Result<void> remove_unfinished(const std::string& folder) override;
  Result<void> append(const std::string& path, std::string_view bytes) override;
  Result<void> truncate(const std::string& path, std::size_t size) override;
  bool exists(const std::string& path) override;
  Result<void> make_folder(const std::string& path, Readers readers = Readers::everybody) override;
  Result<std::vector<std::string>> names_in(const std::string& folder) override;
  Result<void> remove(const std::string& path) override;
};

}  // namespace mirocup::system
