// SPDX-License-Identifier: MIT
#include "system/command_help.hpp"

#include "system/text.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <memory>
#include <sstream>

namespace mirocup::system {

namespace {

// "LEAGUE:\t{small,middle,large}" has the values of the option, "N:\t[1 to 10]" their range.
std::string bounded(const std::string& type, std::string_view open, std::string_view close) {
  const std::size_t begin = type.find(open);
  const std::size_t end = type.find(close, begin == std::string::npos ? 0 : begin);
  if (begin == std::string::npos || end == std::string::npos) return "";
  return type.substr(begin + open.size(), end - begin - open.size());
}

bool takes_value(const CLI::Option& option) {
  return option.get_items_expected_max() > 0;
}

// Returns the name of an option's value without the checks: "ADDR:PORT" for "ADDR:PORT", "N" for
// "N:\t[1 to 10]".
std::string own_value_name(const std::string& type) {
  const std::size_t mark = type.find(check_mark);
  return type.substr(0, mark == std::string::npos ? mark : mark - 1);
}

// What is typed after the option: "small|middle|large", "SECONDS", "[PORT]".
std::string value_text(const CLI::Option& option) {
  if (!takes_value(option)) return "";
  const std::string type = option.get_type_name();
  const bool has_words = type.find(check_mark + std::string("{")) != std::string::npos;
  return has_words ? replaced(bounded(type, "{", "}"), ",", "|") : own_value_name(type);
}

std::string option_text(const CLI::Option& option) {
  std::string text = option.get_description();
  std::vector<std::string> notes;
  const std::string range = bounded(option.get_type_name(), check_mark + std::string("["), "]");
  if (!range.empty()) notes.push_back(range);
  if (!option.get_default_str().empty()) notes.push_back("default: " + option.get_default_str());
  if (option.get_required()) notes.emplace_back("required");
  return notes.empty() ? text : text + " (" + joined(notes, "; ") + ")";
}

// Breaks lines so that the help fits into 100 columns.
std::string wrapped_text(const std::string& text) {
  constexpr std::size_t width = 66;
  std::istringstream words(text);
  std::string lines;
  std::size_t column = 0;
  for (std::string word; words >> word; column += word.size()) {
    if (column > 0 && column + 1 + word.size() > width) {
      lines += '\n';
      column = 0;
    } else if (column > 0) {
      lines += ' ';
      ++column;
    }
    lines += word;
  }
  return lines;
}

class HelpLayout final : public CLI::Formatter {
 public:
  HelpLayout() {
    column_width(34);
    label("SUBCOMMAND", "COMMAND");
  }

  std::string make_option_opts(const CLI::Option* option) const override {
    const std::string value = option->get_positional() ? "" : value_text(*option);
    return value.empty() ? "" : " " + value;
  }
  std::string make_option_desc(const CLI::Option* option) const override {
    return wrapped_text(option_text(*option));
  }
};

std::vector<const CLI::App*> visible_commands(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App* command) { return !command->get_group().empty(); });
}

bool is_hidden(const CLI::Option& option) {
  return option.get_group().empty();
}

// The option that takes the word after `word`; null if none does.
const CLI::Option* option_before(const CLI::App& command, const std::string& word) {
  if (word.size() < 2 || word.front() != '-') return nullptr;
  for (const CLI::Option* option : command.get_options()) {
    if (!option->get_positional() && option->check_name(word) && takes_value(*option))
      return option;
  }
  return nullptr;
}

// Lists what may stand where a word is expected.
class Candidates {
 public:
  explicit Candidates(std::string begun) : begun_(std::move(begun)) {}

  void add(const std::string& word, const std::string& description) {
    if (word.compare(0, begun_.size(), begun_) == 0)
      text_ += word + '\t' + description.substr(0, description.find('\n')) + '\n';
  }

  void add_value(const CLI::Option& option, std::span<const std::string> teams) {
    const std::string type = option.get_type_name();
    const std::string name =
        option.get_positional() ? option.get_name(true, false) : own_value_name(type);
    std::istringstream values(bounded(type, "{", "}"));
    bool has_values = false;
    for (std::string value; std::getline(values, value, ','); has_values = true) add(value, "");
    if (has_values) return;
    if (name.find("TEAM") != std::string::npos) {
      for (const std::string& team : teams) add(team, "house team");
      are_files_ = true;
    }
    for (const char* file : {"FILE", "DIR", "RECORD", "SITUATION", "SOURCE", "TRACE", "CERT"})
      are_files_ = are_files_ || name.find(file) != std::string::npos;
  }

