// SPDX-License-Identifier: MIT
#include "tournaments/journal/journal.hpp"

#include "server/system/digest.hpp"

#include <nlohmann/json.hpp>

#include <utility>

namespace mirocup::league {

namespace {

// Precedes a line's own hash, which is its last member and covers the text before it.
constexpr std::string_view before_hash = ",\"hash\":\"";

}  // namespace

// Defined here, where Json is a complete type.
Journal::Journal(system::Files& files, std::string path) : files_(&files), path_(std::move(path)) {}
Journal::Journal(Journal&&) noexcept = default;
Journal& Journal::operator=(Journal&&) noexcept = default;
Journal::~Journal() = default;

Result<Journal> Journal::open(system::Files& files, std::string path, std::string* notice) {
  Journal journal(files, std::move(path));
  if (auto read = journal.refresh(); !read) return tl::unexpected(read.error());
  if (journal.is_torn_ && notice != nullptr) {
    *notice = journal.path_ + ": line " + std::to_string(journal.lines_.size() + 1) +
              " was not written to its end; nothing followed from it, and it is left out";
  }
  return journal;
}

Result<void> Journal::refresh() {
  if (!files_->exists(path_)) return {};
  const auto text = files_->read_from(path_, size_);
  if (!text) return tl::unexpected(text.error());
  std::size_t begin = 0;
  for (std::size_t end = text->find('\n'); end != std::string::npos;
       end = text->find('\n', begin)) {
    if (auto read = read_line(text->substr(begin, end - begin)); !read) return read;
    size_ += end + 1 - begin;
    begin = end + 1;
  }
  is_torn_ = begin < text->size();
  return {};
}

Result<void> Journal::read_line(const std::string& line) {
  const std::string where = path_ + ": line " + std::to_string(lines_.size() + 1);
  Json json = Json::parse(line, nullptr, false);
  if (json.is_discarded() || !json.is_object()) return fail(Errc::damaged, where + " is not JSON");
  const std::size_t hashed = line.rfind(before_hash);
  const auto has_text = [&json](const char* key, const std::string& value) {
    return json.contains(key) && json[key].is_string() && json[key] == value;
  };
  if (hashed == std::string::npos ||
      line.substr(hashed) != std::string(before_hash) +
                                 system::sha256(std::string_view(line).substr(0, hashed)) + "\"}") {
    return fail(Errc::damaged, where + " is not as it was written");
  }
  if (!json.contains("n") || !json["n"].is_number_unsigned() ||
      json["n"].get<std::size_t>() != lines_.size() + 1 || !has_text("prev", last_hash_)) {
    return fail(Errc::damaged, where + " does not follow from the line before it");
  }
  last_hash_ = system::sha256(line);
  lines_.push_back(std::move(json));
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
  std::string text = line.dump(-1, ' ', false, Json::error_handler_t::replace);
  text.pop_back();
  line["hash"] = system::sha256(text);
  text.append(before_hash).append(line["hash"].get<std::string>()).append("\"}");
  if (auto written = files_->append(path_, text + "\n"); !written) {
    is_torn_ = true;  // a failed write may have left a part of the line
    return written;
  }
  last_hash_ = system::sha256(text);
  lines_.push_back(std::move(line));
  size_ += text.size() + 1;
  return {};
}

}  // namespace mirocup::league
