// SPDX-License-Identifier: MIT
//
// The checks of the file: what can be said without running it.
#include "plugins/host/elf.hpp"
#include "plugins/host/file_advice.hpp"
#include "plugins/host/host_program.hpp"
#include "programs/check/examination.hpp"
#include "system/digest.hpp"
#include "system/printable.hpp"

#include <utility>

namespace mirocup::app {

namespace {

Check failed_with_advice(const std::string& text) {
  const auto [what, cure] = plugins::parts_of(text);
  return failed(what, cure);
}

Result<Check> open_file(Examination& e) {
  auto entry = plugins::SealedEntry::open(e.path);
  if (!entry && entry.error().code != Errc::input) return tl::unexpected(entry.error());
  if (!entry) return failed(entry.error().what, plugins::what_is_taken);
  e.report.sha256 = system::sha256(entry->bytes());
  e.entry = std::move(*entry);
  return passed("a regular file of " + std::to_string(e.entry->bytes().size()) + " bytes");
}

// Whether a text is a program and has a team, Python says when it is loaded.
Result<Check> find_kind(Examination& e) {
  if (e.entry->is_python()) {
    MIROCUP_TRY_VOID(plugins::host_program(*e.entry));
    return passed("a text in Python");
  }
  const auto library = plugins::read_shared_library(e.entry->bytes());
  if (!library) {
    const std::string known = plugins::advice_on_file(e.entry->bytes());
    return failed_with_advice(known.empty() ? library.error() : known);
  }
  e.library = *library;
  return passed("a complete shared library for this kind of processor");
}

Result<Check> find_entry(Examination& e) {
  if (e.entry->is_python()) return passed("imports mirocup.team");
  if (e.library.exports_entry) return passed("exports mirocup_entry()");
  return failed_with_advice(plugins::advice_on_missing_entry(e.entry->bytes()));
}

Result<Check> find_libraries(Examination& e) {
  if (e.entry->is_python())
    return passed("plays with this system's Python and the modules that are installed for it");
  if (const std::string tool = plugins::sanitizer_of(e.entry->bytes()); !tool.empty())
    return failed(sentence("sanitizer", tool), sentence("no_sanitizer"));
  std::string names;
  for (const std::string& name : e.library.needed) {
    const std::string printed = system::printable(name);
    if (!plugins::is_in_sandbox(name))
      return failed(sentence("missing_library", printed), "link it statically");
    names += (names.empty() ? "" : ", ") + printed;
  }
  return passed(names.empty() ? "needs no other library" : "needs " + names);
}

}  // namespace

const std::vector<Step> file_checks{{"file", open_file},
                                    {"complete", find_kind},
                                    {"entry", find_entry},
                                    {"libraries", find_libraries}};

}  // namespace mirocup::app
