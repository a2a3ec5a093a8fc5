// SPDX-License-Identifier: MIT
#include "tournaments/journal/journal.hpp"

#include "server/record/digest.hpp"

#include <utility>

namespace mirocup::league {

Result<Journal> Journal::open(record::Files& files, std::string path, std::string* notice) {
  Journal journal(files, std::move(path));
  if (!files.exists(journal.path_)) return journal;
  const auto text = files.read(journal.path_);
  if (!text) return tl::unexpected(text.error());

  std::size_t begin = 0;
  while (begin < text->size()) {
    const std::size_t end = text->find('\n', begin);
    if (end == std::string::npos) {
      // Only the last line can lack its end: the machine stopped while it was written, so nobody
      // acted on it.
      if (auto cut = files.truncate(journal.path_, begin); !cut) return tl::unexpected(cut.error());
      if (notice != nullptr)
        *notice = journal.path_ + ": a line that was not written to its end was cut off";
      break;
    }
    const std::string line = text->substr(begin, end - begin);
    const std::string where = journal.path_ + ": line " + std::to_string(journal.lines_.size() + 1);
    Json json = Json::parse(line, nullptr, false);
    if (json.is_discarded() || !json.is_object())
      return fail(Errc::damaged, where + " is not JSON");
    if (json.value("n", std::size_t{0}) != journal.lines_.size() + 1 ||
        json.value("prev", std::string()) != journal.last_hash_ || !json.contains("kind")) {
      return fail(Errc::damaged, where + " does not follow from the line before it");
    }
    journal.last_hash_ = record::sha256(line);
    journal.lines_.push_back(std::move(json));
    begin = end + 1;
  }
  return journal;
}

Result<void> Journal::append(const std::string& kind, Json fields) {
  Json line{{"n", lines_.size() + 1}, {"kind", kind}};
  for (auto& [key, value] : fields.items()) line[key] = value;
  line["prev"] = last_hash_;
  const std::string text = line.dump(-1, ' ', false, Json::error_handler_t::replace);
  if (auto written = files_->append(path_, text + "\n"); !written) return written;
  last_hash_ = record::sha256(text);
  lines_.push_back(std::move(line));
  return {};
}

}  // namespace mirocup::league
