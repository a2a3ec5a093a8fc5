// SPDX-License-Identifier: MIT
#include "tournaments/journal/journal.hpp"

#include "record/json_reader.hpp"
#include "system/digest.hpp"

#include <utility>

namespace mirocup::league {

namespace {

// Precedes the hash of a line, which is its last key and covers the text before this.
constexpr std::string_view before_hash = ",\"hash\":\"";

// A line of ours has some twenty values and a few sentences.
constexpr record::JsonLimits line_limits{.bytes = 8u << 20, .values = 10'000};

struct Head {
  std::size_t lines = 0;
  std::string hash;  // of the last of these lines
};

}  // namespace

// Defined here, where Json is a complete type.
Journal::Journal(system::Files& files, std::string path, std::size_t most_values, std::string head)
    : files_(&files),
      path_(std::move(path)),
      most_values_(most_values),
      head_path_(std::move(head)) {}
Journal::Journal(Journal&&) noexcept = default;
Journal& Journal::operator=(Journal&&) noexcept = default;
Journal::~Journal() = default;

Result<Journal> Journal::open(system::Files& files, std::string path, std::string* notice,
                              std::size_t most_values, std::string head) {
  Journal journal(files, std::move(path), most_values, std::move(head));
  MIROCUP_TRY_VOID(journal.refresh());
  if (journal.is_torn_ && notice != nullptr) {
    *notice = journal.path_ + ": line " + std::to_string(journal.lines_.size() + 1) +
              " is incomplete, and is ignored";
  }
  return journal;
}

Result<void> Journal::refresh() {
  // Read before the lines: another process that writes meanwhile must not seem to have lost some.
  if (!head_path_.empty())
    head_ = files_->read_if_there(
        head_path_, {.max_size = system::size_limit::note, .growth = system::Growth::ignored});
  MIROCUP_TRY(const auto there, files_->read_if_there(path_,
                                                      {.max_size = system::size_limit::journal,
                                                       .growth = system::Growth::ignored},
                                                      size_));
  if (!there) return {};
  const std::string& text = *there;
  std::size_t begin = 0;
  for (std::size_t end = text.find('\n'); end != std::string::npos; end = text.find('\n', begin)) {
    const auto line = std::string_view(text).substr(begin, end - begin);
    if (auto read = read_line(line); !read) return read;
    size_ += end + 1 - begin;
    begin = end + 1;
  }
  is_torn_ = begin < text.size();
  return {};
}

Result<void> Journal::read_line(std::string_view line) {
  const std::string where = path_ + ": line " + std::to_string(lines_.size() + 1);
  const std::size_t hashed = line.rfind(before_hash);
  if (hashed == std::string_view::npos ||
      line.substr(hashed) !=
          std::string(before_hash) + system::sha256(line.substr(0, hashed)) + "\"}") {
    const bool has_other_ends = !line.empty() && line.back() == '\r';
    return fail(Errc::damaged,
                where + " is not as it was written" +
                    (has_other_ends ? ": its line ends were changed, as git's autocrlf does" : "") +
                    restore_journal);
  }
  record::ParsedJson parsed = record::parse_json(line, line_limits);
  std::optional<record::JsonProblem> problem = std::move(parsed.problem);
  if (!problem) {
    const record::JsonReader json(parsed.value, "", problem);
    const std::size_t n = json.at("n").as<std::size_t>();
    const std::string prev = json.at("prev").text();
    if (!problem && (n != lines_.size() + 1 || prev != last_hash_)) {
      return fail(Errc::damaged,
                  where + " does not follow from the line before it" + restore_journal);
    }
  }
  if (problem) return tl::unexpected(record::error_of(*problem, where, Errc::damaged));
  if (auto added = add_values(parsed.values, where); !added) return added;
  last_hash_ = system::sha256(line);
  lines_.push_back(std::move(parsed.value));
  return {};
}

Result<void> Journal::add_values(std::size_t more, const std::string& where) {
  if (values_ + more > most_values_) {
    return fail(Errc::damaged, where + ": with this line the journal has more than " +
                                   std::to_string(most_values_) +
                                   " values, the most that a journal may have");
  }
  values_ += more;
  return {};
}

Result<std::size_t> Journal::known_lines() const {
  if (head_path_.empty()) return lines_.size();
  const auto lost = [](const std::string& why) {
    return fail(Errc::damaged, why + restore_journal +
                                   "; if there is no copy, remove journal.head to continue from "
                                   "the lines that are left");
  };
  if (!head_ && head_.error().code == Errc::damaged) return lost(head_.error().what);
  if (!head_) return tl::unexpected(head_.error());
  if (!*head_) return 0;
  const auto head = record::read_json<Head>(
      **head_, head_path_, Errc::damaged, [](const record::JsonReader& json) {
        return Head{.lines = json.at("n").integer<std::size_t>(1), .hash = json.at("hash").text()};
      });
  if (!head) return lost(head.error().what);
  const std::string line = "line " + std::to_string(head->lines);
  if (head->lines > lines_.size())
    return lost(path_ + ": it ends before " + line + ", the last line by journal.head");
  if (lines_[head->lines - 1].at("hash") != head->hash)
    return lost(path_ + ": " + line + " is another line than the one that journal.head names");
  return head->lines;
}

Result<void> Journal::write_head() {
  std::string text =
      record::json_text({{"n", lines_.size()}, {"hash", lines_.back().at("hash")}}) + "\n";
  MIROCUP_TRY_VOID(files_->write(head_path_, text));
  head_ = std::move(text);
  return {};
}

Result<void> Journal::append(const std::string& kind, Json fields) {
  MIROCUP_TRY(const auto known, known_lines());
  if (known < lines_.size()) {
    MIROCUP_TRY_VOID(write_head());
  }
  if (is_torn_) {
    if (auto cut = files_->truncate(path_, size_); !cut) return cut;
    is_torn_ = false;
  }
  Json line{{"n", lines_.size() + 1}, {"kind", kind}};
  for (auto& [key, value] : fields.items()) line[key] = value;
  line["prev"] = last_hash_;
  std::string text = record::json_text(line);
  text.pop_back();
  const std::string hash = system::sha256(text);
  line["hash"] = hash;
  text.append(before_hash).append(hash).append("\"}");
  const auto parsed = record::parse_json(text, line_limits);
  if (parsed.problem) return tl::unexpected(record::error_of(*parsed.problem, path_, Errc::input));
  if (auto added = add_values(parsed.values, path_); !added) return added;
  if (auto written = files_->append(path_, text + "\n"); !written) {
    is_torn_ = true;  // part of the line may have been written
    return written;
  }
  last_hash_ = system::sha256(text);
  lines_.push_back(std::move(line));
  size_ += text.size() + 1;
  // The line is written even if the head is not. The next call then writes the head first.
  if (!head_path_.empty()) (void)write_head();
  return {};
}

}  // namespace mirocup::league
