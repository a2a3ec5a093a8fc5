// SPDX-License-Identifier: MIT
#include "labs/programs/old_sources.hpp"

#include "labs/programs/old_text.hpp"
#include "system/files.hpp"
#include "system/text.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

namespace mirocup::labs {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t max_files = 2000;
constexpr std::size_t max_bytes = 32u << 20;  // of all files
constexpr std::size_t max_line = 64u << 10;   // bytes

bool ends_with_any(const std::string& path, std::initializer_list<const char*> endings) {
  const std::string ending = system::lower_case(fs::path(path).extension().string());
  return std::any_of(endings.begin(), endings.end(), [&](const char* e) { return ending == e; });
}

bool is_source(const std::string& path) {
  return ends_with_any(path, {".cpp", ".cc", ".cxx", ".c"});
}
bool is_header(const std::string& path) {
  return ends_with_any(path, {".h", ".hpp", ".hh", ".inl", ".def", ".txt"});
}

// Without comments, so that a name in one is no use of it.
std::string code_of(const std::string& text) {
  std::string code;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text.compare(i, 2, "//") == 0) {
      while (i < text.size() && text[i] != '\n') ++i;
    } else if (text.compare(i, 2, "/*") == 0) {
      const std::size_t end = text.find("*/", i + 2);
      i = end == std::string::npos ? text.size() : end + 1;
      code.push_back(' ');
      continue;
    }
    if (i < text.size()) code.push_back(text[i]);
  }
  return code;
}

bool is_part(char c) {
  return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_';
}

bool is_next(std::string_view rest, std::string_view chars) {
  return !rest.empty() && chars.find(rest.front()) != chars.npos;
}

// Takes a pattern from the front of `rest`, and returns what its @ or `…` took; nothing if `rest`
// begins otherwise. A blank is any number of blanks, _ also of line ends, ~ is & or * or nothing, @
// is a word, and `abc` is any number of characters but these three. Nothing is tried twice.
std::optional<std::string_view> take(std::string_view& rest, std::string_view pattern) {
  std::string_view taken;
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    const char kind = pattern[i];
    const bool is_taken = kind == '@' || kind == '`';
    std::size_t count = 1;
    if (kind == ' ' || kind == '_') {
      count = rest.find_first_not_of(kind == ' ' ? " \t" : " \t\r\n");
    } else if (kind == '~') {
      count = is_next(rest, "&*") ? 1 : 0;
    } else if (kind == '`') {
      const std::size_t begin = i + 1;
      i = pattern.find('`', begin);
      count = rest.find_first_of(pattern.substr(begin, i - begin));
    } else if (kind == '@' && !rest.empty() && is_part(rest.front())) {
      count = std::find_if_not(rest.begin(), rest.end(), is_part) - rest.begin();
    } else if (kind == '@' || !rest.starts_with(kind)) {
      return std::nullopt;
    }
    if (is_taken) taken = rest.substr(0, count);
    rest.remove_prefix(std::min(count, rest.size()));
  }
  return taken;
}

// Returns whether a word stands in front of the pattern, and `is_met` is true for what the pattern
// took, for what follows it and for the byte in front of the word. A word that begins like a name
// is the beginning of one.
template <class Met>
bool has(std::string_view text, std::string_view word, std::string_view pattern,
         const Met& is_met) {
  for (std::size_t at = text.find(word); at != text.npos; at = text.find(word, at)) {
    const char before = at == 0 ? '\0' : text[at - 1];
    at += word.size();
    std::string_view rest = text.substr(at);
    if (is_part(word.front()) && is_part(before)) continue;
    const auto taken = take(rest, pattern);
    if (!taken) continue;
    if (is_met(*taken, rest, before)) return true;
    at = text.size() - rest.size();
  }
  return false;
}

bool has(std::string_view text, std::string_view word, std::string_view pattern) {
  return has(text, word, pattern, [](auto...) { return true; });
}

bool has_word(std::string_view code, std::string_view word) {
  return has(code, word, "", [](auto, std::string_view rest, char) {
    return rest.empty() || !is_part(rest.front());
  });
}

