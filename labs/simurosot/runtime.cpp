// SPDX-License-Identifier: MIT
//
// Surroundings of an old team: memory that starts as zeros, files that swallow what is written, and
// clocks that show simulated time. The linker's --wrap leads the team's calls here, and only those.
//
// Old teams read memory that they have not written and seed their random numbers by the clock. With
// this their legs are the same ones whenever they are played.
#include <cerrno>
#include <cstdarg>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <new>

namespace {

double now_s = 0.0;

ssize_t swallow(void*, const char*, size_t size) {
  return static_cast<ssize_t>(size);
}

}  // namespace

// Called by the adapter before each call of the team.
void mirocup_simurosot_set_time(double seconds) {
  now_s = seconds;
}

extern "C" {

std::uint32_t mirocup_simurosot_ms() {
  return static_cast<std::uint32_t>(now_s * 1000.0);
}

void* __wrap_malloc(size_t size) {
  return std::calloc(1, size);
}

// A file to be written is one that keeps nothing; there is none to be read.
FILE* __wrap_fopen(const char*, const char* mode) {
  if (mode != nullptr && mode[0] == 'r' && mode[1] != '+') {
    errno = ENOENT;
    return nullptr;
  }
  cookie_io_functions_t functions{};
  functions.write = swallow;
  return fopencookie(nullptr, "w", functions);
}

// It would close the stream that it cannot open anew.
FILE* __wrap_freopen(const char*, const char*, FILE* stream) {
  return stream;
}

// Some close, read and write a file that they could not open: it is one at its end.
int __real_fclose(FILE* file);
int __wrap_fclose(FILE* file) {
  return file != nullptr ? __real_fclose(file) : EOF;
}

#define MIROCUP_IF_OPEN(type, name, parameters, arguments, otherwise) \
  type __real_##name parameters;                                      \
  type __wrap_##name parameters {                                     \
    return file != nullptr ? __real_##name arguments : otherwise;     \
  }
MIROCUP_IF_OPEN(int, feof, (FILE * file), (file), 1)
MIROCUP_IF_OPEN(int, ferror, (FILE * file), (file), 0)
MIROCUP_IF_OPEN(int, fflush, (FILE * file), (file), 0)
MIROCUP_IF_OPEN(int, fgetc, (FILE * file), (file), EOF)
MIROCUP_IF_OPEN(int, getc, (FILE * file), (file), EOF)
MIROCUP_IF_OPEN(char*, fgets, (char* to, int size, FILE* file), (to, size, file), nullptr)
MIROCUP_IF_OPEN(size_t, fread, (void* to, size_t size, size_t count, FILE* file),
                (to, size, count, file), 0)
MIROCUP_IF_OPEN(size_t, fwrite, (const void* from, size_t size, size_t count, FILE* file),
                (from, size, count, file), 0)
MIROCUP_IF_OPEN(int, fputc, (int c, FILE* file), (c, file), EOF)
MIROCUP_IF_OPEN(int, putc, (int c, FILE* file), (c, file), EOF)
MIROCUP_IF_OPEN(int, fputs, (const char* text, FILE* file), (text, file), EOF)
MIROCUP_IF_OPEN(int, fseek, (FILE * file, long to, int from), (file, to, from), -1)
MIROCUP_IF_OPEN(long, ftell, (FILE * file), (file), 0)
MIROCUP_IF_OPEN(int, vfprintf, (FILE * file, const char* form, va_list words), (file, form, words),
                0)

void __real_rewind(FILE* file);
void __wrap_rewind(FILE* file) {
  if (file != nullptr) __real_rewind(file);
}

int __wrap_fprintf(FILE* file, const char* form, ...) {
  va_list words;
  va_start(words, form);
  const int written = __wrap_vfprintf(file, form, words);
  va_end(words);
  return written;
}

// The C library has it by two names, for two versions of the language.
int __wrap_fscanf(FILE* file, const char* form, ...) {
  va_list words;
  va_start(words, form);
  const int count = file != nullptr ? vfscanf(file, form, words) : EOF;
  va_end(words);
  return count;
}
int __wrap___isoc99_fscanf(FILE* file, const char* form, ...) {
  va_list words;
  va_start(words, form);
  const int count = file != nullptr ? vfscanf(file, form, words) : EOF;
  va_end(words);
  return count;
}

time_t __wrap_time(time_t* result) {
  constexpr time_t year_2000 = 946684800;
  const time_t now = year_2000 + static_cast<time_t>(now_s);
  if (result != nullptr) *result = now;
  return now;
}

clock_t __wrap_clock() {
  return static_cast<clock_t>(now_s * CLOCKS_PER_SEC);
}

}  // extern "C"

void* operator new(size_t size) {
  if (void* memory = std::calloc(1, size > 0 ? size : 1)) return memory;
  std::abort();
}
void* operator new[](size_t size) {
  return operator new(size);
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete[](void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, size_t) noexcept {
  std::free(memory);
}
void operator delete[](void* memory, size_t) noexcept {
  std::free(memory);
}
