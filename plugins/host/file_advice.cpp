// SPDX-License-Identifier: MIT
#include "plugins/host/file_advice.hpp"

#include "plugins/host/sandbox/private_root.hpp"
#include "system/files.hpp"

#include <algorithm>
#include <array>
#include <unistd.h>

namespace mirocup::plugins {

namespace {

using namespace std::literals;

constexpr const char* no_team_in_python =
    "it is Python, but no team: write \"from mirocup.team import Team\" and derive a class from "
    "Team";

struct Kind {
  std::string_view begin;  // of the file, or of one of its lines
  const char* name;
};

constexpr std::array archives_not_taken{
    Kind{"Rar!\x1a\x07"sv, "a RAR archive"},        Kind{"7z\xbc\xaf\x27\x1c"sv, "a 7z archive"},
    Kind{"\xfd\x37zXZ\0"sv, "packed with xz"},      Kind{"BZh"sv, "packed with bzip2"},
    Kind{"\x28\xb5\x2f\xfd"sv, "packed with zstd"}, Kind{"LZIP"sv, "packed with lzip"},
    Kind{"\x04\x22\x4d\x18"sv, "packed with lz4"},  Kind{"\x5d\0\0"sv, "packed with lzma"},
    Kind{"\x1f\x9d"sv, "packed with compress"},     Kind{"MSCF"sv, "a cabinet of Windows"}};

constexpr const char* an_archive =
    "it is an archive: hand in the library or the file of Python that is in it, or make a library "
    "from a project's sources in C or C++ with mirocup compile";
constexpr std::array other_files{
    Kind{"!<arch>"sv, "it is a static library (.a): link its objects with -shared"},
    Kind{"MZ"sv, "it is a library or program of Windows (DLL): build it on Linux, as a .so"},
    Kind{"PK\x03\x04"sv, an_archive},
    Kind{"\x1f\x8b"sv, an_archive},
    Kind{"\xcf\xfa\xed\xfe"sv, "it is a library of macOS: build it on Linux, as a .so"},
    Kind{"\xca\xfe\xba\xbe"sv,
         "it is a class of Java or a library of macOS: a team is written in C, C++ or Python"},
    Kind{"\0asm"sv, "it is WebAssembly: build the team on Linux, as a .so"},
    Kind{"%PDF"sv, "it is a PDF: hand in the library, or the file of Python"}};

constexpr const char* a_page = "it is a page of the web: download the file itself";
constexpr const char* another_language =
    "it is of another language: a team is written in C, C++ or Python";
constexpr const char* source_of_a_library =
    "it is a source: make the library with mirocup compile SOURCE -o team.so, or with g++ "
    "-std=c++20 -O2 -shared -fPIC";
constexpr const char* a_module = "it is a module of C++20, which is not taken: write a header";
// Beginnings of lines of texts, with tabs between them, and what such a text is, in the order in
// which they are looked for.
constexpr std::array other_texts{
    Kind{"<!doctype\t<!DOCTYPE\t<html"sv, a_page},
    Kind{"version https://git-lfs"sv, "it is a pointer of Git LFS: fetch it with git lfs pull"},
    Kind{"#!/usr/bin/env python\t#!/usr/bin/python"sv, no_team_in_python},
    Kind{"#!"sv, "it is a script: a team is a shared library, or a file of Python"},
    Kind{"export module\tmodule;"sv, a_module},
    Kind{"#include\t#pragma"sv, source_of_a_library},
    Kind{"<?php\timport \"\timport java\tpublic class\tusing System"sv, another_language},
    Kind{"import \tfrom \tclass \tdef \t\"\"\"\t# "sv, no_team_in_python},
    Kind{"package \tfn \tuse \tfunction\tconst \tlet \tlocal "sv, another_language},
    Kind{"//\t/*"sv, source_of_a_library}};

constexpr const char* a_text =
    "it is not an ELF file but a text: hand in the shared library (.so) that the build made, or a "
    "file of Python with \"from mirocup.team import Team\"";

// Returns what the first kind of other_texts says that begins a line; null if none does. A text
// that names mirocup as C++ does is a source, whatever its lines begin with.
const char* kind_of_text(std::string_view text) {
  for (const char* name : {"mirocup::", "MIROCUP_EXPORT", "mirocup_strategy"}) {
    if (!text.starts_with('<') && text.find(name) != std::string_view::npos)
      return source_of_a_library;
  }
  for (const Kind& kind : other_texts) {
    for (std::string_view rest = kind.begin; !rest.empty();) {
      const std::string_view begin = rest.substr(0, rest.find('\t'));
      rest.remove_prefix(std::min(begin.size() + 1, rest.size()));
      if (text.starts_with(begin) || text.find("\n" + std::string(begin)) != std::string_view::npos)
        return kind.name;
    }
  }
  return nullptr;
}

}  // namespace

FileAdvice parts_of(const std::string& text) {
  const std::size_t colon = text.rfind(": ");
  if (colon == std::string::npos) return {text, what_is_taken};
  return {text.substr(0, colon), text.substr(colon + 2)};
}

std::string objection_to_source(std::string_view bytes) {
  for (const Kind& kind : archives_not_taken) {
    if (bytes.starts_with(kind.begin))
      return std::string("it is ") + kind.name + ", which is not taken: " + what_is_taken;
  }
  const bool is_utf16 = bytes.starts_with("\xff\xfe"sv) || bytes.starts_with("\xfe\xff"sv);
  return is_utf16 ? "it is a text in UTF-16: save it as UTF-8" : "";
}

std::string advice_on_file(std::string_view bytes) {
  if (bytes.starts_with("\x7f"
                        "ELF"sv))
    return "";
  if (std::string known = objection_to_source(bytes); !known.empty()) return known;
  for (const Kind& kind : other_files) {
    if (bytes.starts_with(kind.begin)) return kind.name;
  }
  constexpr std::size_t tar_mark = 257;
  if (bytes.size() > tar_mark && bytes.substr(tar_mark).starts_with("ustar")) return an_archive;
  if (bytes.find('\0') != std::string_view::npos) return "";
  constexpr std::string_view utf8_mark = "\xef\xbb\xbf";
  if (bytes.starts_with(utf8_mark)) bytes.remove_prefix(utf8_mark.size());
  bytes.remove_prefix(std::min(bytes.find_first_not_of(" \t\r\n"), bytes.size()));
  if (bytes.starts_with('{') && bytes.find("\"cells\"") != std::string_view::npos)
    return "it is a notebook: save it as a file of Python (.py)";
  if (bytes.starts_with("# ") && bytes.find("\n```") != std::string_view::npos)
    return std::string("it is a page in Markdown: ") + what_is_taken;
  if (const char* known = kind_of_text(bytes)) return known;
  return a_text;
}

std::string advice_on_no_source(std::string_view bytes) {
  if (bytes.find("#include") != std::string_view::npos) return "";
  const std::string known = advice_on_file(bytes);
  if (known == no_team_in_python) return "it is Python, which is not compiled: hand in the file";
  return known == source_of_a_library || known == a_text ? "" : known;
}

std::string advice_on_missing_entry(std::string_view bytes) {
  // The C++ name of a function without parameters ends with v.
  if (bytes.find("_Z13mirocup_entryv") != std::string_view::npos)
    return "it exports mirocup_entry() under a C++ name: declare it extern \"C\", or write "
           "MIROCUP_EXPORT_TEAM(YourClass, \"name\")";
  return "it exports no function mirocup_entry(): write MIROCUP_EXPORT_TEAM(YourClass, \"name\"), "
         "or in C define mirocup_entry()";
}

std::string sanitizer_of(std::string_view library) {
  for (const std::string name : {"address", "thread", "memory"})
    if (library.find("__" + name.substr(0, 1) + "san_init") != std::string_view::npos) return name;
  return library.find("__ubsan_handle_") != std::string_view::npos ? "undefined" : "";
}

bool is_in_sandbox(const std::string& name) {
  if (name.find('/') != std::string::npos) return false;
  // The cache holds paths that end with a zero.
  const auto cache = system::Disk().read_named(loader_cache, system::size_limit::system_file);
  if (cache && cache->find('/' + name + '\0') != std::string::npos) return true;
  return std::ranges::any_of(library_folders, [&](const std::string& folder) {
    return access((folder + '/' + name).c_str(), F_OK) == 0;
  });
}

}  // namespace mirocup::plugins