// True for the name of a project of Visual C++, which names the files to compile: .dsp of version
// 6, .vcproj, .vcxproj.
bool is_old_project(const std::string& path) {
  const std::string ending = system::lower_case(std::filesystem::path(path).extension().string());
  return ending == ".dsp" || ending == ".vcproj" || ending == ".vcxproj";
}

// A name of a file as Visual C++ writes it, with "/" between folders.
std::string with_slashes(std::string_view text) {
  std::string name(text);
  std::replace(name.begin(), name.end(), '\\', '/');
  return name;
}

// Returns the files that the project compiles or shows, in lower case and relative to its folder.
// SOURCE=.\Move.cpp, RelativePath=".\Move.cpp", <ClCompile Include="Move.cpp" />
std::vector<std::string> files_of_project(const std::string& text) {
  std::vector<std::string> files;
  const auto add = [&files](std::string_view text_of_name, auto...) {
    std::string name = with_slashes(text_of_name);
    while (!name.empty() && name.back() == ' ') name.pop_back();
    files.push_back(system::lower_case(fs::path(name).lexically_normal().string()));
    return false;
  };
  const std::string name = "`\"\r\n<>|`";
  has(text, "SOURCE=", name, add);
  has(text, "SOURCE=\"", name, add);
  has(text, "RelativePath", "_=_\"" + name, add);
  has(text, "<ClCompile", "_Include=\"" + name, add);
  return files;
}

// Returns the team's own macros in the project, such as BLUE or SIDE=1, without the macros of
// Windows, of Visual C++ and of a build for the debugger.
// <PreprocessorDefinitions>WIN32;BLUE</…, PreprocessorDefinitions="WIN32;BLUE", /D "BLUE"
std::vector<std::string> macros_of_project(const std::string& text) {
  static const std::set<std::string> of_windows{"WIN32", "WIN64", "NDEBUG", "UNICODE"};
  std::vector<std::string> macros;
  const auto add = [&macros](std::string_view list, auto...) {
    if (has_word(list, "_DEBUG")) return false;
    for (std::string_view rest = list; !rest.empty(); rest.remove_prefix(!rest.empty())) {
      const std::string macro(*take(rest, "`;`"));
      const std::string name = macro.substr(0, macro.find('='));
      const bool is_plain = std::all_of(macro.begin(), macro.end(), [](char c) {
        return is_part(c) || c == '=' || c == '.' || c == '-';
      });
      const bool is_own = !name.empty() && name.front() != '_' && !name.ends_with("_EXPORTS") &&
                          !of_windows.contains(name);
      if (is_plain && is_own && std::find(macros.begin(), macros.end(), macro) == macros.end())
        macros.push_back(macro);
    }
    return false;
  };
  has(text, "<PreprocessorDefinitions", "`<>`>`<`", add);
  has(text, "PreprocessorDefinitions", "_=_\"`\"<`", add);
  has(text, "/D", " \"`\"\n`", add);
  return macros;
}

// The names in the #include lines of the code, in lower case and without their folders.
std::vector<std::string> included_by(const std::string& code) {
  std::vector<std::string> names;
  const auto add = [&names](std::string_view text, std::string_view rest, char) {
    if (!text.empty() && is_next(rest, "\">"))
      names.push_back(system::lower_case(fs::path(with_slashes(text)).filename().string()));
    return false;
  };
  has(code, "#", " include \"`\">\n`", add);
  has(code, "#", " include <`\">\n`", add);
  return names;
}

struct Project {
  std::vector<std::string> files, macros;
};

struct Folder {
  std::map<std::string, std::string> code;  // of sources and headers, by their paths
  std::map<std::string, Project> projects;  // by their paths
};

// CMake and make take these characters, and control characters, for signs of their language.
Result<void> expect_plain(const std::string& folder, const std::string& path,
                          std::string_view meant) {
  const bool is_plain = std::none_of(path.begin(), path.end(), [&](char c) {
    return (c >= '\0' && c < ' ') || meant.find(c) != meant.npos;
  });
  if (is_plain) return {};
  return fail(Errc::input, folder + "/" + path + ": CMake cannot take this name; change it");
}

