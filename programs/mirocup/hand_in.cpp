// SPDX-License-Identifier: MIT
//
// mirocup hand-in URL FILE: hands a library in to a league in the network and waits for the answer,
// or pins a version.
#include "programs/mirocup/commands.hpp"
#include "system/text.hpp"
#include "web/http/client.hpp"

#include <algorithm>
#include <cctype>
#include <chrono>
#include <filesystem>
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
using record::JsonReader;
using web::Answer;

constexpr auto shortest_pause = 1000ms;  // between two questions
constexpr auto pause_for_each = 100ms;   // check that comes before
constexpr auto longest_pause = 10'000ms;
constexpr auto patience = 120s;                 // with a server that does not answer
constexpr std::uint64_t max_token_file = 4096;  // bytes
constexpr int max_entries = 1'000'000;

// The state of an entry, as the server tells it.
struct Report {
  std::string state;
  bool is_final = false;
  std::string text;  // for the user; of a final state, the whole answer in lines
  std::chrono::milliseconds pause = shortest_pause;  // until the next question
  std::string json;
};

// Returns the text at a key; "" if it is missing or null.
std::string text_at(const JsonReader& json, const char* key) {
  const auto found = json.find(key);
  return found ? found->text() : "";
}

std::string answer_in_words(const JsonReader& json) {
  const auto told = json.find("told");
  const auto notes = json.find("notes");
  std::string message = text_at(json, "message");
  if (message.empty()) message = text_at(json, "reason");
  std::string text;
  const bool is_whole =
      json.has("plays") && told && told->size() > 0;  // the message is the same chained
  if (!is_whole) text += system::printable(message) + "\n";
  for (const JsonReader& line : told ? told->elements() : std::vector<JsonReader>())
    text += system::printable(line.text()) + "\n";
  for (const JsonReader& note : notes ? notes->elements() : std::vector<JsonReader>())
    text += "warning: " + system::printable(note.at("text").text()) + "\n";
  const std::string log = text_at(json, "log");
  if (!log.empty())
    text += "--- log\n" + system::printable(log, system::LineEnds::kept) + "\n--- end of log\n";
  return text;
}

Report read_report(const JsonReader& json) {
  Report report;
  report.json = record::json_text(json.json());
  const std::string state = report.state = json.at("state").text();
  report.is_final = state == "accepted" || state == "refused" || state == "void";
  if (report.is_final) {
    report.text = answer_in_words(json);
  } else if (state == "queued") {
    const int before = json.at("before").integer(0, max_entries);
    report.text =
        before == 0 ? "queued, the next" : "queued, " + std::to_string(before) + " before it";
    // A class that waits together does not keep the server from checking.
    report.pause = std::min<std::chrono::milliseconds>(longest_pause,
                                                       shortest_pause + before * pause_for_each);
  } else if (state == "compiling") {
    report.text = "being compiled";
  } else if (state == "checking") {
    report.text = "being checked";
    if (const auto step = json.find("step")) {
      report.text = "check " + std::to_string(step->at("number").as<int>()) + " of " +
                    std::to_string(step->at("of").as<int>()) + ": " + step->at("name").text();
    }
  } else {
    json.at("state").complain("a state of an entry is expected, not " + json.at("state").quoted());
  }
  return report;
}

Result<std::string> read_token(const std::string& path) {
  system::Disk disk;
  struct stat about {};
  if (stat(path.c_str(), &about) == 0 && (about.st_mode & (S_IRGRP | S_IROTH)) != 0)
    std::cerr << "others on this computer can read the token: chmod 600 " << system::printable(path)
              << '\n';
  MIROCUP_TRY(std::string text, disk.read_named(path, max_token_file));
  std::erase_if(text, [](char c) { return c == '\n' || c == '\r' || c == ' ' || c == '\t'; });
  if (!std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isalnum(c); }))
    return fail(Errc::input, path + ": a token is expected, letters and digits");
  if (text.empty()) return fail(Errc::input, path + " is empty; a token is expected");
  return text;
}

// Returns the league's reason for a status, and without one what is known of the server.
Error unexpected_answer(const HandInOptions& options, const Answer& answer) {
  if (answer.status == 0) return {Errc::unavailable, answer.error};
  const std::string told = record::text_in(record::parse_json(answer.body).value, "error");
  if (told.empty())
    return {Errc::unavailable,
            "the server answers with status " + std::to_string(answer.status) +
                (options.url.starts_with("http://") ? "; it may expect https://" : "")};
  return {answer.status < 500 ? Errc::input : Errc::unavailable, told};
}

// Reads an answer of the server.
template <class Value>
Result<Value> read_answer(const HandInOptions& options, const Answer& answer,
                          Value (*read)(const JsonReader&), int expected = 200) {
  if (answer.status != expected) return tl::unexpected(unexpected_answer(options, answer));
  return record::read_json<Value>(answer.body, options.url + " does not answer as a league",
                                  Errc::unavailable, read);
}

