// SPDX-License-Identifier: MIT
#include "pitch/validation_report.hpp"

#include "pitch/page.hpp"
#include "pitch/result_json.hpp"
#include "record/json_reader.hpp"
#include "record/pitch_json.hpp"
#include "system/files.hpp"

namespace mirocup::pitch {

Result<std::vector<Recording>> read_recordings(const std::vector<std::string>& paths) {
  std::vector<Recording> recordings;
  for (const std::string& path : paths) {
    MIROCUP_TRY(auto recording, read_recording(path));
    recordings.push_back(std::move(recording));
  }
  return recordings;
}

Result<ValidationReport> report_of(const ValidationRequest& request, const Peer* peer) {
  MIROCUP_TRY(const auto spec, record::pitch_of_option(request.pitch));
  MIROCUP_TRY(const auto recordings, read_recordings(request.recordings));
  const Validation result = validate(recordings, {spec.parameters, spec.command_delay}, peer);
  if (!request.page.empty()) {
    const std::string title = "The simulator with the pitch " + spec.name + " against recordings";
    system::Disk disk;
    MIROCUP_TRY_VOID(disk.write(request.page, page_of(result, title)));
  }
  return ValidationReport{
      request.json ? record::json_text(to_json(result)) + "\n" : text_of_result(result),
      !result.objections.empty()};
}

}  // namespace mirocup::pitch
