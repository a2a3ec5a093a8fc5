// SPDX-License-Identifier: MIT
#include "tests/support/program.hpp"

#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <sys/wait.h>
#include <unistd.h>

namespace mirocup::test_support {

namespace {

std::string temporary_name() {
  std::string name = (std::filesystem::temp_directory_path() / "mirocup-test-XXXXXX").string();
  const int fd = mkstemp(name.data());
  if (fd < 0) throw std::runtime_error("no temporary file");
  close(fd);
  return name;
}

// Leagues of tests put nothing on this user's list of programs.
std::string state_folder() {
  const auto folder = std::filesystem::temp_directory_path() / "mirocup-test-state-";
  return "XDG_STATE_HOME=" + folder.string() + std::to_string(geteuid());
}

// Returns this process's environment and a variable that it does not set itself.
std::vector<char*> environment_with(const std::string& variable) {
  const std::string name = variable.substr(0, variable.find('='));
  std::vector<char*> variables;
  if (getenv(name.c_str()) == nullptr) variables.push_back(const_cast<char*>(variable.c_str()));
  for (char** one = environ; *one != nullptr; ++one) variables.push_back(*one);
  variables.push_back(nullptr);
  return variables;
}

// Whether every user can read the file, and search each folder on the way to it.
bool is_for_all(const std::filesystem::path& file) {
  using std::filesystem::perms;
  perms needed = perms::others_read;
  for (auto at = std::filesystem::canonical(file);; at = at.parent_path()) {
    if ((std::filesystem::status(at).permissions() & needed) == perms::none) return false;
    if (at == at.root_path()) return true;
    needed = perms::others_exec;
  }
}

}  // namespace

Running::Running(const std::vector<std::string>& arguments)
    : out_(temporary_name()), err_(temporary_name()) {
  std::vector<std::string> words = arguments;
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  const std::string state = state_folder();
  std::vector<char*> variables = environment_with(state);
  pid_ = fork();
  if (pid_ == 0) {
    // Nothing is allocated here: another thread may have held the allocator's lock.
    dup2(open("/dev/null", O_RDONLY), STDIN_FILENO);
    dup2(open(out_.c_str(), O_WRONLY | O_TRUNC), STDOUT_FILENO);
    dup2(open(err_.c_str(), O_WRONLY | O_TRUNC), STDERR_FILENO);
    execve(argv[0], argv.data(), variables.data());
    _exit(126);
  }
}

Running::~Running() {
  if (pid_ > 0) {
    kill(pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
  }
  unlink(out_.c_str());
  unlink(err_.c_str());
}

void Running::signal(int number) const {
  kill(pid_, number);
}

Outcome Running::wait() {
  int status = 0;
  waitpid(pid_, &status, 0);
  pid_ = -1;
  return {WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status), read_file(out_),
          read_file(err_)};
}

std::string Running::out() const {
  return read_file(out_);
}

std::string Running::err() const {
  return read_file(err_);
}

Outcome run(const std::vector<std::string>& arguments) {
  return Running(arguments).wait();
}

Outcome run_mirocup(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), program("mirocup"));
  return run(arguments);
}

bool wait_until(const std::function<bool()>& holds) {
  for (int i = 0; i < 12'000; ++i) {
    if (holds()) return true;
    usleep(10'000);
  }
  return false;
}

const std::string& why_no_t2() {
  static const std::string why = [] {
    const Outcome asked = run({program("mirocup"), "match", "--blue", "idle", "--yellow", "idle",
                               "--half", "0.1", "--isolation", "T2"});
    const bool is_missing = asked.exit_code == 3 && asked.err.find("T1") != std::string::npos;
    return is_missing ? "T2 was not asked: " + asked.err : std::string();
  }();
  return why;
}

std::string program(const std::string& name) {
  return std::string(MIROCUP_BUILD_FOLDER) + "/" + name;
}

std::string program_for_all(const std::string& name) {
  const std::filesystem::path original = program(name);
  if (is_for_all(original) && original.string().find(' ') == std::string::npos) return original;
  static const TemporaryFolder copies(place_for_all);
  const std::filesystem::path copy = copies / name;
  if (!std::filesystem::exists(copy)) {
    std::filesystem::create_directories(copy.parent_path());
    std::filesystem::copy_file(original, copy);
    for (const auto& made : {std::filesystem::path(copies / ""), copy.parent_path(), copy}) {
      std::filesystem::permissions(made, std::filesystem::perms{0755});
    }
  }
  return copy;
}

std::vector<std::string> mirocup_of_nobody() {
  for (const char* name : {"mirocup-plugin-host", "house/idle.so", "house/chaser.so"}) {
    program_for_all(name);
  }
  return {"/usr/bin/setpriv", "--reuid=65534", "--regid=65534", "--clear-groups",
          program_for_all("mirocup")};
}

std::string read_file(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

void write_file(const std::string& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

nlohmann::ordered_json read_json(const std::string& path) {
  return nlohmann::ordered_json::parse(read_file(path));
}

}  // namespace mirocup::test_support
