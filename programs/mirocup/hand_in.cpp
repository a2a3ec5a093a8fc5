// SPDX-License-Identifier: MIT
//
// mirocup hand-in URL FILE: hands a library in to a league in the network and waits for the answer,
// or pins a version.
#include "programs/mirocup/commands.hpp"
#include "record/json_reader.hpp"
#include "system/files.hpp"
#include "system/printable.hpp"
#include "system/text.hpp"
#include "web/hand_in_client.hpp"

#include <algorithm>
#include <chrono>
#include <iostream>
#include <sys/stat.h>
#include <thread>

namespace mirocup::app {

namespace {

struct HandInOptions {
  std::string url;  // of the league
  std::string path;
  std::string token_file;
  std::string pin;        // "N" or "latest": no file is sent, and that entry plays; "": a file is
  std::string authority;  // file of the certificate that signs for the server; "": the system's
  bool progress = false;  // no file is sent: the versions are compared
  bool json = false;
};

using namespace std::chrono_literals;
using record::text_in;
using web::DeskReply;
using web::Json;

constexpr auto shortest_pause = 500ms;  // between two questions
constexpr auto pause_for_each = 100ms;  // check that comes before
constexpr auto longest_pause = 10'000ms;
constexpr auto patience = 120s;                 // with a server that does not answer
constexpr std::uint64_t max_token_file = 4096;  // bytes

int number_in(const Json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_number_integer() ? found->get<int>() : 0;
}

std::string state_in_words(const Json& report) {
  const std::string state = text_in(report, "state");
  if (state == "queued") {
    const int before = number_in(report, "before");
    return before == 0 ? "queued, the next" : "queued, " + std::to_string(before) + " before it";
  }
  if (state == "compiling") return "being compiled";
  if (state == "checking") {
    const Json step = report.value("step", Json());
    if (!step.is_object()) return "being checked";
    return "check " + std::to_string(number_in(step, "number")) + " of " +
           std::to_string(number_in(step, "of")) + ": " + text_in(step, "name");
  }
  return state;
}

// A class that waits together does not keep the server from checking.
std::chrono::milliseconds pause_after(const Json& report) {
  return std::min<std::chrono::milliseconds>(
      longest_pause, shortest_pause + number_in(report, "before") * pause_for_each);
}

bool is_final(const Json& report) {
  const std::string state = text_in(report, "state");
  return state == "accepted" || state == "refused" || state == "void";
}

Result<std::string> read_token(const std::string& path) {
  system::Disk disk;
  struct stat about {};
  if (stat(path.c_str(), &about) == 0 && (about.st_mode & (S_IRGRP | S_IROTH)) != 0)
    std::cerr << "others on this computer can read the token: chmod 600 " << system::printable(path)
              << '\n';
  auto text = disk.read_named(path, max_token_file);
  if (!text) return text;
  std::erase_if(*text, [](char c) { return c == '\n' || c == '\r' || c == ' ' || c == '\t'; });
  for (const char c : *text) {
    const bool is_good = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    if (!is_good) return fail(Errc::input, path + ": a token is expected, letters and digits");
  }
  if (text->empty()) return fail(Errc::input, path + " is empty; a token is expected");
  return text;
}

// Asks until there is an answer. A server that is started again goes on with what it has taken.
Result<Json> wait_for_answer(web::HandInClient& client, int entry) {
  std::string told;
  std::chrono::milliseconds pause = shortest_pause;
  auto answered_at = std::chrono::steady_clock::now();
  while (true) {
    const DeskReply reply = client.entry(entry);
    const auto now = std::chrono::steady_clock::now();
    const bool is_gone = reply.status == 0 || reply.status >= 500;
    if (!is_gone && reply.status != 200) return fail(Errc::input, reply.error);
    if (!is_gone) {
      answered_at = now;
      if (is_final(reply.json)) return reply.json;
      const std::string words = state_in_words(reply.json);
      if (words != told) std::cerr << system::printable(words) << std::endl;
      told = words;
      pause = pause_after(reply.json);
    } else if (now - answered_at > patience) {
      return fail(Errc::unavailable, reply.error + "; entry " + std::to_string(entry) +
                                         " was taken, and its page will have the answer");
    }
    std::this_thread::sleep_for(pause);
  }
}

void print_answer(const Json& report) {
  std::string message = text_in(report, "message");
  if (message.empty()) message = text_in(report, "reason");
  const Json told = report.value("told", Json::array());
  const bool is_whole =
      report.contains("plays") && !told.empty();  // the message is the same chained
  if (!is_whole) std::cout << system::printable(message) << '\n';
  for (const Json& line : told) std::cout << system::printable(line.get<std::string>()) << '\n';
  for (const Json& note : report.value("notes", Json::array()))
    std::cout << "warning: " << system::printable(text_in(note, "text")) << '\n';
  const std::string log = text_in(report, "log");
  if (!log.empty()) {
    std::cout << "--- log\n"
              << system::printable(log, system::LineEnds::kept) << "\n--- end of log\n";
  }
}

Result<DeskReply> checked(DeskReply reply, int expected) {
  if (reply.status == expected) return reply;
  const bool is_gone = reply.status == 0 || reply.status >= 500;
  return fail(is_gone ? Errc::unavailable : Errc::input, reply.error);
}

Result<int> pin_entry(const HandInOptions& options, const std::string& token) {
  MIROCUP_TRY(auto client, web::HandInClient::open(options.url, token, options.authority));
  MIROCUP_TRY(const auto pinned, checked(client->pin(options.pin), 200));
  if (options.json) {
    std::cout << record::json_text(pinned.json) << '\n';
  } else {
    std::cout << "entry " << number_in(pinned.json, "playing") << " plays\n";
  }
  return exit_yes;
}

// A line for each version of the team, the latest first, and what the latest does otherwise.
void print_progress(const Json& reply) {
  const Json progress = reply.value("progress", Json::array());
  if (progress.empty()) std::cout << "no entry has played a friendly against a house team yet\n";
  for (const Json& entry : progress) {
    std::cout << "entry " << number_in(entry, "entry")
              << system::formatted(": rating %+.0f (%+.0f to %+.0f)", entry.value("rating", 0.0),
                                   entry.value("low", 0.0), entry.value("high", 0.0));
    const Json against = entry.value("against", Json::object());
    for (const auto& [name, met] : against.items())
      std::cout << ", " << system::printable(name) << ' ' << number_in(met, "goals") << " : "
                << number_in(met, "against");
    const Json drills = entry.value("drills", Json());
    if (drills.is_object())
      std::cout << system::formatted(", drills %.1f", drills.value("score", 0.0));
    std::cout << '\n';
  }
  const std::string change = text_in(reply, "change");
  if (!change.empty()) std::cout << system::printable(change) << '\n';
}

Result<int> show_progress(const HandInOptions& options, const std::string& token) {
  MIROCUP_TRY(auto client, web::HandInClient::open(options.url, token, options.authority));
  MIROCUP_TRY(const auto reply, checked(client->friendlies(), 200));
  if (options.json) {
    std::cout << record::json_text(reply.json) << '\n';
  } else {
    print_progress(reply.json);
  }
  return exit_yes;
}

Result<int> run_hand_in(const HandInOptions& options) {
  MIROCUP_TRY(const auto token, read_token(options.token_file));
  if (options.progress) return show_progress(options, token);
  if (!options.pin.empty()) return pin_entry(options, token);
  if (options.path.empty()) return fail(Errc::input, "name the file to hand in, or --pin N");
  system::Disk disk;
  MIROCUP_TRY(const auto bytes, disk.read_named(options.path, system::size_limit::entry));
  MIROCUP_TRY(auto client, web::HandInClient::open(options.url, token, options.authority));
  // Asked first, so that nothing is sent in vain.
  MIROCUP_TRY(const auto about, checked(client->about(), 200));
  if (const std::string why = text_in(about.json, "why_not"); !why.empty())
    return fail(Errc::input, why);
  const std::size_t slash = options.path.rfind('/');
  const std::string name =
      slash == std::string::npos ? options.path : options.path.substr(slash + 1);
  MIROCUP_TRY(const auto taken, checked(client->put(name, bytes), 202));
  const int entry = number_in(taken.json, "entry");
  std::cerr << "entry " << entry << " was taken" << std::endl;
  MIROCUP_TRY(const auto report, wait_for_answer(*client, entry));
  if (options.json) {
    std::cout << record::json_text(report) << '\n';
  } else {
    print_answer(report);
  }
  const std::string state = text_in(report, "state");
  if (state == "void") return exit_code(Errc::host);
  return state == "accepted" ? exit_yes : exit_no;
}

}  // namespace

void add_hand_in(system::Commands& commands) {
  const auto [command, o] =
      commands.add(run_hand_in, "hand-in", for_teams,
                   "Hand a library in to a league on the network, and wait for the answer",
                   {"mirocup hand-in https://league.example:8443 mine.so --token-file token"});
  command.option("URL", o.url, "Address of the league, as https://league.example:8443").required();
  const system::Option file = command.option(
      "FILE", o.path,
      "Library of the team, its source, its file of Python, or an archive of its project");
  command
      .option("--pin", o.pin,
              "Send no file, but let this accepted entry play; latest: the latest accepted one")
      .named("N")
      .excludes(file);
  command
      .flag("--progress", o.progress,
            "Send no file: print goals against each house team, rating and drills of each version")
      .excludes(file);
  command.option("--token-file", o.token_file, "File with the token of the team")
      .named("FILE")
      .required();
  command
      .option("--ca", o.authority,
              "File with the certificate of the authority that signed the server's certificate "
              "(default: the system's certificates)")
      .named("FILE");
  command.flag("--json", o.json, "Print the answer as one JSON object");
}

}  // namespace mirocup::app
