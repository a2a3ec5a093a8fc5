// SPDX-License-Identifier: MIT
#include "plugins/host/compile.hpp"

#include "plugins/host/file_advice.hpp"
#include "plugins/host/project/compiler_command.hpp"
#include "plugins/host/sandbox/fork.hpp"
#include "plugins/host/sandbox/private_root.hpp"
#include "plugins/host/sandbox/probe.hpp"
#include "system/descriptor.hpp"
#include "system/files.hpp"
#include "system/process_tree.hpp"
#include "system/text.hpp"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <poll.h>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <sys/mman.h>
#include <sys/mount.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <utility>
#include <vector>

namespace mirocup::plugins {

namespace {

namespace fs = std::filesystem;
using std::chrono::steady_clock;

constexpr int result_descriptor = 3;
constexpr int step_descriptor = 4;      // to which a step that failed is written
constexpr int compiler_descriptor = 5;  // the program that compiles, if it is none of the system

// The exit codes of the first process of the sandbox.
constexpr int compiled = 0;
constexpr int not_compiled = 1;
constexpr int too_much = 2;             // the compiler was ended by a limit; 3: refused_archive
constexpr int no_sandbox_stands = 127;  // of give_up()

constexpr const char* library_path = "/compile/strategy.so";
constexpr const char* to_library = "-o/compile/strategy.so";
constexpr const char* source_path = "/compile/source";
constexpr const char* static_cpp = "-Wl,-Bstatic,-lstdc++,-Bdynamic";
const char* const compile_environment[] = {"PATH=/usr/bin", "LANG=C", "TMPDIR=/compile", nullptr};

const char* const cpp_command[] = {cpp_compiler,        MIROCUP_CPP_OPTIONS, MIROCUP_LINK_OPTIONS,
                                   "-static-libstdc++", to_library,          "-xc++",
                                   source_path,         "-lmirocup_predict", nullptr};
// The simulator of skills.h needs the C++ library.
const char* const c_command[] = {
    c_compiler,  MIROCUP_C_OPTIONS,   MIROCUP_LINK_OPTIONS, to_library, "-xc",
    source_path, "-lmirocup_predict", static_cpp,           "-lm",      nullptr};
const char* const project_command[] = {"mirocup-project-compiler", source_path, "/compile/project",
                                       library_path, nullptr};

// The file tree of the compiler in the tier `compile` (plugins/host/README.md): the system's
// compiler, headers and libraries, read-only, the headers of a strategy, and one folder in memory.

// The folder in which the compiler works. The folder has the source, and later the library.
constexpr const char* work_folder = "/compile";
constexpr const char* headers_folder = "/mirocup/include";
constexpr const char* tree_options = "size=16m,mode=755";
constexpr const char* work_options = "size=256m,mode=700";

// What the compiler needs, beside library_folders, which have its parts and the libraries.
constexpr const char* compiler_folders[] = {"/bin", "/usr/bin", "/usr/include", "/usr/libexec"};

// A file that the tree gets.
struct TreeFile {
  std::string path;  // absolute path in the tree; its folders must come earlier in the list
  std::string bytes;
  bool is_folder = false;
};

bool is_work(const TreeFile& file) {
  return file.path.starts_with(std::string_view("/compile/"));
}

bool write_file(const TreeFile& file) {
  if (file.is_folder) return mkdir(file.path.c_str(), 0755) == 0;
  const system::Descriptor out(
      open(file.path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0444));
  std::size_t done = 0;
  while (out.is_open() && done < file.bytes.size()) {
    const ssize_t n =
        TEMP_FAILURE_RETRY(write(out.get(), file.bytes.data() + done, file.bytes.size() - done));
    if (n <= 0) return false;
    done += static_cast<std::size_t>(n);
  }
  return out.is_open();
}

// Makes the tree and makes it the root. Files below the work folder are in memory; all other files
// are read-only. Precondition: the process has its own mount namespace. The function allocates
// nothing, so it may be called after fork. Returns null on success, else the step that failed;
// errno says why.
const char* enter_toolchain_root(std::span<const TreeFile> files) {
  if (const char* step = begin_root(
          tree_options, {"usr", "usr/local", "etc", "mirocup", "mirocup/include", work_folder + 1}))
    return step;
  for (const char* folder : compiler_folders) {
    if (!show_folder(folder)) return folder;
  }
  if (const char* step = change_root()) return step;
  for (const TreeFile& file : files) {
    if (!is_work(file) && !write_file(file)) return "the headers of a strategy";
  }
  if (!make_read_only("/")) return "a root that is read only";
  if (mount("work", work_folder, "tmpfs", MS_NOSUID | MS_NODEV, work_options) != 0 ||
      chdir(work_folder) != 0)
    return "the folder in which the compiler works";
  for (const TreeFile& file : files) {
    if (is_work(file) && !write_file(file)) return "the source";
  }
  return nullptr;
}

// Adds the headers with their folders.
Result<void> add_headers(const fs::path& folder, const std::string& below,
                         std::vector<TreeFile>& files) {
  system::Disk disk;
  files.push_back({.path = below, .bytes = "", .is_folder = true});
  MIROCUP_TRY(const auto names, disk.names_in(folder.string()));
  for (const std::string& name : names) {
    if (fs::is_directory(folder / name)) {
      if (auto added = add_headers(folder / name, below + "/" + name, files); !added) return added;
      continue;
    }
    MIROCUP_TRY(auto bytes, disk.read_named((folder / name).string(), system::size_limit::note));
    files.push_back({.path = below + "/" + name, .bytes = std::move(bytes)});
  }
  return {};
}

// Adds the library of predict.hpp. An empty one in its place lets the fixed command stand.
Result<void> add_predict(const std::string& path, std::vector<TreeFile>& files) {
  system::Disk disk;
  std::string bytes = "!<arch>\n";
  if (disk.exists(path)) {
    MIROCUP_TRY(bytes, disk.read_named(path, system::size_limit::entry));
  }
  files.push_back({.path = "/mirocup/lib", .bytes = "", .is_folder = true});
  files.push_back({.path = "/mirocup/lib/libmirocup_predict.a", .bytes = std::move(bytes)});
  return {};
}

// What runs in the sandbox is given before the fork, because the child may allocate nothing.
struct Work {
  std::vector<TreeFile> files;
  const char* const* command = nullptr;
  bool is_program_given = false;  // then the command's first word is a name only
  CompileLimits limits;
  int program = -1;
  int output = -1;
  int result = -1;
  int step = -1;
};

bool arrange_work(const Work& work) {
  const int nothing = open("/dev/null", O_RDONLY);
  const int program = work.is_program_given ? work.program : nothing;
  const int from[] = {nothing, work.output, work.output, work.result, work.step, program};
  return take_descriptors(from);
}

bool limit(int resource, rlim_t most) {
  const rlimit both{most, most};
  return setrlimit(static_cast<__rlimit_resource_t>(resource), &both) == 0;
}

[[noreturn]] void become_compiler(const Work& work) {
  constexpr rlim_t processes = 64;
  constexpr rlim_t descriptors = 256;
  const bool is_limited = limit(RLIMIT_CPU, work.limits.cpu_seconds) &&
                          limit(RLIMIT_AS, work.limits.memory) && limit(RLIMIT_CORE, 0) &&
                          limit(RLIMIT_FSIZE, rlim_t{128} << 20) &&
                          limit(RLIMIT_NPROC, processes) && limit(RLIMIT_NOFILE, descriptors) &&
                          prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0;
  if (!is_limited) give_up(step_descriptor, "limits");
  // The compiler speaks to nobody but by its output.
  close(result_descriptor);
  fcntl(step_descriptor, F_SETFD, FD_CLOEXEC);
  fcntl(compiler_descriptor, F_SETFD, FD_CLOEXEC);
  auto* const command = const_cast<char* const*>(work.command);
  auto* const environment = const_cast<char* const*>(compile_environment);
  if (work.is_program_given) {
    fexecve(compiler_descriptor, command, environment);
  } else {
    execve(command[0], command, environment);
  }
  give_up(step_descriptor, "the start of the compiler");
}

// Waits for that process, and for those that it has left behind.
int wait_for(pid_t pid) {
  int result = 0;
  int status = 0;
  for (long ended; (ended = TEMP_FAILURE_RETRY(waitpid(-1, &status, 0))) >= 0;) {
    if (ended != pid) continue;
    result = status;
    kill(-1, SIGKILL);
  }
  return result;
}

bool hand_over_library(std::size_t most) {
  const system::Descriptor file(open(library_path, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
  struct stat about {};
  if (!file.is_open() || fstat(file.get(), &about) != 0 || !S_ISREG(about.st_mode)) return false;
  return static_cast<std::size_t>(about.st_size) <= most &&
         send_file(result_descriptor, file.get(), about.st_size);
}

[[noreturn]] void compile_here(const Work& work) {
  setsid();
  for (int number = 1; number < NSIG; ++number) signal(number, SIG_DFL);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  umask(022);
  if (!arrange_work(work)) give_up(work.step, "descriptors");
  if (const char* step = enter_toolchain_root(work.files)) give_up(step_descriptor, step);
  const auto pid = static_cast<pid_t>(syscall(SYS_clone, SIGCHLD, 0, 0, 0, 0));
  if (pid < 0) give_up(step_descriptor, "a process");
  if (pid == 0) become_compiler(work);
  const int status = wait_for(pid);
  if (WIFSIGNALED(status)) _exit(too_much);
  if (WEXITSTATUS(status) == no_sandbox_stands) _exit(no_sandbox_stands);
  if (WEXITSTATUS(status) == refused_archive) _exit(refused_archive);
  if (WEXITSTATUS(status) != 0) _exit(not_compiled);
  _exit(hand_over_library(work.limits.library) ? compiled : too_much);
}

// Reads what the compiler says until it has ended. Returns false if it has used up its processor
// time, and an error if it was given none for too long.
Result<bool> listen_to(int output, pid_t compiler, const CompileLimits& limits, std::string& text) {
  constexpr auto look_interval = std::chrono::milliseconds(250);
  const auto end = steady_clock::now() + std::chrono::duration<double>(limits.wall);
  auto next_look = steady_clock::now() + look_interval;
  while (true) {
    const auto now = steady_clock::now();
    if (now >= end)
      return fail(Errc::host, "compiling a source did not end within " +
                                  std::to_string(static_cast<int>(limits.wall)) + " s");
    if (now >= next_look) {
      const double used = system::use_of_trees({compiler}).at(compiler).seconds;
      if (used > limits.seconds) return false;
      next_look = steady_clock::now() + look_interval;
    }
    pollfd waiting{.fd = output, .events = POLLIN, .revents = 0};
    if (poll(&waiting, 1, static_cast<int>(look_interval.count())) <= 0) continue;
    char bytes[65536];
    const ssize_t count = read(output, bytes, sizeof bytes);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return true;
    // More is read, so that the compiler goes on, and forgotten.
    const std::size_t room = limits.output - std::min(limits.output, text.size());
    text.append(bytes, std::min(room, static_cast<std::size_t>(count)));
  }
}

tl::unexpected<Error> cannot(const char* what) {
  return fail(Errc::host, std::string(what) + ": " + std::strerror(errno));
}

// Reads a file in memory.
std::string read_all(int file, std::size_t size) {
  std::string bytes(size, '\0');
  bytes.resize(static_cast<std::size_t>(std::max<ssize_t>(0, pread(file, bytes.data(), size, 0))));
  return bytes;
}

// Returns the place of the compiler's first error, as " at line 17" or " at plan.cpp, line 17"; ""
// if it names none.
std::string place_of_error(std::string_view words) {
  words = words.substr(0, std::min(words.find(": error: "), words.find(": fatal error: ")));
  words.remove_prefix(words.rfind('\n') + 1);  // file:line:column, if that was found
  const std::size_t file = words.find(':');
  const std::size_t line = words.find(':', file + 1);
  if (file == std::string_view::npos || line == std::string_view::npos) return "";
  return " at " +
         (words.starts_with(source_path) ? "" : std::string(words.substr(0, file)) + ", ") +
         "line " + std::string(words.substr(file + 1, line - file - 1));
}

// Returns what to do about the compiler's first error, after a colon; "" if it says so itself.
std::string advice_on(std::string_view words) {
  const std::size_t first = std::min(words.find(": error: "), words.find(": fatal error: "));
  words.remove_prefix(std::min(first, words.size()));
  words = words.substr(0, words.find(": error: ", 1));
  std::istringstream table{std::string(compile_advice("compile_advice.txt"))};
  for (std::string line; std::getline(table, line);) {
    const std::size_t bar = line.find(" | ");
    const bool is_row = bar != std::string::npos && !line.starts_with('#');
    if (is_row && words.find(line.substr(0, bar)) != std::string_view::npos)
      return ": " + line.substr(bar + 3);
  }
  return "";
}

// Returns what became of it, after the sandbox has ended with that status.
Result<Compiled> judge(int status, bool is_in_time, const Work& work, int result, int step,
                       Compiled compiled_so_far) {
  Compiled done = std::move(compiled_so_far);
  const int code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  if (is_in_time && code == no_sandbox_stands)
    return fail(Errc::unavailable, "the compiler's sandbox cannot be made: " + read_all(step, 200));
  if (!is_in_time) {
    done.why_not = "compiling it takes more than " +
                   std::to_string(static_cast<int>(work.limits.seconds)) +
                   " s of processor time: let it have fewer templates, constexpr or sources";
  } else if (code == refused_archive) {
    done.why_not = system::last_line(done.output);
    done.output.clear();
  } else if (code == not_compiled) {
    done.why_not = "it does not compile" + place_of_error(done.output) +
                   "; the log has the compiler's words" + advice_on(done.output);
  } else if (code != compiled) {
    done.why_not = "compiling it takes more time, memory or disk than a team may use";
  } else {
    struct stat about {};
    if (fstat(result, &about) != 0) return cannot("the library cannot be read");
    done.library = read_all(result, static_cast<std::size_t>(about.st_size));
  }
  return done;
}

}  // namespace

Result<Compiled> compile_in_sandbox(const std::string& source, SourceLanguage language,
                                    const CompilerKit& kit, const CompileLimits& limits) {
  if (const std::string why_not = why_no_t2(); !why_not.empty()) {
    return fail(Errc::unavailable,
                "sources are not compiled here; hand in the library: " + why_not);
  }
  const bool is_c = language == SourceLanguage::c;
  const char* const compiler = is_c ? c_compiler : cpp_compiler;
  if (access(compiler, X_OK) != 0)
    return fail(Errc::unavailable,
                "sources are not compiled here: there is no " + std::string(compiler));
  if (std::string why_not = objection_to_source(source); !why_not.empty())
    return Compiled{.library = {}, .why_not = std::move(why_not), .output = {}};
  Work work;
  work.limits = limits;
  work.command = is_c ? c_command : cpp_command;
  system::Descriptor program;
  if (language == SourceLanguage::project) {
    program = system::Descriptor(open(kit.project_compiler.c_str(), O_RDONLY | O_CLOEXEC));
    if (!program.is_open())
      return fail(Errc::unavailable, kit.project_compiler + ": this program is missing here");
    work.command = project_command;
    work.is_program_given = true;
    work.program = program.get();
  }
  MIROCUP_TRY_VOID(
      add_headers(kit.headers, std::string(headers_folder) + "/mirocup", work.files).and_then([&] {
        return add_predict(kit.predict, work.files);
      }));
  work.files.push_back({.path = source_path, .bytes = source});

  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) return cannot("a pipe cannot be made");
  const system::Descriptor output(ends[0]);
  system::Descriptor speaking(ends[1]);
  const system::Descriptor result(memfd_create("strategy.so", MFD_CLOEXEC));
  const system::Descriptor step(memfd_create("step", MFD_CLOEXEC));
  if (!result.is_open() || !step.is_open()) return cannot("memory cannot be shared");
  work.output = speaking.get();
  work.result = result.get();
  work.step = step.get();
  MIROCUP_TRY(const auto pid, fork_isolated(Isolation::T2, [&work] { compile_here(work); }));
  speaking.reset();
  Compiled done;
  const auto is_in_time = listen_to(output.get(), pid, limits, done.output);
  // The first process of the namespace takes all others with it.
  if (!is_in_time || !*is_in_time) kill(pid, SIGKILL);
  int status = 0;
  TEMP_FAILURE_RETRY(waitpid(pid, &status, 0));
  if (!is_in_time) return tl::unexpected(is_in_time.error());
  auto judged = judge(status, *is_in_time, work, result.get(), step.get(), std::move(done));
  if (judged && !judged->why_not.empty() && language != SourceLanguage::project) {
    if (std::string other = advice_on_no_source(source); !other.empty())
      judged->why_not = std::move(other);
  }
  return judged;
}

}  // namespace mirocup::plugins
