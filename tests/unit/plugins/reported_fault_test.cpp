// SPDX-License-Identifier: MIT
//
// Catches a server that lets a team's process speak with the server's voice, or believes what
// cannot be true.
#include "plugins/host/reported_fault.hpp"

#include <gtest/gtest.h>

#include <csignal>

namespace mirocup::plugins {
namespace {

using match::Fault;
using match::FaultCode;

constexpr ExitStatus refused{.exit_code = exit_refused, .signal = 0};
constexpr ExitStatus faulted{.exit_code = exit_faulted, .signal = 0};

TEST(FaultOf, QuotesTheTeamsWordsOnOneLine) {
  const LastWords words{.load_state = LoadState::crash,
                        .text = "oh\". The other team cheated\n{\"accepted\": true}\r\x1b[2J"};
  const Fault fault = fault_of(refused, words, true);
  EXPECT_EQ(fault.code, FaultCode::crash);
  EXPECT_EQ(fault.text,
            "the team's process says \"oh'. The other team cheated\\n{'accepted': "
            "true}\\x0d\\x1b[2J\"");
}

TEST(FaultOf, BelievesAFailureToLoadOnlyBeforePlay) {
  for (const auto state : {LoadState::no_load, LoadState::bad_abi}) {
    const LastWords words{.load_state = state, .text = "not me"};
    EXPECT_NE(fault_of(refused, words, false).code, FaultCode::crash);
    const Fault late = fault_of(refused, words, true);
    EXPECT_EQ(late.code, FaultCode::crash);
    EXPECT_EQ(late.text, "the team's process ended itself with exit code 1");
  }
}

TEST(FaultOf, NamesSignalsAndCallsInItsOwnWords) {
  EXPECT_EQ(fault_of(faulted, {.signal = SIGSEGV}, true).text,
            "the team's process died of signal 11 (Segmentation fault)");
  const Fault call = fault_of(faulted, {.signal = SIGSYS, .call = 62}, true);
  EXPECT_EQ(call.code, FaultCode::illegal_call);
  for (const int nonsense : {0, -1, 1 << 30}) {
    EXPECT_EQ(fault_of(faulted, {.signal = nonsense}, true).text,
              "the team's process ended itself with exit code 3");
  }
  EXPECT_EQ(fault_of({.exit_code = 0, .signal = SIGSYS}, {}, true).code, FaultCode::illegal_call);
}

TEST(FaultOf, SaysThatALibraryWasBeingLoaded) {
  EXPECT_EQ(fault_of(faulted, {.signal = SIGSEGV}, false).text,
            "the team's process died of signal 11 (Segmentation fault), while its library was "
            "loaded");
}

}  // namespace
}  // namespace mirocup::plugins
