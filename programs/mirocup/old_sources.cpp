// SPDX-License-Identifier: MIT
#include "programs/mirocup/old_sources.hpp"

#include "programs/mirocup/old_text.hpp"
#include "system/files.hpp"
#include "system/text.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <regex>
#include <string>
#include <vector>

namespace mirocup::app {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t max_files = 2000;

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

bool has_word(const std::string& code, const std::string& word) {
  const auto is_part = [](unsigned char c) {
    return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_';
  };
  for (std::size_t at = code.find(word); at != std::string::npos; at = code.find(word, at + 1)) {
    const bool begins = at == 0 || !is_part(static_cast<unsigned char>(code[at - 1]));
    const std::size_t end = at + word.size();
    if (begins && (end == code.size() || !is_part(static_cast<unsigned char>(code[end])))) {
      return true;
    }
  }
  return false;
}

// True for the name of a project of Visual C++, which names the files to compile: .dsp of version
// 6, .vcproj, .vcxproj.
bool is_old_project(const std::string& path) {
  const std::string ending = system::lower_case(std::filesystem::path(path).extension().string());
  return ending == ".dsp" || ending == ".vcproj" || ending == ".vcxproj";
}

// Returns the files that the project compiles or shows, in the order of the text, relative to its
// folder, with "/" between folders. Empty if the text names no file.
// SOURCE=.\Move.cpp, RelativePath=".\Move.cpp", <ClCompile Include="Move.cpp" />
std::vector<std::string> files_of_project(const std::string& text) {
  static const std::regex one(
      "(?:SOURCE=\"?|RelativePath[ \t\r\n]*=[ \t\r\n]*\"|<ClCompile[ \t\r\n]+Include=\")"
      "([^\"\r\n<>|]+)");
  std::vector<std::string> files;
  for (std::sregex_iterator at(text.begin(), text.end(), one), end; at != end; ++at) {
    std::string name = (*at)[1];
    std::replace(name.begin(), name.end(), '\\', '/');
    while (!name.empty() && name.back() == ' ') name.pop_back();
    files.push_back(std::filesystem::path(name).lexically_normal().string());
  }
  return files;
}

// The names in the #include lines of the code, in lower case and without their folders.
std::vector<std::string> included_by(const std::string& code) {
  static const std::regex line("#[ \t]*include[ \t]*[\"<]([^\">\n]+)[\">]");
  std::vector<std::string> names;
  for (std::sregex_iterator at(code.begin(), code.end(), line), end; at != end; ++at) {
    std::string name = (*at)[1];
    std::replace(name.begin(), name.end(), '\\', '/');
    names.push_back(system::lower_case(fs::path(name).filename().string()));
  }
  return names;
}

struct Folder {
  std::map<std::string, std::string> code;  // of sources and headers, by their paths
  std::map<std::string, std::vector<std::string>> projects;  // what they name, by their paths
};

// Reads all sources, headers and projects of the folder.
Result<Folder> read_all(const std::string& folder) {
  Folder all;
  std::map<std::string, std::string>& code = all.code;
  system::Disk disk;
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
    if (path.find_first_of("\"$;\\\n") != std::string::npos) {
      return fail(Errc::input, folder + "/" + path + ": CMake cannot take this name; change it");
    }
    MIROCUP_TRY(auto text, disk.read(at->path().string(), {.max_size = system::size_limit::note}));
    if (is_project) {
      all.projects.emplace(path, files_of_project(readable(text)));
      continue;
    }
    code.emplace(path, code_of(readable(text)));
    if (code.size() > max_files) {
      return fail(Errc::input, folder + ": more than " + std::to_string(max_files) +
                                   " sources; name the folder of one team");
    }
  }
  if (error) return fail(Errc::unavailable, folder + " cannot be searched: " + error.message());
  return all;
}

