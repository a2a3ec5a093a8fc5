// SPDX-License-Identifier: MIT
//
// The checks of the file: what can be said without running it.
#include "plugins/host/elf.hpp"
#include "plugins/host/file_advice.hpp"
#include "plugins/host/host_program.hpp"
#include "plugins/host/sandbox/private_root.hpp"
#include "programs/check/examination.hpp"
#include "system/digest.hpp"
#include "system/files.hpp"
#include "system/printable.hpp"

#include <algorithm>
#include <unistd.h>
#include <utility>

namespace mirocup::app {

namespace {

// True if the dynamic loader finds a library of that name in the sandbox.
bool is_on_this_system(const std::string& name) {
  if (name.find('/') != std::string::npos) return false;
  system::Disk disk;
  if (const auto cache = disk.read_named(plugins::loader_cache, system::size_limit::system_file)) {
    // The cache holds paths that end with a zero.
    if (cache->find('/' + name + '\0') != std::string::npos) return true;
  }
  return std::ranges::any_of(plugins::library_folders, [&](const std::string folder) {
    return access((folder + '/' + name).c_str(), F_OK) == 0;
  });
}

// Returns the sanitizer that the library was built with, or "".
std::string sanitizer_of(std::string_view bytes) {
  constexpr std::pair<const char*, const char*> functions[] = {{"__asan_init", "address"},
                                                               {"__tsan_init", "thread"},
                                                               {"__msan_init", "memory"},
                                                               {"__ubsan_handle_", "undefined"}};
  for (const auto& [function, option] : functions) {
    if (bytes.find(function) != std::string_view::npos) return option;
  }
  return "";
}

bool fail_with_advice(Examination& e, const std::string& text) {
  const auto [what, cure] = plugins::parts_of(text);
  return fail_with(e, Check{.what = what, .cure = cure});
}

// Whether the text is a program and has a team, Python says when it is loaded.
Result<bool> examine_python(Examination& e) {
  MIROCUP_TRY_VOID(plugins::host_program(*e.entry));
  pass(e, "a text in Python");
  pass(e, "imports mirocup.team");
  return pass(e, "plays with this system's Python and the modules that are installed for it");
}

}  // namespace

Result<bool> examine_file(Examination& e) {
  auto entry = plugins::SealedEntry::open(e.path);
  if (!entry) {
    if (entry.error().code != Errc::input) return tl::unexpected(entry.error());
    return fail_with(e, Check{.what = entry.error().what, .cure = plugins::what_is_taken});
  }
  e.report.sha256 = system::sha256(entry->bytes());
  e.entry = std::move(*entry);
  pass(e, "a regular file of " + std::to_string(e.entry->bytes().size()) + " bytes");

  if (e.entry->is_python()) return examine_python(e);
  const auto library = plugins::read_shared_library(e.entry->bytes());
  if (!library) {
    const std::string known = plugins::advice_on_file(e.entry->bytes());
    return fail_with_advice(e, known.empty() ? library.error() : known);
  }
  pass(e, "a complete shared library for this kind of processor");
  e.needs = plugins::processor_for(e.entry->bytes());
  if (!library->exports_entry)
    return fail_with_advice(e, plugins::advice_on_missing_entry(e.entry->bytes()));
  pass(e, "exports mirocup_entry()");
  if (const std::string tool = sanitizer_of(e.entry->bytes()); !tool.empty())
    return fail_with(e, {.what = sentence("sanitizer", tool), .cure = sentence("no_sanitizer")});
  std::string names;
  for (const std::string& name : library->needed) {
    if (!is_on_this_system(name))
      return fail_with(e, {.what = sentence("missing_library", system::printable(name)),
                           .cure = "link it statically"});
    names += (names.empty() ? "" : ", ") + system::printable(name);
  }
  return pass(e, names.empty() ? "needs no other library" : "needs " + names);
}

}  // namespace mirocup::app