  std::string text() const { return are_files_ ? text_ + ":files\n" : text_; }

 private:
  std::string begun_;
  std::string text_;
  bool are_files_ = false;
};

// In roff a backslash, a leading dot and a leading apostrophe have a meaning.
std::string roff(const std::string& text) {
  std::string escaped = replaced(replaced(text, "\\", "\\e"), "-", "\\-");
  if (!escaped.empty() && (escaped[0] == '.' || escaped[0] == '\'')) escaped.insert(0, "\\&");
  return replaced(replaced(escaped, "\n.", "\n\\&."), "\n'", "\n\\&'");
}

// The day of a page: that of SOURCE_DATE_EPOCH (s since 1970, UTC), with which the same build makes
// the same bytes, or today.
std::string page_date() {
  const char* given = std::getenv("SOURCE_DATE_EPOCH");
  const std::time_t seconds = given != nullptr ? std::atoll(given) : std::time(nullptr);
  std::tm day{};
  char text[16] = "";
  if (gmtime_r(&seconds, &day) != nullptr) std::strftime(text, sizeof text, "%Y-%m-%d", &day);
  return text;
}

constexpr const char* exit_status =
    ".SH EXIT STATUS\n0: done, the answer is yes. 1: done, the answer is no. 2: wrong usage or "
    "input. 3: a file or a program is not available. 4: data is damaged or of another version. 5: "
    "a fault of this computer, run it again. 130: interrupted, can be resumed.\n";

}  // namespace

const CLI::App* command_named(const CLI::App& app, const std::string& name) {
  const auto found =
      app.get_subcommands([&name](const CLI::App* command) { return command->get_name() == name; });
  return found.empty() ? nullptr : found.front();
}

void finish_help(CLI::App& app, std::span<const CommandHelp> commands) {
  const auto layout = std::make_shared<HelpLayout>();
  app.formatter(layout);
  for (CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    command->formatter(layout);
  for (const CommandHelp& help : commands) {
    CLI::App* command = app.get_subcommand(help.name);
    command->group(help.group);
    std::string examples = help.examples.empty() ? "" : "Examples:";
    for (const char* example : help.examples) examples += "\n  " + std::string(example);
    command->footer(examples);
  }
}

std::string completions(const CLI::App& app, std::span<const std::string> words,
                        std::span<const std::string> teams) {
  if (words.empty()) return "";
  const CLI::App* command = &app;
  for (const std::string& word : words.first(words.size() - 1)) {
    if (const CLI::App* below = command_named(*command, word)) command = below;
  }
  Candidates found(words.back());
  if (words.size() > 1) {
    if (const CLI::Option* waits = option_before(*command, words[words.size() - 2])) {
      found.add_value(*waits, teams);
      return found.text();
    }
  }
  for (const CLI::App* below : visible_commands(*command))
    found.add(below->get_name(), below->get_description());
  for (const CLI::Option* option : command->get_options()) {
    if (is_hidden(*option)) continue;
    if (option->get_positional()) found.add_value(*option, teams);
    for (const std::string& name : option->get_lnames())
      found.add("--" + name, option->get_description());
  }
  return found.text();
}

std::map<std::string, std::string> manual_pages(const CLI::App& app, const std::string& version) {
  std::map<std::string, std::string> pages;
  const auto add = [&](const std::string& name, const CLI::App& command, const std::string& help) {
    const std::string title = replaced(name, " ", "-");
    pages[title + ".1"] = ".TH " + title + " 1 " + page_date() + " \"mirocup " + version +
                          "\" \"User Commands\"\n.SH NAME\n" + roff(title) + " \\- " +
                          roff(command.get_description()) + "\n.SH DESCRIPTION\n.nf\n" +
                          roff(help) + ".fi\n" + exit_status;
  };
  add(app.get_name(), app, app.help());
  for (const CLI::App* command : visible_commands(app))
    add(app.get_name() + " " + command->get_name(), *command, command->help(app.get_name()));
  return pages;
}

}  // namespace mirocup::system
