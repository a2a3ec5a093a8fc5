// SPDX-License-Identifier: MIT
#include "record/answer.hpp"

#include "record/json_reader.hpp"

namespace mirocup::record {

Result<int> answering(const std::string& path,
                      const std::function<Result<int>(const WriteAnswer&)>& run) {
  system::Disk disk;
  const WriteAnswer write = [&](const Json& line) -> Result<void> {
    return path.empty() ? Result<void>() : disk.append(path, json_text(line) + "\n");
  };
  if (!path.empty()) MIROCUP_TRY_VOID(disk.write(path, "", system::Readers::owner));
  auto result = run(write);
  // If this cannot be written, the exit code still tells the kind of the error.
  if (!result)
    (void)write({{"error", result.error().what}, {"code", to_string(result.error().code)}});
  return result;
}

Result<Json> last_answer(system::Files& files, const std::string& path) {
  MIROCUP_TRY(const auto text, files.read_if_there(path, {.max_size = system::size_limit::log,
                                                          .growth = system::Growth::ignored}));
  // A line without its end is still being written.
  const std::size_t end = text ? text->rfind('\n') : std::string::npos;
  if (end == std::string::npos) return Json();
  const std::string_view lines = std::string_view(*text).substr(0, end);
  return read_json<Json>(
      lines.substr(lines.rfind('\n') + 1), path, Errc::host,
      [](const JsonReader& json) { return json.expect_object() ? json.json() : Json(); });
}

}  // namespace mirocup::record
