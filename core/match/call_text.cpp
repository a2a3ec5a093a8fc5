// SPDX-License-Identifier: MIT
#include "core/match/call_text.hpp"

#include <cctype>

namespace mirocup::match {

namespace {

bool is_word_letter(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0;
}

// Calls replace(word, rest) for each word of a text, and puts what it returns in place of the word.
// `rest` is the text after the word; replace() may shorten it.
template <class Replace>
std::string with_words_replaced(std::string_view text, Replace replace) {
  std::string result;
  while (!text.empty()) {
    std::size_t end = 0;
    while (end < text.size() && is_word_letter(text[end]) == is_word_letter(text[0])) ++end;
    const std::string_view part = text.substr(0, end);
    text.remove_prefix(end);
    if (is_word_letter(part[0])) {
      result += replace(part, text);
    } else {
      result += part;
    }
  }
  return result;
}

bool skip(std::string_view& text, std::string_view prefix) {
  if (text.substr(0, prefix.size()) != prefix) return false;
  text.remove_prefix(prefix.size());
  return true;
}

// "yellow robot 2" -> "chaser 2", "yellow goal" -> "chaser's goal", "yellow team" -> "chaser".
std::string with_names(std::string_view reason, const ByTeam<std::string>& names) {
  std::string text =
      with_words_replaced(reason, [&](std::string_view word, std::string_view& rest) {
        const auto team = from_string<Team>(word);
        if (!team) return std::string(word);
        const std::string& name = names[index_of(*team)];
        if (rest.substr(0, 5) == " goal") return name + "'s";
        if (!skip(rest, " robot")) skip(rest, " team");
        return name;
      });
  for (const std::string& name : names) {
    const std::size_t at = text.find("the " + name + "'s");
    if (at != std::string::npos) text.erase(at, 4);
  }
  return text;
}

// "PENALTY_KICK" -> "Penalty kick".
std::string words(std::string_view name) {
  std::string text;
  for (const char c : name) {
    const auto letter = static_cast<unsigned char>(c);
    text += c == '_' ? ' ' : static_cast<char>(text.empty() ? letter : std::tolower(letter));
  }
  return text;
}

std::string name_of(const Touch& touch, const ByTeam<std::string>& names) {
  return names[index_of(touch.team)] + " " + std::to_string(touch.robot);
}

std::string goal_title(const LoggedDecision& goal, const ByTeam<std::string>& names,
                       const ByTeam<int>& score) {
  std::string text = "Goal";
  if (goal.team) text += " for " + names[index_of(*goal.team)];
  text += ", " + std::to_string(score[0]) + " : " + std::to_string(score[1]);
  if (!goal.credit || !goal.credit->scorer) return text;
  text += goal.credit->own_goal ? " – own goal of " : " – ";
  text += name_of(*goal.credit->scorer, names);
  if (goal.credit->assist) text += ", assist " + name_of(*goal.credit->assist, names);
  if (goal.credit->kind != GoalKind::open_play) {
    std::string kind = words(to_string(goal.credit->kind));
    kind[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(kind[0])));
    text += " (" + kind + ")";
  }
  return text;
}

std::string title(const LoggedDecision& call, const ByTeam<std::string>& names,
                  const ByTeam<int>& score) {
  using referee::Verdict;
  const auto gainer = call.parties.gainer;
  const std::string name = gainer ? names[index_of(*gainer)] : "";
  switch (call.decision.verdict) {
    case Verdict::GOAL:
      return goal_title(call, names, score);
    case Verdict::MATCH_END:
      return gainer ? "Match end, " + name + " wins" : "Match end";
    case Verdict::ATTEMPT_END:
      return gainer ? "Attempt end, goal for " + name : "Attempt end, no goal";
    case Verdict::NONE:
      return "Noted";
    default:
      return words(to_string(call.decision.verdict)) + (gainer ? " for " + name : "");
  }
}

}  // namespace

std::string in_colours(std::string_view reason, Team left) {
  return with_words_replaced(reason, [left](std::string_view word, std::string_view&) {
    if (word == "left") return std::string(to_string(left));
    if (word == "right") return std::string(to_string(opponent_of(left)));
    return std::string(word);
  });
}

std::string call_text(const LoggedDecision& call, const ByTeam<std::string>& names,
                      const ByTeam<int>& score) {
  ByTeam<std::string> told_apart = names;
  if (names[0] == names[1]) told_apart = {names[0] + " (blue)", names[1] + " (yellow)"};
  std::string reason = with_names(call.decision.reason, told_apart);
  if (call.parties.offender) {
    const std::string& offender = told_apart[index_of(*call.parties.offender)];
    if (reason.find(offender) == std::string::npos) reason = offender + ": " + reason;
  }
  return title(call, told_apart, score) + " – " + reason;
}

}  // namespace mirocup::match