// Asks until there is an answer. A server that is started again goes on with what it has taken.
Result<Report> wait_for_answer(const HandInOptions& options, const web::HttpClient& client,
                               int entry) {
  std::string told;
  std::chrono::milliseconds pause = shortest_pause;
  auto answered_at = std::chrono::steady_clock::now();
  while (true) {
    const Answer answer = client.ask("GET", "/api/v1/entries/" + std::to_string(entry));
    const auto now = std::chrono::steady_clock::now();
    if (answer.status != 0 && answer.status < 500) {
      answered_at = now;
      MIROCUP_TRY(auto report, read_answer(options, answer, read_report));
      if (report.is_final) return report;
      if (report.text != told) std::cerr << system::printable(report.text) << std::endl;
      told = report.text;
      pause = report.pause;
    } else if (now - answered_at > patience) {
      return fail(Errc::unavailable, unexpected_answer(options, answer).what + "; entry " +
                                         std::to_string(entry) +
                                         " was taken, and its page will have the answer");
    }
    std::this_thread::sleep_for(pause);
  }
}

std::string pinned_in_words(const JsonReader& json) {
  return "entry " + std::to_string(json.at("playing").integer(0, max_entries)) + " plays\n";
}

// A line for each version of the team, the latest first, and what the latest does otherwise.
std::string progress_in_words(const JsonReader& json) {
  std::string text;
  for (const JsonReader& entry : json.at("progress").elements()) {
    text += "entry " + std::to_string(entry.at("entry").as<int>()) +
            system::formatted(": rating %+.0f (%+.0f to %+.0f)", entry.at("rating").number(),
                              entry.at("low").number(), entry.at("high").number());
    for (const auto& [name, met] : entry.at("against").members())
      text += ", " + system::printable(name) + ' ' + std::to_string(met.at("goals").as<int>()) +
              " : " + std::to_string(met.at("against").as<int>());
    if (const auto drills = entry.find("drills"))
      text += system::formatted(", drills %.1f", drills->at("score").number());
    text += '\n';
  }
  if (text.empty()) text = "no entry has played a friendly against a house team yet\n";
  const std::string change = text_at(json, "change");
  return change.empty() ? text : text + system::printable(change) + "\n";
}

Result<int> print_answer(const HandInOptions& options, const Answer& answer,
                         std::string (*in_words)(const JsonReader&)) {
  if (options.json)
    in_words = [](const JsonReader& json) { return record::json_text(json.json()) + "\n"; };
  MIROCUP_TRY(const auto text, read_answer(options, answer, in_words));
  std::cout << text;
  return exit_yes;
}

Result<int> run_hand_in(const HandInOptions& options) {
  MIROCUP_TRY(const auto token, read_token(options.token_file));
  MIROCUP_TRY(const auto client,
              web::HttpClient::open(options.url, {.token = token, .authority = options.authority}));
  if (options.progress)
    return print_answer(options, client.ask("GET", "/api/v1/friendlies"), progress_in_words);
  if (!options.pin.empty()) {
    const std::string path = "/api/v1/pin?entry=" + system::percent_coded(options.pin);
    return print_answer(options, client.ask("PUT", path), pinned_in_words);
  }
  if (options.path.empty()) return fail(Errc::input, "name the file to hand in, or --pin N");
  system::Disk disk;
  MIROCUP_TRY(const auto bytes, disk.read_named(options.path, system::size_limit::entry));
  // Asked first, so that nothing is sent in vain.
  const auto why_not = [](const JsonReader& json) {
    json.expect_object();
    return text_at(json, "why_not");
  };
  MIROCUP_TRY(const auto why,
              read_answer<std::string>(options, client.ask("GET", "/api/v1/team"), why_not));
  if (!why.empty()) return fail(Errc::input, why);
  const std::string name = std::filesystem::path(options.path).filename();
  const std::string path = "/api/v1/entries?name=" + system::percent_coded(name);
  const auto number = [](const JsonReader& json) {
    return json.at("entry").integer(1, max_entries);
  };
  MIROCUP_TRY(const auto entry,
              read_answer<int>(options, client.ask("PUT", path, bytes), number, 202));
  std::cerr << "entry " << entry << " was taken" << std::endl;
  MIROCUP_TRY(const auto report, wait_for_answer(options, client, entry));
  std::cout << (options.json ? report.json + "\n" : report.text);
  if (report.state == "void") return exit_code(Errc::host);
  return report.state == "accepted" ? exit_yes : exit_no;
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
      .option("--pin N", o.pin,
              "Send no file, but let this accepted entry play; latest: the latest accepted one")
      .excludes(file);
  command
      .flag("--progress", o.progress,
            "Send no file: print goals against each house team, rating and drills of each version")
      .excludes(file);
  command.option("--token-file FILE", o.token_file, "File with the token of the team").required();
  command.option("--ca FILE", o.authority,
                 "File with the certificate of the authority that signed the server's certificate "
                 "(default: the system's certificates)");
  command.flag("--json", o.json, "Print the answer as one JSON object");
}

}  // namespace mirocup::app
