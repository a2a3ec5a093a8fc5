// SPDX-License-Identifier: MIT
#include "server/app/old_sources.hpp"

#include "system/files.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <regex>

namespace mirocup::app {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t max_files = 2000;

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : static_cast<char>(c);
  });
  return text;
}

bool ends_with_any(const std::string& path, std::initializer_list<const char*> endings) {
  const std::string ending = lower(fs::path(path).extension().string());
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

// The names in the #include lines of the code, in lower case and without their folders.
std::vector<std::string> included_by(const std::string& code) {
  static const std::regex line("#[ \t]*include[ \t]*[\"<]([^\">\n]+)[\">]");
  std::vector<std::string> names;
  for (std::sregex_iterator at(code.begin(), code.end(), line), end; at != end; ++at) {
    std::string name = (*at)[1];
    std::replace(name.begin(), name.end(), '\\', '/');
    names.push_back(lower(fs::path(name).filename().string()));
  }
  return names;
}

// Reads all sources and headers of the folder: path to code.
Result<std::map<std::string, std::string>> read_all(const std::string& folder) {
  std::map<std::string, std::string> code;
  system::Disk disk;
  std::error_code error;
  fs::recursive_directory_iterator at(folder, error), end;
  if (error) return fail(Errc::input, folder + ": " + error.message());
  for (; !error && at != end; at.increment(error)) {
    const std::string name = at->path().filename().string();
    const bool is_built = lower(name) == "debug" || lower(name) == "release" || name == "x64";
    if (at->is_directory(error) && (name.front() == '.' || is_built)) {
      at.disable_recursion_pending();
      continue;
    }
    const std::string path = fs::relative(at->path(), folder).string();
    if (!at->is_regular_file(error) || (!is_source(path) && !is_header(path))) continue;
    if (path.find_first_of("\"$;\\\n") != std::string::npos) {
      return fail(Errc::input, folder + "/" + path + ": CMake cannot take this name; change it");
    }
    auto text = disk.read(at->path().string(), {.max_size = system::size_limit::note});
    if (!text) return tl::unexpected(text.error());
    code.emplace(path, code_of(*text));
    if (code.size() > max_files) {
      return fail(Errc::input, folder + ": more than " + std::to_string(max_files) +
                                   " sources; name the folder of one team");
    }
  }
  return code;
}

}  // namespace

Result<OldSources> find_old_sources(const std::string& folder) {
  const auto all = read_all(folder);
  if (!all) return tl::unexpected(all.error());
  OldSources team;
  bool has_v5 = false, has_restart = false, is_modern = false;
  std::map<std::string, int> included;  // by how many files
  for (const auto& [path, code] : *all) {
    team.files.push_back(path);
    has_v5 = has_v5 || (is_source(path) && has_word(code, "GetInstruction"));
    has_restart = has_restart || (is_source(path) && has_word(code, "SetFormerRobots"));
    for (const char* word : {"nullptr", "constexpr", "auto", "override", "unordered_map"}) {
      is_modern = is_modern || has_word(code, word);
    }
    for (const std::string& name : included_by(code)) ++included[name];
  }
  team.style = has_v5 ? "v5" : has_restart ? "restart" : "classic";
  team.standard = has_v5 ? "gnu++17" : is_modern ? "gnu++14" : "gnu++98";

  const auto defines = [](const std::string& path, const std::string& code) {
    return is_header(path) && (has_word(code, "selfRobots") || has_word(code, "currentBall")) &&
           (has_word(code, "struct") || has_word(code, "class"));
  };
  std::vector<std::string> headers;
  for (const auto& [path, code] : *all) {
    if (defines(path, code)) headers.push_back(path);
    const bool is_included = included[lower(fs::path(path).filename().string())] > 0;
    if (is_source(path) && !is_included) team.sources.push_back(path);
  }
  const auto uses = [&](const std::string& path) {
    return included[lower(fs::path(path).filename().string())];
  };
  std::stable_sort(headers.begin(), headers.end(),
                   [&](const auto& a, const auto& b) { return uses(a) > uses(b); });
  if (headers.empty() || team.sources.empty()) {
    return fail(Errc::input,
                folder +
                    ": no header here defines a structure with \"currentBall\" or "
                    "\"selfRobots\", or there is no source; name the folder of the sources "
                    "of a team for SimuroSot");
  }
  for (const std::string& other : headers) {
    if (fs::path(other).parent_path() == fs::path(headers.front()).parent_path()) continue;
    return fail(Errc::input, folder + ": more than one team, with " + headers.front() + " and " +
                                 other + "; name the folder of one of them");
  }
  team.header = headers.front();
  return team;
}

}  // namespace mirocup::app