// Reads all sources, headers and projects of the folder.
Result<Folder> read_all(const std::string& folder) {
  Folder all;
  std::map<std::string, std::string>& code = all.code;
  system::Disk disk;
  std::size_t bytes = 0;
  std::error_code error;
  fs::recursive_directory_iterator at(folder, error), end;
  if (error) return fail(Errc::input, folder + ": " + error.message());
  for (; !error && at != end; at.increment(error)) {
    const std::string name = at->path().filename().string();
    const bool is_built = system::lower_case(name) == "debug" ||
                          system::lower_case(name) == "release" || name == "x64";
    if (at->is_directory(error) && (name.front() == '.' || is_built)) {
      at.disable_recursion_pending();
      continue;
    }
    const std::string path = fs::relative(at->path(), folder).string();
    const bool is_project = is_old_project(path);
    if (!at->is_regular_file(error) || (!is_source(path) && !is_header(path) && !is_project)) {
      continue;
    }
    MIROCUP_TRY_VOID(expect_plain(folder, path, "\"$;\\|"));
    MIROCUP_TRY(auto text, disk.read(at->path().string(), {.max_size = system::size_limit::note}));
    bytes += text.size();
    text = readable(std::move(text));
    for (std::string_view rest = text; !rest.empty();
         rest.remove_prefix(is_next(rest, "\r\n") ? 1 : 0)) {
      const auto line = take(rest, "`\r\n`");
      if (line->size() > max_line)
        return fail(Errc::input, folder + "/" + path + ": a line of more than 64 KiB; break it");
    }
    if (bytes > max_bytes || code.size() + all.projects.size() == max_files) {
      return fail(Errc::input, folder + ": more than 32 MiB or " + std::to_string(max_files) +
                                   " sources; name the folder of one team");
    }
    if (is_project) {
      all.projects.emplace(path, Project{files_of_project(text), macros_of_project(text)});
    } else {
      code.emplace(path, code_of(text));
    }
  }
  if (error) return fail(Errc::unavailable, folder + " cannot be searched: " + error.message());
  return all;
}

// True if the code has loops over ranges, lambdas, enum class, "auto x =" or the like. "int x = 1"
// of a member is left to g++.
bool has_modern_forms(const std::string& code) {
  const auto is_range = [](std::string_view loop, auto...) {
    const std::size_t colon = loop.rfind(':');
    return colon != loop.npos && colon > 0 && loop[colon - 1] != ':';
  };
  const auto is_class = [](std::string_view word, auto...) {
    return word == "class" && !is_part(word.data()[-1]);
  };
  const auto is_variable = [](auto, std::string_view rest, char) { return is_next(rest, "=:"); };
  const auto is_default = [](std::string_view word, auto...) {
    return word == "default" || word == "delete";
  };
  const auto is_end_of_two = [](std::string_view word, std::string_view rest, char before) {
    return is_part(before) && is_next(rest, ";(={") &&
           word.find_first_of("0123456789") == word.npos;
  };
  return has(code, "for", " (`;(){}\n`)", is_range) || has(code, "]", " (`()\n`) {") ||
         has(code, "enum", " @", is_class) || has(code, "auto", " ~ @ ", is_variable) ||
         has(code, "=", " @ ;", is_default) || has(code, ">>", " @ ", is_end_of_two);
}

// A standard of C++ that has what the code uses.
std::string standard_of(const std::map<std::string, std::string>& all) {
  static const std::array<const char*, 24> words{
      "nullptr",      "constexpr",    "override",      "unordered_map",    "unordered_set",
      "unique_ptr",   "shared_ptr",   "make_shared",   "to_string",        "stoi",
      "stod",         "emplace_back", "static_assert", "decltype",         "noexcept",
      "thread_local", "chrono",       "tuple",         "initializer_list", "mt19937",
      "cbegin",       "all_of",       "any_of",        "random_device"};
  std::string standard = "gnu++98";
  for (const auto& [path, code] : all) {
    const bool is_newest = has_word(code, "string_view") || has_word(code, "optional") ||
                           has_word(code, "filesystem") || has_word(code, "variant");
    if (is_newest) return "gnu++17";
    const bool is_modern =
        std::any_of(words.begin(), words.end(),
                    [&code = code](const char* word) { return has_word(code, word); }) ||
        has_modern_forms(code);
    if (is_modern) standard = "gnu++14";
  }
  return standard;
}

