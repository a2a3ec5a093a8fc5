// SPDX-License-Identifier: MIT
#include "system/command_help.hpp"

#include "system/text.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <memory>
#include <sstream>

namespace mirocup::system {

namespace {

// "LEAGUE:{small,middle,large}" has the values of the option, "N:NUMBER in [1 - 10]" their range.
std::string bounded(const std::string& type, std::string_view open, std::string_view close) {
  const std::size_t begin = type.find(open);
  const std::size_t end = type.find(close, begin == std::string::npos ? 0 : begin);
  if (begin == std::string::npos || end == std::string::npos) return "";
  return type.substr(begin + open.size(), end - begin - open.size());
}

bool takes_value(const CLI::Option& option) {
  return option.get_items_expected_max() > 0;
}

// Returns the name of an option's value without the checks that CLI11 appends: "ADDR:PORT" for
// "ADDR:PORT", "N" for "N:INT in [1 - 10]". CLI11 puts a colon before each check, and some names
// have colons of their own.
std::string own_value_name(const std::string& type) {
  for (std::size_t at = type.find(':'); at != std::string::npos; at = type.find(':', at + 1)) {
    for (const char* check : {"{", "NUMBER in", "DIR", "SEED"}) {
      if (type.compare(at + 1, std::strlen(check), check) == 0) return type.substr(0, at);
    }
  }
  return type;
}

// What is typed after the option: "small|middle|large", "SECONDS", "[PORT]".
std::string value_text(const CLI::Option& option) {
  if (!takes_value(option)) return "";
  const std::string type = option.get_type_name();
  const std::string own = own_value_name(type);
  const std::string checks = type.substr(std::min(own.size() + 1, type.size()));
  if (checks.compare(0, 1, "{") == 0) return replaced(bounded(checks, "{", "}"), ",", "|");
  return own;
}

std::string option_text(const CLI::Option& option) {
  std::string text = option.get_description();
  std::vector<std::string> notes;
  if (const std::string range = bounded(option.get_type_name(), " in [", "]"); !range.empty())
    notes.push_back(replaced(range, " - ", " to "));
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

const CLI::App* command_named(const CLI::App& app, const std::string& name) {
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    if (command->get_name() == name) return command;
  }
  return nullptr;
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

// The positional that the next word is for, after that many others.
const CLI::Option* positional_at(const CLI::App& command, int number) {
  for (const CLI::Option* option : command.get_options()) {
    if (!option->get_positional() || is_hidden(*option)) continue;
    if (number < option->get_items_expected_max()) return option;
    number -= option->get_items_expected_max();
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

std::string page_head(const std::string& name, const std::string& description,
                      const std::string& version) {
  std::string title = replaced(name, " ", "-");
  std::string capitals = title;
  std::transform(capitals.begin(), capitals.end(), capitals.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return ".TH " + capitals + " 1 " + page_date() + " \"mirocup " + version +
         "\" \"User Commands\"\n.SH NAME\n" + roff(title) + " \\- " + roff(description) + "\n";
}

std::string page_options(const CLI::App& command) {
  std::string text;
  for (const CLI::Option* option : command.get_options()) {
    if (is_hidden(*option)) continue;
    const std::string value = option->get_positional() ? "" : value_text(*option);
    text += ".TP\n\\fB" + roff(option->get_name(option->get_positional(), true)) + "\\fR" +
            (value.empty() ? "" : " \\fI" + roff(value) + "\\fR") + "\n" +
            roff(option_text(*option)) + "\n";
  }
  return text.empty() ? "" : ".SH OPTIONS\n" + text;
}

constexpr const char* exit_status =
    ".SH EXIT STATUS\n0: done, the answer is yes. 1: done, the answer is no. 2: wrong usage or "
    "input. 3: a file or a program is not available. 4: data is damaged or of another version. 5: "
    "a fault of this computer, run it again. 130: interrupted, can be resumed.\n";

std::string footer_of(const CLI::App& command) {
  const std::string footer = command.get_footer();
  if (footer.empty()) return "";
  const std::size_t line = footer.find('\n');
  return ".SH EXAMPLES\n.nf\n" +
         roff(line == std::string::npos ? footer : footer.substr(line + 1)) + "\n.fi\n";
}

}  // namespace

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
  const CLI::Option* waits = nullptr;  // the option whose value comes next
  int positionals = 0;
  for (const std::string& word : words.first(words.size() - 1)) {
    const bool is_value = waits != nullptr;
    waits = is_value ? nullptr : option_before(*command, word);
    if (is_value || waits != nullptr || word.starts_with('-')) continue;
    if (const CLI::App* below = command_named(*command, word)) {
      command = below;
      positionals = 0;
    } else if (word != "help" || command != &app) {
      ++positionals;
    }
  }
  Candidates found(words.back());
  if (waits != nullptr) {
    found.add_value(*waits, teams);
    return found.text();
  }
  const auto commands = visible_commands(*command);
  for (const CLI::App* below : commands) found.add(below->get_name(), below->get_description());
  if (commands.empty()) {
    if (const CLI::Option* next = positional_at(*command, positionals))
      found.add_value(*next, teams);
  }
  if (words.back().starts_with('-') || commands.empty()) {
    for (const CLI::Option* option : command->get_options()) {
      if (option->get_positional() || is_hidden(*option)) continue;
      for (const std::string& name : option->get_lnames())
        found.add("--" + name, option->get_description());
    }
  }
  return found.text();
}

std::map<std::string, std::string> manual_pages(const CLI::App& app, const std::string& version) {
  std::map<std::string, std::string> pages;
  const std::string program = app.get_name();
  const std::string title = replaced(program, " ", "-");
  std::string list;
  std::string also;
  for (const CLI::App* command : visible_commands(app)) {
    const std::string name = program + " " + command->get_name();
    const std::string file = replaced(name, " ", "-");
    list += ".TP\n\\fB" + roff(name) + "\\fR\n" + roff(command->get_description()) + "\n";
    also += (also.empty() ? "" : ",\n") + std::string(".BR ") + roff(file) + " (1)";
    std::string usage;
    for (const CLI::Option* option : command->get_options()) {
      if (is_hidden(*option)) continue;
      if (option->get_positional()) usage += " \\fI" + roff(option->get_name(true, false)) + "\\fR";
    }
    pages[file + ".1"] = page_head(name, command->get_description(), version) +
                         ".SH SYNOPSIS\n\\fB" + roff(name) + "\\fR [\\fIOPTIONS\\fR]" + usage +
                         "\n" + page_options(*command) + footer_of(*command) + exit_status +
                         ".SH SEE ALSO\n.BR " + roff(title) + " (1)\n";
  }
  pages[title + ".1"] = page_head(program, app.get_description(), version) + ".SH SYNOPSIS\n\\fB" +
                        roff(program) + "\\fR \\fICOMMAND\\fR [\\fIOPTIONS\\fR]\n.SH COMMANDS\n" +
                        list + exit_status + ".SH SEE ALSO\n" + also + "\n";
  return pages;
}

}  // namespace mirocup::system