// A standard of C++ that has what the code uses.
std::string standard_of(const std::map<std::string, std::string>& all) {
  static const std::array<const char*, 24> words{
      "nullptr",      "constexpr",    "override",      "unordered_map",    "unordered_set",
      "unique_ptr",   "shared_ptr",   "make_shared",   "to_string",        "stoi",
      "stod",         "emplace_back", "static_assert", "decltype",         "noexcept",
      "thread_local", "chrono",       "tuple",         "initializer_list", "mt19937",
      "cbegin",       "all_of",       "any_of",        "random_device"};
  // Loops over ranges, lambdas, enum class, "auto x =", "int x = 1" of a member is left to g++.
  static const std::regex forms(
      "\\bfor[ \t]*\\([^;(){}\n]*[^:;(){}\n]:[^:;(){}\n]*\\)|\\][ \t]*\\([^()\n]*\\)[ \t]*\\{|"
      "\\benum[ \t]+class\\b|\\bauto[ \t]*[&*]?[ \t]*[A-Za-z_0-9]+[ \t]*[=:]|=[ "
      "\t]*(default|delete)[ \t]*;|"
      "[A-Za-z_0-9]>>[ \t]*[A-Za-z_]+[ \t]*[;(={]");
  std::string standard = "gnu++98";
  for (const auto& [path, code] : all) {
    const bool is_newest = has_word(code, "string_view") || has_word(code, "optional") ||
                           has_word(code, "filesystem") || has_word(code, "variant");
    if (is_newest) return "gnu++17";
    const bool is_modern =
        std::any_of(words.begin(), words.end(),
                    [&code = code](const char* word) { return has_word(code, word); }) ||
        std::regex_search(code, forms);
    if (is_modern) standard = "gnu++14";
  }
  return standard;
}

// The case of a name does not count, as on Windows.
bool is_named(const std::vector<std::string>& names, const std::string& path) {
  return std::any_of(names.begin(), names.end(), [&](const std::string& name) {
    return system::lower_case(name) == system::lower_case(path);
  });
}

// The project that counts: of several the one nearest to the top, and of those the one for the
// newest Visual C++, since older ones are left over. Empty if there is none, or two are alike.
std::string project_of(const Folder& folder) {
  const auto rank = [](const std::string& path) {
    const std::string kind = system::lower_case(fs::path(path).extension().string());
    const int age = kind == ".vcxproj" ? 0 : kind == ".vcproj" ? 1 : 2;
    return std::pair(std::count(path.begin(), path.end(), '/'), age);
  };
  std::vector<std::string> paths;
  for (const auto& [path, files] : folder.projects) paths.push_back(path);
  std::stable_sort(paths.begin(), paths.end(),
                   [&](const auto& a, const auto& b) { return rank(a) < rank(b); });
  const bool are_two = paths.size() > 1 && rank(paths[0]) == rank(paths[1]);
  return paths.empty() || are_two ? "" : paths[0];
}

// The sources that the folder's project compiles; all of them if none counts, or if it names none
// of them.
std::vector<std::string> compiled_of(const Folder& folder, std::vector<std::string> sources) {
  const std::string project = project_of(folder);
  if (project.empty()) return sources;
  const std::vector<std::string>& files = folder.projects.at(project);
  const fs::path at = fs::path(project).parent_path();
  std::vector<std::string> names;
  for (const std::string& file : files) names.push_back((at / file).lexically_normal().string());
  std::vector<std::string> compiled;
  for (const std::string& source : sources) {
    if (is_named(names, source)) compiled.push_back(source);
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

bool is_below(const std::string& path, const fs::path& folder) {
  const std::string start = folder.empty() ? "" : folder.string() + "/";
  return path.compare(0, start.size(), start) == 0;
}

// The header, of those that define the platform's structures: the only one; or the first where the
// others are copies of it; or that of the folder in which all sources are.
Result<std::string> header_of(const std::string& folder, const Folder& all,
                              const std::vector<std::string>& headers,
                              const std::vector<std::string>& sources) {
  const std::string& first = headers.front();
  std::vector<std::string> others;
  for (const std::string& other : headers) {
    if (fs::path(other).parent_path() == fs::path(first).parent_path()) continue;
    if (without_blanks(all.code.at(other)) != without_blanks(all.code.at(first))) {
      others.push_back(other);
    }
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
                               others.front() + "; name the folder of one of them");
}

// The sources that define the function which the platform calls in every tick.
std::vector<std::string> with_entry(const std::map<std::string, std::string>& sources,
                                    const std::string& style) {
  const std::string name = style == "v5"        ? "GetInstruction"
                           : style == "restart" ? "RunStrategy"
                                                : "Strategy";
  const std::regex definition("\\b" + name + "[ \t\r\n]*\\([^;{()]*\\)[ \t\r\n]*\\{");
  std::vector<std::string> paths;
  for (const auto& [path, code] : sources) {
    if (std::regex_search(code, definition)) paths.push_back(path);
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
  team.sources = compiled_of(all, std::move(sources));
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
  const auto entries = with_entry(compiled, team.style);
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
  MIROCUP_TRY(auto header, header_of(folder, all, headers, team.sources));
  if (entries.size() > 1) {
    return fail(Errc::input, folder + ": " + entries[0] + " and " + entries[1] +
                                 " both define the functions that the platform calls; remove one "
                                 "of them, or name the folder of one");
  }
  team.header = std::move(header);
  return team;
}

}  // namespace mirocup::app
