// SPDX-License-Identifier: MIT
//
// What a host sees of a league that is being played: a bar with the time that is left where
// standard error is a terminal, plain lines elsewhere. Catches a bar in a log file, lines that the
// bar has cut up, a bar that stays when the league is over.
#include "tests/programs/league/league_command.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <pty.h>
#include <regex>
#include <sys/wait.h>
#include <unistd.h>

namespace mirocup {
namespace {

using test_support::init_league;
using test_support::league;
using test_support::Outcome;
using test_support::run;
using test_support::TemporaryFolder;

// Runs a program on a terminal of its own; `err` is the whole output of that terminal.
Outcome run_on_a_terminal(std::vector<std::string> words) {
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  int terminal = -1;
  const pid_t pid = forkpty(&terminal, nullptr, nullptr, nullptr);
  if (pid == 0) {
    execv(argv[0], argv.data());
    _exit(126);
  }
  Outcome outcome;
  char bytes[4096];
  // Reading a terminal that no process has open any more returns an error.
  for (ssize_t size = 0; (size = read(terminal, bytes, sizeof bytes)) > 0;)
    outcome.err.append(bytes, static_cast<std::size_t>(size));
  int status = 0;
  waitpid(pid, &status, 0);
  close(terminal);
  outcome.exit_code = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
  return outcome;
}

// Returns the lines that remain visible on a terminal after this output.
std::string read_from_screen(const std::string& written) {
  const std::string clear_to_the_end = "\x1b[K";
  std::string lines;
  std::string row;
  std::size_t column = 0;
  for (std::size_t i = 0; i < written.size(); ++i) {
    if (written.compare(i, clear_to_the_end.size(), clear_to_the_end) == 0) {
      row.resize(column);
      i += clear_to_the_end.size() - 1;
    } else if (written[i] == '\r') {
      column = 0;
    } else if (written[i] == '\n') {
      lines += row + '\n';
      row.clear();
      column = 0;
    } else {
      row.replace(column++, 1, 1, written[i]);
    }
  }
  return lines + row;
}

void make_progress_league(const std::string& folder) {
  init_league(folder, {"a=house:chaser", "b=house:keeper", "c=house:striker"});
}

TEST(Progress, IsABarWithTheTimeLeftOnATerminal) {
  const TemporaryFolder temporary;
  make_progress_league(temporary / "l");
  const Outcome played = run_on_a_terminal(league("start", temporary / "l", {"--jobs", "1"}));
  ASSERT_EQ(played.exit_code, 0) << played.err;
  for (int decided = 0; decided <= 6; ++decided) {
    const std::string bar = "\r\\x1b\\[K\\[#{" + std::to_string(4 * decided) + "}\\.{" +
                            std::to_string(24 - 4 * decided) + "}\\]  " + std::to_string(decided) +
                            " of 6 legs, [01] playing" +
                            (decided > 0 && decided < 6 ? ", [1-9][0-9]* s left" : "\r");
    EXPECT_TRUE(std::regex_search(played.err, std::regex(bar))) << bar << '\n' << played.err;
  }
  make_progress_league(temporary / "plain");
  const Outcome plain = run(league("start", temporary / "plain", {"--jobs", "1"}));
  EXPECT_EQ(read_from_screen(played.err), plain.err + plain.out);
}

TEST(Progress, IsPlainLinesElsewhere) {
  const TemporaryFolder temporary;
  make_progress_league(temporary / "l");
  const Outcome played = run(league("start", temporary / "l", {"--jobs", "1"}));
  ASSERT_EQ(played.exit_code, 0) << played.err;
  EXPECT_NE(played.err.find("\n6/6  "), std::string::npos) << played.err;
  EXPECT_EQ(played.err.find_first_of("\r\x1b"), std::string::npos) << played.err;
  EXPECT_EQ(played.err.find(" left"), std::string::npos) << played.err;
}

}  // namespace
}  // namespace mirocup
