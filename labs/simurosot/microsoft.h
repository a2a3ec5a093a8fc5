/* SPDX-License-Identifier: MIT
 *
 * Functions of the C library, under the names that Microsoft's C library gives them.
 */
#ifndef MIROCUP_SIMUROSOT_MICROSOFT_H
#define MIROCUP_SIMUROSOT_MICROSOFT_H

#define _isnan(x) __builtin_isnan(x)
#define _finite(x) __builtin_isfinite(x)
#define _hypot hypot
#define _copysign copysign
#define _chgsign(x) (-(x))
#define _logb logb
#define _controlfp(a, b) 0u
#define _control87(a, b) 0u
#define _clearfp() 0u
#define _clear87() 0u
#define _HUGE HUGE_VAL
#define _MAX_PATH 260
#define _TRUNCATE ((size_t)-1)
#define _countof(x) (sizeof(x) / sizeof((x)[0]))
#define __max(a, b) (((a) > (b)) ? (a) : (b))
#define __min(a, b) (((a) < (b)) ? (a) : (b))

#define _snprintf snprintf
#define _vsnprintf vsnprintf
#define _fcloseall() 0
#define _fileno fileno
#define _stricmp strcasecmp
#define stricmp strcasecmp
#define _strcmpi strcasecmp
#define strcmpi strcasecmp
#define _strnicmp strncasecmp
#define strnicmp strncasecmp
#define _strdup strdup
#define strtok_s strtok_r
#define scanf_s scanf
#define sscanf_s sscanf
#define fscanf_s fscanf
#define fprintf_s fprintf
#define printf_s printf
#define vprintf_s vprintf
#define _atoi64 atoll
#define localtime_s(out, in) localtime_r((in), (out))
#define gmtime_s(out, in) gmtime_r((in), (out))
#define ctime_s(out, size, in) ctime_r((in), (out))
#define asctime_s(out, size, in) asctime_r((in), (out))
#define CLK_TCK CLOCKS_PER_SEC
#define _tzset tzset
#define _timezone __timezone
#define _daylight __daylight

static inline int fopen_s(FILE** file, const char* name, const char* mode) {
  *file = fopen(name, mode);
  return *file != 0 ? 0 : errno;
}
static inline FILE* _wfopen(const wchar_t*, const wchar_t* mode) {
  return fopen("", mode[0] == 'r' && mode[1] != '+' ? "r" : "w");
}
static inline int freopen_s(FILE** file, const char*, const char*, FILE* old) {
  *file = old;
  return 0;
}

static inline int vsprintf_s(char* to, size_t size, const char* format, va_list words) {
  return vsnprintf(to, size, format, words);
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
static inline int _snprintf_s(char* to, size_t size, size_t, const char* format, ...) {
  va_list words;
  va_start(words, format);
  const int written = vsnprintf(to, size, format, words);
  va_end(words);
  return written;
}
template <size_t size>
static inline int _snprintf_s(char (&to)[size], size_t, const char* format, ...) {
  va_list words;
  va_start(words, format);
  const int written = vsnprintf(to, size, format, words);
  va_end(words);
  return written;
}
static inline int swprintf_s(wchar_t* to, size_t size, const wchar_t* format, ...) {
  va_list words;
  va_start(words, format);
  const int written = vswprintf(to, size, format, words);
  va_end(words);
  return written;
}
template <size_t size>
static inline int swprintf_s(wchar_t (&to)[size], const wchar_t* format, ...) {
  va_list words;
  va_start(words, format);
  const int written = vswprintf(to, size, format, words);
  va_end(words);
  return written;
}

static inline int strcpy_s(char* to, size_t size, const char* from) {
  snprintf(to, size, "%s", from);
  return 0;
}
template <size_t size>
static inline int strcpy_s(char (&to)[size], const char* from) {
  return strcpy_s(to, size, from);
}
static inline int strncpy_s(char* to, size_t size, const char* from, size_t count) {
  const size_t most = count < size ? count : size - 1;
  snprintf(to, size, "%.*s", (int)most, from);
  return 0;
}
template <size_t size>
static inline int strncpy_s(char (&to)[size], const char* from, size_t count) {
  return strncpy_s(to, size, from, count);
}
static inline int strcat_s(char* to, size_t size, const char* from) {
  const size_t used = strnlen(to, size);
  if (used < size) snprintf(to + used, size - used, "%s", from);
  return 0;
}
template <size_t size>
static inline int strcat_s(char (&to)[size], const char* from) {
  return strcat_s(to, size, from);
}
static inline int memcpy_s(void* to, size_t size, const void* from, size_t count) {
  memcpy(to, from, count < size ? count : size);
  return 0;
}
static inline int wcscpy_s(wchar_t* to, size_t size, const wchar_t* from) {
  if (size == 0) return 0;
  wcsncpy(to, from, size - 1);
  to[size - 1] = 0;
  return 0;
}
template <size_t size>
static inline int wcscpy_s(wchar_t (&to)[size], const wchar_t* from) {
  return wcscpy_s(to, size, from);
}
static inline int wcscat_s(wchar_t* to, size_t size, const wchar_t* from) {
  const size_t used = wcsnlen(to, size);
  return used < size ? wcscpy_s(to + used, size - used, from) : 0;
}
static inline char* gets_s(char* to, size_t) {
  to[0] = 0;
  return 0;
}

static inline char* _strupr(char* text) {
  for (char* at = text; *at != 0; ++at) *at = (char)toupper((unsigned char)*at);
  return text;
}
static inline char* _strlwr(char* text) {
  for (char* at = text; *at != 0; ++at) *at = (char)tolower((unsigned char)*at);
  return text;
}
static inline char* _strrev(char* text) {
  for (size_t i = 0, k = strlen(text); i + 1 < k; ++i) {
    const char first = text[i];
    text[i] = text[--k];
    text[k] = first;
  }
  return text;
}
#define strupr _strupr
#define strlwr _strlwr
#define strrev _strrev

/* Write the digits of `value` in a base from 2 to 36. */
static inline char* _ui64toa(unsigned long long value, char* to, int base) {
  char* at = to;
  do {
    const int digit = (int)(value % base);
    *at++ = (char)(digit < 10 ? '0' + digit : 'a' + digit - 10);
    value /= base;
  } while (value != 0);
  *at = 0;
  _strrev(to);
  return to;
}
static inline char* _i64toa(long long value, char* to, int base) {
  if (value >= 0 || base != 10) return _ui64toa((unsigned long long)value, to, base);
  to[0] = '-';
  _ui64toa(-(unsigned long long)value, to + 1, base);
  return to;
}
static inline char* _itoa(int value, char* to, int base) {
  return base == 10 ? _i64toa(value, to, base) : _ui64toa((unsigned int)value, to, base);
}
static inline int _itoa_s(int value, char* to, size_t, int base) {
  _itoa(value, to, base);
  return 0;
}
template <size_t size>
static inline int _itoa_s(int value, char (&to)[size], int base) {
  return _itoa_s(value, to, size, base);
}
#define itoa _itoa
#define _ltoa _itoa
#define ltoa _itoa
#define _ultoa _ui64toa
#define ultoa _ui64toa
#define _gcvt(value, digits, to) gcvt((value), (digits), (to))

#endif
