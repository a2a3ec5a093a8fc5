// SPDX-License-Identifier: MIT
//
// mirocup-plugin-host OBSERVATION_FD COMMAND_FD LIBRARY: one team in a process of its own.
//
// Loads the library and answers observations until it is killed. Started by the match server only.
#include "plugins/host/mailbox.hpp"
#include "plugins/host/plugin.hpp"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <sys/mman.h>
#include <unistd.h>

using namespace mirocup;
using namespace mirocup::plugins;

namespace {

constexpr std::chrono::hours for_ever{1};

template <class Page>
Page* map(const char* descriptor, int protection) {
  const int fd = std::atoi(descriptor);
  void* page = mmap(nullptr, sizeof(Page), protection, MAP_SHARED, fd, 0);
  close(fd);
  return page == MAP_FAILED ? nullptr : static_cast<Page*>(page);
}

LoadState state_of(match::FaultCode code) {
  switch (code) {
    case match::FaultCode::no_load:
      return LoadState::no_load;
    case match::FaultCode::bad_abi:
      return LoadState::bad_abi;
    default:
      return LoadState::crash;
  }
}

// Says why and ends: 1 tells the server that the text is there.
[[noreturn]] void refuse(CommandPage& page, const match::Fault& fault) {
  const std::size_t length = std::min(fault.text.size(), sizeof page.text - 1);
  std::memcpy(page.text, fault.text.data(), length);
  page.text[length] = '\0';
  page.load_state.store(state_of(fault.code), std::memory_order_release);
  wake(page.answer);
  _exit(1);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  const auto* in = map<const ObservationPage>(argv[1], PROT_READ);
  auto* out = map<CommandPage>(argv[2], PROT_READ | PROT_WRITE);
  if (in == nullptr || out == nullptr) return 2;

  auto plugin = Plugin::load(argv[3], in->setup);
  if (!plugin) refuse(*out, plugin.error());
  out->load_state.store(LoadState::ready, std::memory_order_release);
  wake(out->answer);

  std::uint32_t answered = 0;
  while (true) {
    std::uint32_t request = in->request.load(std::memory_order_acquire);
    while (request == answered) {
      wait_while_equal(in->request, answered, for_ever);
      request = in->request.load(std::memory_order_acquire);
    }
    const auto command = plugin->decide(in->observation);
    if (!command) refuse(*out, command.error());
    out->command = *command;
    answered = request;
    out->answer.store(request, std::memory_order_release);
    wake(out->answer);
  }
}
