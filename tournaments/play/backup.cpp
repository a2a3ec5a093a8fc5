// SPDX-License-Identifier: MIT
#include "tournaments/play/backup.hpp"

#include <algorithm>
#include <filesystem>
#include <utility>
#include <vector>

namespace mirocup::league {

namespace {

namespace fs = std::filesystem;

// Files inside the league that are made again, belong to running processes, or are copied at last.
// Names of files of this program that wait for their last name have "unfinished" in them.
bool is_left_out(const std::string& path) {
  static const std::set<std::string> left_out{
      "site",         ".lock",         ".running",         ".submitting",
      ".handing-in",  ".checking",     "entries/.uploads", "journal.jsonl",
      "journal.head", "hand-ins.jsonl"};
  return left_out.contains(path) || path.find(".unfinished-") != std::string::npos;
}

system::Readers readers_of(fs::perms permissions) {
  const fs::perms others = fs::perms::group_all | fs::perms::others_all;
  return (permissions & others) == fs::perms::none ? system::Readers::owner
                                                   : system::Readers::everybody;
}

class Backup {
 public:
  Backup(system::Files& files, const Folder& from, const Folder& to)
      : files_(files), from_(from), to_(to) {}

  Result<BackupCount> run() {
    MIROCUP_TRY_VOID(expect_place());
    for (const char* part : {"records/", "nights/"}) {
      MIROCUP_TRY(const auto names, files_.names_if_there(from_.path + "/" + part));
      for (const std::string& name : names) before_.insert(part + name);
    }
    // Read before everything that they name. The head is older than its journal, not younger.
    std::vector<std::pair<std::string, std::string>> journals;
    for (const std::string& path : {from_.journal_head(), from_.journal(), from_.hand_in_book()}) {
      MIROCUP_TRY(auto there, files_.read_if_there(path, {.max_size = system::size_limit::journal,
                                                          .growth = system::Growth::ignored}));
      if (!there) continue;
      // A line that is being written has no end yet.
      there->resize(there->rfind('\n') == std::string::npos ? 0 : there->rfind('\n') + 1);
      if (path == from_.journal()) journal_ = *there;
      journals.emplace_back(fs::path(path).filename(), std::move(*there));
    }
    MIROCUP_TRY_VOID(expect_earlier());
    MIROCUP_TRY_VOID(folder(""));
    for (auto journal = journals.rbegin(); journal != journals.rend(); ++journal) {
      const auto& [name, text] = *journal;
      const auto readers =
          name == "hand-ins.jsonl" ? system::Readers::owner : system::Readers::everybody;
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
  Result<void> expect_earlier() const {
    MIROCUP_TRY(const auto there,
                files_.read_if_there(to_.journal(), {.max_size = system::size_limit::journal,
                                                     .growth = system::Growth::ignored}));
    if (!there || journal_.starts_with(*there)) return {};
    return fail(
        Errc::input,
        to_.path +
            " is a copy of another league, or legs were played in the copy: this league's "
            "journal does not begin with the lines of the copy's journal; name a new folder");
  }

  // True if the journal names the record of the leg of which a file is.
  bool is_named(const std::string& file) const {
    return journal_.find('"' + file.substr(0, file.find('.')) + ".json\"") != std::string::npos;
  }

  // Copies a folder of the league, `inside` (""; or with its slash at the end).
  Result<void> folder(const std::string& inside) {
    const std::string path = from_.path + "/" + inside;
    MIROCUP_TRY(const auto names, files_.names_in(path));
    std::error_code failed;
    MIROCUP_TRY_VOID(files_.make_folder(to_.path + "/" + inside,
                                        readers_of(fs::status(path, failed).permissions())));
    for (const std::string& name : names) {
      const std::string one = inside + name;
      const bool is_new = (inside == "records/" || inside == "nights/") && !before_.contains(one);
      if (is_left_out(one) || (is_new && !is_named(one))) continue;
      const fs::file_status status = fs::symlink_status(from_.path + "/" + one, failed);
      if (status.type() == fs::file_type::none)
        return fail(Errc::unavailable, from_.path + "/" + one + ": " + failed.message());
      auto copied = fs::is_directory(status) ? folder(one + "/")
                    : fs::is_regular_file(status)
                        ? bytes(one, status.permissions(), inside == "records/")
                        : Result<void>();
      if (!copied) return copied;
    }
    return {};
  }

  // Records and their replay files never change.
  Result<void> bytes(const std::string& name, fs::perms permissions, bool is_of_record) {
    const std::string to = to_.path + "/" + name;
    const bool never_changes = is_of_record && (name.ends_with(".json") || name.ends_with(".zst"));
    if (never_changes && files_.exists(to)) {
      ++count_.known;
      count_.names.insert(name);
      return {};
    }
    MIROCUP_TRY(const auto text, files_.read_if_there(from_.path + "/" + name,
                                                      {.max_size = 4 * system::size_limit::replay,
                                                       .growth = system::Growth::ignored}));
    // What ends between two looks is not there any more: the output of a check, a version that is
    // pruned.
    if (!text) return {};
    MIROCUP_TRY_VOID(files_.write(to, *text, readers_of(permissions)));
    if ((permissions & fs::perms::owner_exec) != fs::perms::none) {
      std::error_code failed;
      fs::permissions(to, permissions, failed);
      if (failed) return fail(Errc::unavailable, to + ": " + failed.message());
    }
    ++count_.copied;
    count_.names.insert(name);
    return {};
  }

  system::Files& files_;
  const Folder& from_;
  const Folder& to_;
  std::set<std::string> before_;  // records and nights that are older than the read journals
  std::string journal_;
  BackupCount count_;
};

}  // namespace

Result<BackupCount> back_up(system::Files& files, const Folder& from, const Folder& to) {
  return Backup(files, from, to).run();
}

}  // namespace mirocup::league