bool is_below(const std::string& path, const fs::path& folder) {
  const std::string start = folder.empty() ? "" : folder.string() + "/";
  return path.compare(0, start.size(), start) == 0;
}

// The project that counts: of several one that has a header of the platform in its folder, then the
// one nearest to the top, and of those the one for the newest Visual C++, since older ones are left
// over. Empty if there is none, or two are alike.
std::string project_of(const Folder& folder, const std::vector<std::string>& headers) {
  const auto rank = [&](const std::string& path) {
    const bool has_header = std::any_of(headers.begin(), headers.end(), [&](const auto& header) {
      return is_below(header, fs::path(path).parent_path());
    });
    const std::string kind = system::lower_case(fs::path(path).extension().string());
    const int age = kind == ".vcxproj" ? 0 : kind == ".vcproj" ? 1 : 2;
    return std::tuple(!has_header, std::count(path.begin(), path.end(), '/'), age);
  };
  std::vector<std::string> paths;
  for (const auto& [path, parts] : folder.projects) paths.push_back(path);
  std::stable_sort(paths.begin(), paths.end(),
                   [&](const auto& a, const auto& b) { return rank(a) < rank(b); });
  const bool are_two = paths.size() > 1 && rank(paths[0]) == rank(paths[1]);
  return paths.empty() || are_two ? "" : paths[0];
}

// The sources that the project compiles; all of them if there is none, or if it names none of them.
std::vector<std::string> compiled_of(const Folder& folder, const std::string& project,
                                     std::vector<std::string> sources) {
  if (project.empty()) return sources;
  // The case of a name does not count, as on Windows.
  const fs::path at = system::lower_case(fs::path(project).parent_path().string());
  std::set<std::string> names;
  for (const std::string& file : folder.projects.at(project).files)
    names.insert((at / file).lexically_normal().string());
  std::vector<std::string> compiled;
  for (const std::string& source : sources) {
    if (names.contains(system::lower_case(source))) compiled.push_back(source);
  }
  return compiled.empty() ? sources : compiled;
}

std::string without_blanks(const std::string& code) {
  std::string rest;
  for (const char c : code) {
    if (c != ' ' && c != '\t' && c != '\r' && c != '\n') rest.push_back(c);
  }
  return rest;
}

// The header, of those that define the platform's structures: the only one; or the first where the
// others are copies of it; or that of the folder in which all sources are.
Result<std::string> header_of(const std::string& folder, const Folder& all,
                              const std::vector<std::string>& headers,
                              const std::vector<std::string>& sources,
                              const std::vector<std::string>& entries) {
  const std::string& first = headers.front();
  const std::string first_code = without_blanks(all.code.at(first));
  std::vector<std::string> others;
  for (const std::string& other : headers) {
    if (fs::path(other).parent_path() == fs::path(first).parent_path()) continue;
    if (without_blanks(all.code.at(other)) != first_code) others.push_back(other);
  }
  if (others.empty()) return first;
  for (const std::string& header : headers) {
    const bool has_all = std::all_of(sources.begin(), sources.end(), [&](const auto& source) {
      return is_below(source, fs::path(header).parent_path());
    });
    if (has_all && !fs::path(header).parent_path().empty()) return header;
  }
  const auto beside = [&](const std::string& header) {
    return std::count_if(sources.begin(), sources.end(), [&](const auto& source) {
      return fs::path(source).parent_path() == fs::path(header).parent_path();
    });
  };
  // A copy beside no source is not read.
  const bool is_one = std::all_of(others.begin(), others.end(),
                                  [&](const std::string& other) { return beside(other) == 0; });
  if (is_one && beside(first) > 0) return first;
  return fail(Errc::input, folder + ": more than one team, with " + first + " and " +
                               others.front() + "; name the folder of one of them" +
                               (entries.size() == 1 ? ", such as that of " + entries[0] : ""));
}

