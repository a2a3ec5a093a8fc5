// SPDX-License-Identifier: MIT
//
// mirocup verify RECORD: simulates the leg again and compares it with the record.
#include "core/replay/verification.hpp"
#include "programs/mirocup/commands.hpp"
#include "record/kept_module.hpp"

namespace mirocup::app {

namespace {

struct VerifyOptions {
  std::string path;
  bool json = false;
  std::string answer;  // file for the answer
};

Result<int> run_verify(const VerifyOptions& options, const record::WriteAnswer& write) {
  system::Disk disk;
  const auto whole = record::load(disk, options.path);
  // For a record that was changed, its first wrong statement is a better answer than the checksum.
  MIROCUP_TRY(const auto record,
              whole ? whole : record::load(disk, options.path, record::ChecksumPolicy::ignored));
  auto divergence = replay::verify(record.recording);
  const bool has_other_behaviour = record::has_other_behaviour(record);
  if (!whole && (!divergence || has_other_behaviour)) return tl::unexpected(whole.error());
  if (divergence && has_other_behaviour) {
    auto found = record::verify_by_module(disk, options.path, record);
    if (!found) {
      Error why = record::behaviour_mismatch(options.path, record, divergence->tick);
      why.what += "; " + found.error().what;
      return tl::unexpected(why);
    }
    std::cerr << "mirocup: the leg was played by another version, whose module verifies it\n";
    divergence = std::move(*found);
  }

  record::Json answer{{"record", options.path}, {"reproduced", !divergence}};
  answer["tick"] = divergence ? record::Json(divergence->tick) : record::Json();
  answer["what"] = divergence ? record::Json(divergence->what) : record::Json();
  MIROCUP_TRY_VOID(write(answer));
  if (options.json) {
    print_json(answer);
  } else if (divergence) {
    std::cout << system::printable(options.path) << ": differs from tick " << divergence->tick
              << " on: " << system::printable(divergence->what) << '\n';
  } else {
    std::cout << system::printable(options.path) << ": reproduced, "
              << record.recording.ticks.size() << " ticks, state hash "
              << to_hex(record.recording.state_hash) << '\n';
  }
  return divergence ? exit_no : exit_yes;
}

}  // namespace

void add_verify(system::Commands& commands) {
  const auto [command, o] =
      commands.add(answering<run_verify, VerifyOptions>, "verify", after_a_leg,
                   "Simulate a record again from its commands and compare everything",
                   {"mirocup verify leg.json"});
  command.option("RECORD", o.path, "Match record").required();
  command.flag("--json", o.json, "Print the answer as one JSON object");
  add_answer(command, o.answer);
}

}  // namespace mirocup::app
