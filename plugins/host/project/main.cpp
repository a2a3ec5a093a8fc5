// SPDX-License-Identifier: MIT
//
// build/mirocup-project-compiler ARCHIVE FOLDER LIBRARY: makes a library from the archive of a
// project. It runs in the compiler's sandbox, in which reading the archive can do no harm either:
// its namespaces have no network and no file of the host, and its limits count for this program,
// too.
#include "plugins/host/project/compiler_command.hpp"
#include "plugins/host/project/unpack.hpp"

#include <algorithm>
#include <cctype>
#include <clocale>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace mirocup::plugins {

namespace {

struct ProjectSources {
  std::string root;                // the outermost folder whose content is not just one folder
  std::vector<std::string> c;      // sources in C: paths from the root, sorted
  std::vector<std::string> cpp;    // sources in C++: paths from the root, sorted
  std::vector<std::string> teams;  // those that export a team
  bool has_ready_file = false;     // a library or a file of Python, which are not compiled
};

namespace fs = std::filesystem;

bool is_test(const fs::path& path) {
  if (path.stem().string().ends_with("_test")) return true;
  const fs::path folder = path.parent_path();
  return std::any_of(folder.begin(), folder.end(),
                     [](const fs::path& part) { return part == "test" || part == "tests"; });
}

// An archive of a folder has that folder at its top, and nothing beside it.
fs::path root_of(fs::path folder) {
  while (true) {
    std::vector<fs::path> inside;
    for (const auto& entry : fs::directory_iterator(folder)) inside.push_back(entry.path());
    if (inside.size() != 1 || !fs::is_directory(inside.front())) return folder;
    folder = inside.front();
  }
}

// True if the source exports a team.
bool has_team(const fs::path& path) {
  std::ifstream in(path);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  return text.find("\nMIROCUP_EXPORT_TEAM(") != text.npos ||
         text.find("\nconst mirocup_strategy* mirocup_entry(void) {") != text.npos;
}

// Finds the sources of a project, but no files whose names end in _test before the dot, and no
// files in a folder test or tests.
ProjectSources sources_of_project(const std::string& folder) {
  ProjectSources sources;
  const fs::path root = root_of(folder);
  sources.root = root.string();
  for (const auto& entry : fs::recursive_directory_iterator(root)) {
    if (!entry.is_regular_file()) continue;
    const fs::path path = entry.path().lexically_relative(root);
    if (is_test(path)) continue;
    std::string end = path.extension();
    std::transform(end.begin(), end.end(), end.begin(), ::tolower);  // Windows writes TEAM.CPP
    const bool is_cpp = end == ".cpp" || end == ".cc" || end == ".cxx";
    sources.has_ready_file |= end == ".py" || end == ".so";
    if (!is_cpp && end != ".c") continue;
    (is_cpp ? sources.cpp : sources.c).push_back(path.string());
    if (has_team(entry.path())) sources.teams.push_back(path.string());
  }
  for (auto* names : {&sources.c, &sources.cpp, &sources.teams})
    std::sort(names->begin(), names->end());
  return sources;
}

int say_why(const std::string& why) {
  std::printf("%s\n", why.c_str());
  return refused_archive;
}

// Runs a compiler and returns its exit code.
int run(const std::vector<std::string>& command) {
  std::vector<char*> words;
  for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  const pid_t child = fork();
  if (child == 0) {
    execv(words[0], words.data());
    _exit(127);
  }
  int status = 0;
  if (child < 0 || waitpid(child, &status, 0) != child) return 1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 1;
}

// "./" keeps a compiler from taking a name for an option. The objects have numbers for names.
int compile(std::vector<std::string> command, const std::string& source,
            std::vector<std::string>& objects) {
  const std::string object = "/compile/" + std::to_string(objects.size()) + ".o";
  objects.push_back(object);
  const char* language = command[0] == c_compiler ? "c" : "c++";  // the compiler knows no TEAM.CPP
  command.insert(command.end(),
                 {"-I.", "-Iinclude", "-c", "-o", object, "-x", language, "./" + source});
  return run(command);
}

int make_library(const ProjectSources& sources, const std::string& library) {
  std::vector<std::string> objects;
  for (const std::string& source : sources.c) {
    if (const int code = compile({c_compiler, MIROCUP_C_OPTIONS}, source, objects); code != 0)
      return code;
  }
  for (const std::string& source : sources.cpp) {
    if (const int code = compile({cpp_compiler, MIROCUP_CPP_OPTIONS}, source, objects); code != 0)
      return code;
  }
  // Also for C alone: the simulator of skills.h needs the C++ library.
  std::vector<std::string> link{cpp_compiler, MIROCUP_LINK_OPTIONS, "-static-libstdc++"};
  link.insert(link.end(), {"-o", library});
  link.insert(link.end(), objects.begin(), objects.end());
  link.insert(link.end(), {"-lmirocup_predict", "-lm"});
  return run(link);
}

int run_project_compiler(const std::string& archive, const std::string& folder,
                         const std::string& library) {
  // libarchive reads names in UTF-8 only if the locale has the letters.
  std::setlocale(LC_CTYPE, "C.UTF-8");
  if (mkdir(folder.c_str(), 0755) != 0) return say_why("the folder of the project cannot be made");
  if (const auto unpacked = unpack(archive, folder); !unpacked)
    return say_why(unpacked.error().what);
  const ProjectSources sources = sources_of_project(folder);
  if (sources.teams.size() > 1)
    return say_why("both " + sources.teams[0] + " and " + sources.teams[1] +
                   " have a team: leave one of them out of the archive");
  const bool is_empty = sources.c.empty() && sources.cpp.empty();
  if (is_empty && sources.has_ready_file)
    return say_why(
        "only sources in C and C++ are compiled: hand in the library itself, or the "
        "file of Python; a team in Python is one file, with all its modules in it");
  if (is_empty)
    return say_why(
        "the archive has no source of a team: a file that ends in .cpp, .cc, .cxx or .c, outside "
        "of test, tests and build");
  if (chdir(sources.root.c_str()) != 0) return say_why("the folder of the project cannot be read");
  return make_library(sources, library) == 0 ? 0 : 1;
}

}  // namespace

}  // namespace mirocup::plugins

int main(int count, char** words) {
  if (count != 4) return 2;
  return mirocup::plugins::run_project_compiler(words[1], words[2], words[3]);
}
