// SPDX-License-Identifier: MIT
//
// mirocup join: lets a library, or a team in Python, play in a match on the network.
#include "mirocup/team.hpp"
#include "plugins/host/elf.hpp"
#include "plugins/host/file_advice.hpp"
#include "plugins/host/host_program.hpp"
#include "plugins/host/plugin.hpp"
#include "plugins/host/sealed_entry.hpp"
#include "plugins/host/team_host.hpp"
#include "programs/mirocup/commands.hpp"
#include "record/team_parameters_json.hpp"
#include "server/dds/credentials.hpp"
#include "system/clock.hpp"
#include "system/host_address.hpp"
#include "system/interrupt.hpp"

#include <chrono>
#include <ctime>

namespace mirocup::app {

namespace {

struct JoinOptions {
  std::string match_id;
  std::string team;
  std::string name;
  std::string library;
  std::string server = "127.0.0.1";
  int dds_domain = 0;
  std::string interface;
  std::string credentials;
  double join_within = 60.0;            // s to wait for the match
  std::vector<std::string> parameters;  // KEY=VALUE
};

using std::chrono::steady_clock;

// A server that sends nothing for longer than this is taken to be gone, s.
constexpr double max_silence = 10.0;
constexpr double poll_interval = 0.25;  // s, for interrupts
constexpr double hint_after = 5.0;      // s without a word from a server

// A team is warned if its credentials are valid for less than this, s.
constexpr std::int64_t short_validity = 86400;

// dlopen() searches for a name without a slash in the system's folders.
std::string library_path(const JoinOptions& options) {
  const bool is_bare = options.library.find('/') == std::string::npos;
  return is_bare ? "./" + options.library : options.library;
}

// Returns the path of mirocup-python.so if the file is a team in Python, and "" if it is a library
// that can be loaded.
Result<std::string> python_for(const JoinOptions& options) {
  const std::string path = library_path(options);
  if (const auto entry = plugins::SealedEntry::open(path)) {
    if (entry->is_python()) return plugins::python_module();
    const std::string known = plugins::advice_on_file(entry->bytes());
    const bool is_library = plugins::read_shared_library(entry->bytes()).has_value();
    if (!is_library && !known.empty()) return fail(Errc::input, options.library + ": " + known);
  }
  if (auto checked = plugins::Plugin::check(path); !checked)
    return fail(Errc::input, options.library + ": " + checked.error().text);
  return std::string();
}

// The match server refuses credentials that expire before the latest end of the leg.
void warn_of_expiry(const std::string& credentials) {
  if (credentials.empty()) return;
  const auto end = dds::credentials_end(credentials);
  const std::int64_t now = std::time(nullptr);
  if (!end || *end < now || *end - now >= short_validity) return;
  std::cerr << "mirocup: warning: the credentials in " << credentials << " are valid until "
            << system::TimeZone().text(*end) << " only\n";
}

// A team that answers the ticks that come over a connection.
class RemoteTeam {
 public:
  // `python` is what python_for() returned.
  RemoteTeam(const JoinOptions& options, std::string python,
             const match::TeamParameters& parameters, system::Interrupt& interrupt,
             team::Connection& match)
      : options_(options),
        python_(std::move(python)),
        given_(parameters),
        parameters_(plugins::parameter_table(parameters)),
        interrupt_(interrupt),
        match_(match) {}

  // Plays until the match is over.
  Result<int> play() {
    while (!interrupt_.is_asked_for()) {
      const int news = match_.wait(poll_interval);
      Result<void> done;
      switch (news) {
        case MIROCUP_TEAM_SEATED:
          done = take_seat();
          break;
        case MIROCUP_TEAM_TICK:
          done = answer();
          break;
        case MIROCUP_TEAM_OVER:
          return report();
        case MIROCUP_TEAM_REFUSED:
          return fail(Errc::unavailable, "the match server refuses the team: " + match_.text());
        default:
          done = check_silence();
      }
      if (!done) return tl::unexpected(done.error());
      if (news != MIROCUP_TEAM_NOTHING) heard_ = steady_clock::now();
    }
    return fail(Errc::interrupted, "interrupted");
  }

 private:
  // Loads the library afresh for every leg, as for a team with a process of its own.
  Result<void> take_seat() {
    plugin_.reset();
    setup_ = match_.setup();  // its drawing functions do nothing
    setup_.host = &host_;
    setup_.log = plugins::log_line;
    setup_.parameter = plugins::parameter_of;
    const std::string path = library_path(options_);
    auto plugin = python_.empty() ? plugins::Plugin::load(path, setup_)
                                  : plugins::load_python(path, python_, setup_);
    if (!plugin) return fail(Errc::input, options_.library + ": " + plugin.error().text);
    plugin_.emplace(std::move(*plugin));
    std::cerr << "mirocup: " << options_.name << " plays " << options_.team << " in match "
              << options_.match_id << '\n';
    return {};
  }

