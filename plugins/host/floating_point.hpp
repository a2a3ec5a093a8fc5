// SPDX-License-Identifier: MIT
//
// Protects the processor's floating-point mode from foreign code.
//
// A library that was built with -Ofast switches denormal numbers off for the whole thread when it
// is loaded, and a call of foreign code can change the rounding mode. Both would change the bits of
// the simulation.
#pragma once

#include <cstdint>

namespace mirocup::plugins {

// The constructor saves the floating-point mode, and the destructor restores it.
class FloatingPointGuard {
 public:
  FloatingPointGuard() {
#if defined(__x86_64__)
    asm volatile("stmxcsr %0" : "=m"(sse_));
    asm volatile("fnstcw %0" : "=m"(x87_));
#elif defined(__aarch64__)
    asm volatile("mrs %0, fpcr" : "=r"(fpcr_));
#endif
  }

  ~FloatingPointGuard() {
#if defined(__x86_64__)
    // Foreign code can also leave numbers on the x87 stack or the direction flag set.
    asm volatile("emms\n\tcld" ::: "cc");
    asm volatile("ldmxcsr %0" : : "m"(sse_));
    asm volatile("fldcw %0" : : "m"(x87_));
#elif defined(__aarch64__)
    asm volatile("msr fpcr, %0" : : "r"(fpcr_));
#endif
  }

  FloatingPointGuard(const FloatingPointGuard&) = delete;
  FloatingPointGuard& operator=(const FloatingPointGuard&) = delete;

 private:
#if defined(__x86_64__)
  std::uint32_t sse_ = 0;
  std::uint16_t x87_ = 0;
#elif defined(__aarch64__)
  std::uint64_t fpcr_ = 0;
#endif
};

}  // namespace mirocup::plugins
