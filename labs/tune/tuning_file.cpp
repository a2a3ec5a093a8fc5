// SPDX-License-Identifier: MIT
#include "labs/tune/tuning_file.hpp"

#include "record/json_reader.hpp"

namespace mirocup::league {

namespace {

using TuneJson = nlohmann::ordered_json;

constexpr std::string_view tuning_schema = "mirocup/tuning/1";

std::map<std::string, std::vector<Mark>> read_marks(const record::JsonReader& json) {
  std::map<std::string, std::vector<Mark>> all;
  if (!json.expect_object({"schema", "search", "played"})) return all;
  json.expect_schema(tuning_schema);
  for (const record::JsonReader& played : json.at("played").elements()) {
    std::vector<Mark>& marks = all[played.at("key").text()];
    for (const record::JsonReader& mark : played.at("marks").elements()) {
      if (mark.expect_array(2, 2)) marks.push_back({mark.at(0).number(), mark.at(1).number()});
    }
  }
  return all;
}

}  // namespace

Result<TuningFile> TuningFile::open(system::Files& files, const std::string& folder,
                                    TuneJson identity) {
  MIROCUP_TRY_VOID(files.make_folder(folder));
  TuningFile file(files, folder + "/tune.json", std::move(identity));
  MIROCUP_TRY(const auto text,
              files.read_if_there(file.path_, {.max_size = system::size_limit::record}));
  if (!text) return file;
  MIROCUP_TRY(const auto search, record::read_json<TuneJson>(*text, file.path_, Errc::damaged,
                                                             [](const record::JsonReader& json) {
                                                               return json.at("search").json();
                                                             }));
  for (const auto& [key, value] : file.identity_.items()) {
    if (search.contains(key) && search.at(key) == value) continue;
    return fail(Errc::input, file.path_ + ": " + key + " is not " + record::json_text(value) +
                                 " in this folder, which holds another search; name a new folder");
  }
  MIROCUP_TRY(file.marks_, record::read_json<std::map<std::string, std::vector<Mark>>>(
                               *text, file.path_, Errc::damaged, read_marks));
  return file;
}

const std::vector<Mark>* TuningFile::find(const std::string& key) const {
  const auto found = marks_.find(key);
  return found == marks_.end() ? nullptr : &found->second;
}

Result<void> TuningFile::keep(const std::string& key, std::vector<Mark> marks) {
  marks_[key] = std::move(marks);
  TuneJson played = TuneJson::array();
  for (const auto& [name, of_one] : marks_) {
    TuneJson list = TuneJson::array();
    for (const Mark& mark : of_one) list.push_back({mark.goals, mark.points});
    played.push_back({{"key", name}, {"marks", list}});
  }
  return files_->write(
      path_,
      record::json_text({{"schema", tuning_schema}, {"search", identity_}, {"played", played}}, 1) +
          "\n");
}

}  // namespace mirocup::league