  Result<void> answer() {
    const mirocup_observation& now = match_.observation();
    if (now.placing != 0) {
      const auto placement = plugin_->place(now);
      if (!placement) return fail(Errc::input, options_.library + ": " + placement.error().text);
      match_.place(*placement);
    }
    const auto decided = plugin_->decide(now);
    if (!decided) return fail(Errc::input, options_.library + ": " + decided.error().text);
    match_.send(*decided);
    return {};
  }

  Result<void> check_silence() {
    const double silence = std::chrono::duration<double>(steady_clock::now() - heard_).count();
    if (!plugin_ && silence > hint_after && !has_hinted_) {
      has_hinted_ = true;
      std::cerr << "mirocup: no word from " << options_.server << " yet: " << match_.text()
                << ". Its firewall must let in UDP ports 7410 to 7429 (and more for another "
                   "--dds-domain), yours the answers; behind a router the match needs --nat\n";
    }
    if (!plugin_ && silence > options_.join_within)
      return fail(
          Errc::unavailable,
          match_.text() + ", for " + std::to_string(static_cast<int>(options_.join_within)) + " s");
    if (plugin_ && silence > max_silence) {
      return fail(Errc::unavailable, "nothing has come from the match server for 10 s");
    }
    return {};
  }

  int report() const {
    for (const auto& parameter : plugins::not_asked_for(given_, asked_)) {
      std::cerr << "mirocup: warning: the team did not ask for the parameter " << parameter.first
                << '\n';
    }
    std::cout << "the match is over (" << match_.text() << "): blue " << match_.score()[0]
              << ", yellow " << match_.score()[1] << '\n';
    return exit_yes;
  }

  const JoinOptions& options_;
  std::string python_;
  const match::TeamParameters& given_;
  plugins::ParameterTable parameters_;
  plugins::AskedRows asked_{0};
  plugins::TeamHost host_{&parameters_, &asked_};
  mirocup_setup setup_{};  // while the plugin lives
  system::Interrupt& interrupt_;
  team::Connection& match_;
  std::optional<plugins::Plugin> plugin_;
  steady_clock::time_point heard_ = steady_clock::now();
  bool has_hinted_ = false;
};

Result<int> run_join(const JoinOptions& options) {
  system::Interrupt interrupt;
  MIROCUP_TRY(const auto parameters,
              record::parameters_with_changes({}, options.parameters, "--param"));
  MIROCUP_TRY(const auto python, python_for(options));
  warn_of_expiry(options.credentials);
  MIROCUP_TRY(const auto server, system::address_of(options.server, options.join_within));
  team::Connection match({.match = options.match_id,
                          .team = index_of(*from_string<Team>(options.team)),
                          .name = options.name,
                          .server = server,
                          .domain = options.dds_domain,
                          .credentials = options.credentials,
                          .interface = options.interface});
  if (!match.is_open()) {
    return fail(match.is_wrong() ? Errc::input : Errc::unavailable, match.why());
  }
  return RemoteTeam(options, python, parameters, interrupt, match).play();
}

}  // namespace

void add_join(system::Commands& commands) {
  const auto [command, o] = commands.add(
      run_join, "join", for_teams, "Let a team play in a match on the network",
      {"mirocup join --match 7 --team blue --name ours mine.so",
       "mirocup join --match 7 --team yellow --name theirs their.so --server 10.0.0.5"});
  command.option("--match ID", o.match_id, "ID of the match").required();
  command.option("--team", o.team, "Colour of the team").required().one_of({"blue", "yellow"});
  command.option("--name NAME", o.name, "Name of the team, as the match expects it (dds:NAME)")
      .required();
  command.option("--server HOST", o.server, "Host on which the match runs").shows_default();
  command.option("--interface NAME", o.interface,
                 "Network interface that leads to the server (default: as the routing table says)");
  add_dds_domain(command, o.dds_domain);
  command.option("--join-within SECONDS", o.join_within, "Seconds to wait for the match")
      .between(0.0, longest_wait_s)
      .shows_default();
  command.option("--credentials DIR", o.credentials,
                 "Folder with the team's credentials, for a match that asks for them");
  add_parameters(command, "--param", o.parameters, "the team");
  command.option("FILE", o.library, "Library or file in Python of the team").required();
}

}  // namespace mirocup::app
