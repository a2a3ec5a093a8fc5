/* SPDX-License-Identifier: MIT
 *
 * Included before every source of an old team: what Microsoft's compilers know and others do not.
 */
#ifndef MIROCUP_SIMUROSOT_PREFIX_H
#define MIROCUP_SIMUROSOT_PREFIX_H

#define __declspec(x)
#define __cdecl
#define __stdcall
#define __fastcall
#define _cdecl
#define _stdcall
#define __int64 long long
#define __forceinline inline
#define _CRT_SECURE_NO_WARNINGS

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#ifndef M_PI
#define M_PI 3.14159265358979323846
#endif

#define _isnan(x) __builtin_isnan(x)
#define _finite(x) __builtin_isfinite(x)
#define _hypot hypot
#define _copysign copysign
#define _snprintf snprintf
#define _stricmp strcasecmp
#define stricmp strcasecmp
#define _strdup strdup
#define scanf_s scanf
#define sscanf_s sscanf
#define fscanf_s fscanf
#define fprintf_s fprintf
#define printf_s printf
#define localtime_s(out, in) localtime_r((in), (out))

#ifdef __cplusplus
#include <stdarg.h>
#include <strings.h>
static inline int fopen_s(FILE** file, const char* name, const char* mode) {
  *file = fopen(name, mode);
  return *file != 0 ? 0 : errno;
}
static inline int sprintf_s(char* to, size_t size, const char* format, ...) {
  va_list words;
  va_start(words, format);
  const int written = vsnprintf(to, size, format, words);
  va_end(words);
  return written;
}
template <size_t size>
static inline int sprintf_s(char (&to)[size], const char* format, ...) {
  va_list words;
  va_start(words, format);
  const int written = vsnprintf(to, size, format, words);
  va_end(words);
  return written;
}
static inline int strcpy_s(char* to, size_t size, const char* from) {
  snprintf(to, size, "%s", from);
  return 0;
}
template <size_t size>
static inline int strcpy_s(char (&to)[size], const char* from) {
  snprintf(to, size, "%s", from);
  return 0;
}
#endif

#endif
