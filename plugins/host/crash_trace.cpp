// SPDX-License-Identifier: MIT
#include "plugins/host/crash_trace.hpp"

#include <cstring>
#include <dlfcn.h>
#include <link.h>
#include <unwind.h>

namespace mirocup::plugins {

namespace {

constexpr int max_calls = 256;  // of all libraries together

struct Walk {
  const char* path;
  CrashTrace& trace;
  int calls = 0;
};

_Unwind_Reason_Code visit(_Unwind_Context* context, void* argument) {
  auto& walk = *static_cast<Walk*>(argument);
  int is_before = 0;  // 1: the address is that of an instruction that has not run
  std::uintptr_t address = _Unwind_GetIPInfo(context, &is_before);
  if (is_before == 0) --address;
  dl_find_object object{};
  if (_dl_find_object(reinterpret_cast<void*>(address), &object) == 0 &&
      std::strcmp(object.dlfo_link_map->l_name, walk.path) == 0) {
    walk.trace.address[walk.trace.count++] = address - object.dlfo_link_map->l_addr;
  }
  const bool is_over = walk.trace.count == max_trace || ++walk.calls == max_calls;
  return is_over ? _URC_NORMAL_STOP : _URC_NO_REASON;
}

}  // namespace

void trace_calls(const char* path, CrashTrace& trace) {
  Walk walk{path, trace};
  _Unwind_Backtrace(visit, &walk);
}

}  // namespace mirocup::plugins
