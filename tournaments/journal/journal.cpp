// SPDX-License-Identifier: MIT
#include "tournaments/journal/journal.hpp"

#include "record/json_reader.hpp"
#include "system/digest.hpp"

#include <optional>
#include <utility>

namespace mirocup::league {

namespace {

// Precedes the hash of a line, which is its last key and covers the text before this.
constexpr std::string_view before_hash = ",\"hash\":\"";

constexpr const char* cure =
    "; put back journal.jsonl from the last copy that league backup made: legs that were played "
    "since are booked again from records/";

// A line of ours has some twenty values and a few sentences.
constexpr record::JsonLimits line_limits{.bytes = 8u << 20, .values = 10'000};

}  // namespace

// Defined here, where Json is a complete type.
Journal::Journal(system::Files& files, std::string path, std::size_t most_values)
    : files_(&files), path_(std::move(path)), most_values_(most_values) {}
Journal::Journal(Journal&&) noexcept = default;
Journal& Journal::operator=(Journal&&) noexcept = default;
Journal::~Journal() = default;

Result<Journal> Journal::open(system::Files& files, std::string path, std::string* notice,
                              std::size_t most_values) {
  Journal journal(files, std::move(path), most_values);
  MIROCUP_TRY_VOID(journal.refresh());
  if (journal.is_torn_ && notice != nullptr) {
    *notice = journal.path_ + ": line " + std::to_string(journal.lines_.size() + 1) +
              " is incomplete; it had no effect, and is ignored";
  }
  return journal;
}

Result<void> Journal::refresh() {
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
                    cure);
  }
  record::ParsedJson parsed = record::parse_json(line, line_limits);
  std::optional<record::JsonProblem> problem = std::move(parsed.problem);
  if (!problem) {
    const record::JsonReader json(parsed.value, "", problem);
    const std::size_t n = json.at("n").as<std::size_t>();
    const std::string prev = json.at("prev").text();
    if (!problem && (n != lines_.size() + 1 || prev != last_hash_)) {
      return fail(Errc::damaged, where + " does not follow from the line before it" + cure);
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

Result<void> Journal::append(const std::string& kind, Json fields) {
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
  return {};
}

}  // namespace mirocup::league
