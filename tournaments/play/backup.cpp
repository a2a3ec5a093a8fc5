// SPDX-License-Identifier: MIT
#include "tournaments/play/backup.hpp"

#include "record/match_record.hpp"

#include <algorithm>
#include <filesystem>
#include <map>

namespace mirocup::league {

namespace {

namespace fs = std::filesystem;

// What is made again, or belongs to running processes. Names of files of this program that wait for
// their last name have "unfinished" in them.
bool is_left_out(const std::string& name) {
  return name == "site" || name == ".lock" || name == ".running" || name == ".submitting" ||
         name == ".checking" || name == ".uploads" ||
         name.find(".unfinished-") != std::string::npos;
}

class Backup {
 public:
  Backup(system::Files& files, const Folder& from, const Folder& to)
      : files_(files), from_(from), to_(to) {}

  Result<BackupCount> run() {
    MIROCUP_TRY_VOID(expect_place());
    // Read before everything that they name.
    std::map<std::string, std::string> journals;
    for (const std::string& path : {from_.journal(), from_.hand_in_book()}) {
      MIROCUP_TRY(auto there, files_.read_if_there(path, {.max_size = system::size_limit::journal,
                                                          .growth = system::Growth::ignored}));
      if (!there) continue;
      std::string& text = journals[fs::path(path).filename()] = std::move(*there);
      // A line that is being written has no end yet.
      text.resize(text.rfind('\n') == std::string::npos ? 0 : text.rfind('\n') + 1);
    }
    MIROCUP_TRY_VOID(expect_earlier(journals["journal.jsonl"]));
    MIROCUP_TRY_VOID(folder("", "journal.jsonl", "hand-ins.jsonl"));
    for (const auto& [name, text] : journals) {
      const auto readers =
          name == "journal.jsonl" ? system::Readers::everybody : system::Readers::owner;
      MIROCUP_TRY_VOID(files_.write(to_.path + "/" + name, text, readers));
      ++count_.copied;
    }
    return count_;
  }

 private:
  // In the league's own folder the journal of a moment ago would replace the present one, and each
  // copy would have all earlier ones in it.
  Result<void> expect_place() const {
    std::error_code none;
    const fs::path league = fs::weakly_canonical(fs::absolute(from_.path), none);
    const fs::path copy = fs::weakly_canonical(fs::absolute(to_.path), none);
    const auto [end, same] = std::mismatch(league.begin(), league.end(), copy.begin(), copy.end());
    if (end == league.end())
      return fail(Errc::input, to_.path + " is in the folder of the league itself");
    MIROCUP_TRY(const auto there, files_.names_if_there(to_.path));
    if (!there.empty() && !files_.exists(to_.config()))
      return fail(Errc::input, to_.path + " is neither empty nor a copy of a league");
    return {};
  }

  // An earlier copy knows the beginning of what this league has decided, and nothing else.
  Result<void> expect_earlier(const std::string& journal) const {
    MIROCUP_TRY(const auto there,
                files_.read_if_there(to_.journal(), {.max_size = system::size_limit::journal,
                                                     .growth = system::Growth::ignored}));
    if (!there || journal.starts_with(*there)) return {};
    return fail(
        Errc::input,
        to_.path +
            " is a copy of another league, or legs were played in the copy: this league's "
            "journal does not begin with the lines of the copy's journal; name a new folder");
  }

  // Copies a folder of the league, `inside` (""; or with its slash at the end).
  Result<void> folder(const std::string& inside, std::string_view skipped = "",
                      std::string_view skipped_too = "") {
    const std::string path = from_.path + "/" + inside;
    MIROCUP_TRY(const auto names, files_.names_in(path));
    std::error_code failed;
    const bool is_closed = (fs::status(path, failed).permissions() &
                            (fs::perms::group_all | fs::perms::others_all)) == fs::perms::none;
    MIROCUP_TRY_VOID(files_.make_folder(
        to_.path + "/" + inside, is_closed ? system::Readers::owner : system::Readers::everybody));
    for (const std::string& name : names) {
      if (is_left_out(name) || name == skipped || name == skipped_too) continue;
      const std::string one = inside + name;
      const fs::file_status status = fs::symlink_status(from_.path + "/" + one, failed);
      if (status.type() == fs::file_type::none)
        return fail(Errc::unavailable, from_.path + "/" + one + ": " + failed.message());
      auto copied = fs::is_directory(status) ? folder(one + "/")
                    : fs::is_regular_file(status)
                        ? file(one, status.permissions(), inside == "records/")
                        : Result<void>();
      if (!copied) return copied;
    }
    return {};
  }

  // A record that was written after the names were read has its replay beside it.
  Result<void> file(const std::string& name, fs::perms permissions, bool is_record) {
    if (is_record && name.ends_with(".json")) {
      const std::string replay = record::replay_path_of(name);
      if (files_.exists(from_.path + "/" + replay)) {
        if (auto copied = bytes(replay, permissions, true); !copied) return copied;
      }
    }
    return bytes(name, permissions,
                 is_record && (name.ends_with(".json") || name.ends_with(".zst")));
  }

  Result<void> bytes(const std::string& name, fs::perms permissions, bool never_changes) {
    const std::string to = to_.path + "/" + name;
    if (never_changes && files_.exists(to)) {
      ++count_.known;
      return {};
    }
    MIROCUP_TRY(const auto text, files_.read_if_there(from_.path + "/" + name,
                                                      {.max_size = 4 * system::size_limit::replay,
                                                       .growth = system::Growth::ignored}));
    // What ends between two looks is not there any more: the output of a check, a version that is
    // pruned.
    if (!text) return {};
    const bool is_closed =
        (permissions & (fs::perms::group_all | fs::perms::others_all)) == fs::perms::none;
    MIROCUP_TRY_VOID(
        files_.write(to, *text, is_closed ? system::Readers::owner : system::Readers::everybody));
    if ((permissions & fs::perms::owner_exec) != fs::perms::none) {
      std::error_code failed;
      fs::permissions(to, permissions, failed);
      if (failed) return fail(Errc::unavailable, to + ": " + failed.message());
    }
    ++count_.copied;
    return {};
  }

  system::Files& files_;
  const Folder& from_;
  const Folder& to_;
  BackupCount count_;
};

}  // namespace

Result<BackupCount> back_up(system::Files& files, const Folder& from, const Folder& to) {
  return Backup(files, from, to).run();
}

}  // namespace mirocup::league
