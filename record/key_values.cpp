// SPDX-License-Identifier: MIT
#include "record/key_values.hpp"

#include "record/json_reader.hpp"

#include <nlohmann/json.hpp>

#include <utility>

namespace mirocup::record {

Result<nlohmann::ordered_json> with_changes(nlohmann::ordered_json object,
                                            const std::vector<std::string>& changes,
                                            const std::string& option) {
  for (const std::string& change : changes) {
    const std::size_t equals = change.find('=');
    const std::string text = equals == std::string::npos ? "" : change.substr(equals + 1);
    ParsedJson value = parse_json(text);
    if (value.problem) {
      return fail(Errc::input, option + " " + change + ": KEY=VALUE is expected");
    }
    object[change.substr(0, equals)] = std::move(value.value);
  }
  return object;
}

}  // namespace mirocup::record