// The function that the platform calls in every tick.
std::string entry_of(const std::string& style) {
  return style == "v5" ? "GetInstruction" : style == "restart" ? "RunStrategy" : "Strategy";
}

// The sources that define it.
std::vector<std::string> with_entry(const std::map<std::string, std::string>& sources,
                                    const std::string& name) {
  std::vector<std::string> paths;
  for (const auto& [path, code] : sources) {
    if (has(code, name, "_(`;{()`)_{")) paths.push_back(path);
  }
  return paths;
}

}  // namespace

Result<OldSources> find_old_sources(const std::string& folder) {
  MIROCUP_TRY(const auto all, read_all(folder));
  OldSources team;
  std::map<std::string, int> included;  // by how many files
  for (const auto& [path, code] : all.code) {
    team.files.push_back(path);
    for (const std::string& name : included_by(code)) ++included[name];
  }
  const auto uses = [&](const std::string& path) {
    return included[system::lower_case(fs::path(path).filename().string())];
  };
  const auto defines = [](const std::string& path, const std::string& code) {
    const bool has_field = has_word(code, "selfRobots") || has_word(code, "ourRobots");
    return is_header(path) && (has_field || has_word(code, "currentBall")) &&
           (has_word(code, "struct") || has_word(code, "class"));
  };
  std::vector<std::string> headers, sources;
  for (const auto& [path, code] : all.code) {
    if (defines(path, code)) headers.push_back(path);
    if (is_source(path) && uses(path) == 0) sources.push_back(path);
  }
  const std::string project = project_of(all, headers);
  team.sources = compiled_of(all, project, std::move(sources));
  if (!project.empty()) team.macros = all.projects.at(project).macros;
  if (headers.empty() || team.sources.empty()) {
    return fail(Errc::input,
                folder +
                    ": no header here defines a structure with \"currentBall\" or "
                    "\"selfRobots\", or there is no source; name the folder of the sources "
                    "of a team for SimuroSot");
  }
  std::map<std::string, std::string> compiled;
  for (const std::string& path : team.sources) compiled.emplace(path, all.code.at(path));
  const auto any_has = [&](const char* word) {
    return std::any_of(compiled.begin(), compiled.end(),
                       [&](const auto& one) { return has_word(one.second, word); });
  };
  team.style = any_has("GetInstruction")    ? "v5"
               : any_has("SetFormerRobots") ? "restart"
                                            : "classic";
  const auto entries = with_entry(compiled, entry_of(team.style));
  if (entries.empty()) team.lost_entry = entry_of(team.style);
  for (const auto& [path, code] : all.code) {
    if (is_header(path)) compiled.emplace(path, code);
  }
  team.standard = team.style == "v5" ? "gnu++17" : standard_of(compiled);
  // One that more files include comes first; of copies, the one nearest to the top.
  std::stable_sort(headers.begin(), headers.end(), [&](const auto& a, const auto& b) {
    const auto depth = [](const std::string& path) {
      return std::count(path.begin(), path.end(), '/');
    };
    return uses(a) != uses(b) ? uses(a) > uses(b) : depth(a) < depth(b);
  });
  MIROCUP_TRY(auto header, header_of(folder, all, headers, team.sources, entries));
  if (entries.size() > 1) {
    return fail(Errc::input, folder + ": " + entries[0] + " and " + entries[1] +
                                 " both define the functions that the platform calls; remove one "
                                 "of them, or name the folder of one");
  }
  team.header = std::move(header);
  MIROCUP_TRY_VOID(expect_plain(folder, team.header, ":[]"));
  for (const std::string& path : team.sources) MIROCUP_TRY_VOID(expect_plain(folder, path, ":[]"));
  return team;
}

}  // namespace mirocup::labs
