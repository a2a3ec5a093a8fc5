/* SPDX-License-Identifier: MIT
 *
 * Stands in for <windows.h>: the names that teams of SimuroSot use. Nothing here does anything that
 * a match would notice, and all clocks stand still between two calls of the strategy.
 */
#ifndef MIROCUP_SIMUROSOT_WINDOWS_H
#define MIROCUP_SIMUROSOT_WINDOWS_H

#include <stddef.h>
#include <stdint.h>
#include <time.h>
#include <wchar.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef int BOOL;
typedef unsigned char BYTE;
typedef unsigned short WORD;
typedef uint32_t DWORD;
typedef int INT;
typedef unsigned int UINT;
typedef int32_t LONG;
typedef uint32_t ULONG;
typedef int64_t LONGLONG;
typedef uintptr_t WPARAM, ULONG_PTR, DWORD_PTR;
typedef intptr_t LPARAM, LRESULT;
typedef void *HANDLE, *HWND, *HINSTANCE, *HMODULE, *LPVOID, *PVOID, *HDC;
typedef char CHAR, *LPSTR, *PSTR;
typedef const char *LPCSTR, *LPCTSTR;
typedef wchar_t WCHAR, *LPWSTR;
typedef const wchar_t* LPCWSTR;
typedef double DOUBLE;
typedef float FLOAT;
#ifndef TRUE
#define TRUE 1
#define FALSE 0
#endif
#ifndef NULL
#define NULL 0
#endif
#define VOID void
#define CONST const
#define WINAPI
#define APIENTRY
#define CALLBACK
#define MAX_PATH 260
#define DLL_PROCESS_DETACH 0
#define DLL_PROCESS_ATTACH 1
#define DLL_THREAD_ATTACH 2
#define DLL_THREAD_DETACH 3
#define INVALID_HANDLE_VALUE ((HANDLE)(intptr_t)-1)
#define INFINITE 0xffffffffu
#define MB_OK 0
#define WM_COPYDATA 0x004A
#define TEXT(x) x
#define _T(x) x

typedef union {
  struct {
    DWORD LowPart;
    LONG HighPart;
  } u;
  LONGLONG QuadPart;
} LARGE_INTEGER;
typedef struct {
  WORD wYear, wMonth, wDayOfWeek, wDay, wHour, wMinute, wSecond, wMilliseconds;
} SYSTEMTIME;
typedef struct {
  ULONG_PTR dwData;
  DWORD cbData;
  PVOID lpData;
} COPYDATASTRUCT, *PCOPYDATASTRUCT;
typedef DWORD (*LPTHREAD_START_ROUTINE)(LPVOID);
typedef BOOL (*WNDENUMPROC)(HWND, LPARAM);

/* Milliseconds of simulated time: runtime.cpp. */
DWORD mirocup_simurosot_ms(void);

static inline DWORD GetTickCount(void) {
  return mirocup_simurosot_ms();
}
static inline DWORD timeGetTime(void) {
  return mirocup_simurosot_ms();
}
static inline BOOL QueryPerformanceCounter(LARGE_INTEGER* count) {
  count->QuadPart = mirocup_simurosot_ms();
  return TRUE;
}
static inline BOOL QueryPerformanceFrequency(LARGE_INTEGER* count) {
  count->QuadPart = 1000;
  return TRUE;
}
static inline void GetLocalTime(SYSTEMTIME* now) {
  SYSTEMTIME first = {2000, 1, 6, 1, 0, 0, 0, 0};
  *now = first;
  now->wMinute = (WORD)(mirocup_simurosot_ms() / 60000 % 60);
  now->wSecond = (WORD)(mirocup_simurosot_ms() / 1000 % 60);
  now->wMilliseconds = (WORD)(mirocup_simurosot_ms() % 1000);
}
static inline void GetSystemTime(SYSTEMTIME* now) {
  GetLocalTime(now);
}
static inline void Sleep(DWORD ms) {
  (void)ms;
}
static inline HANDLE CreateThread(void* a, size_t b, LPTHREAD_START_ROUTINE c, LPVOID d, DWORD e,
                                  DWORD* f) {
  (void)a, (void)b, (void)c, (void)d, (void)e, (void)f;
  return 0;
}
static inline BOOL CloseHandle(HANDLE handle) {
  (void)handle;
  return TRUE;
}
static inline DWORD GetLastError(void) {
  return 0;
}
static inline BOOL EnumWindows(WNDENUMPROC each, LPARAM value) {
  (void)each, (void)value;
  return TRUE;
}
static inline int GetWindowTextW(HWND window, LPWSTR text, int size) {
  (void)window, (void)size;
  text[0] = 0;
  return 0;
}
static inline HWND FindWindowA(LPCSTR a, LPCSTR b) {
  (void)a, (void)b;
  return 0;
}
static inline HWND FindWindowW(LPCWSTR a, LPCWSTR b) {
  (void)a, (void)b;
  return 0;
}
static inline LRESULT SendMessageA(HWND a, UINT b, WPARAM c, LPARAM d) {
  (void)a, (void)b, (void)c, (void)d;
  return 0;
}
static inline LRESULT SendMessageW(HWND a, UINT b, WPARAM c, LPARAM d) {
  (void)a, (void)b, (void)c, (void)d;
  return 0;
}
static inline int MessageBoxA(HWND a, LPCSTR b, LPCSTR c, UINT d) {
  (void)a, (void)b, (void)c, (void)d;
  return 1;
}
static inline int MessageBoxW(HWND a, LPCWSTR b, LPCWSTR c, UINT d) {
  (void)a, (void)b, (void)c, (void)d;
  return 1;
}
static inline void OutputDebugStringA(LPCSTR text) {
  (void)text;
}
static inline void OutputDebugStringW(LPCWSTR text) {
  (void)text;
}
#define FindWindow FindWindowA
#define SendMessage SendMessageA
#define MessageBox MessageBoxA
#define OutputDebugString OutputDebugStringA
#define ZeroMemory(to, size) memset((to), 0, (size))
#define wsprintf sprintf
#define wsprintfA sprintf

#ifdef __cplusplus
}
#endif

/* Macros there; functions here, because the C++ library has functions of the same names. */
#if defined(__cplusplus) && !defined(NOMINMAX)
template <class A, class B>
static inline __typeof__(*(A*)0 + *(B*)0) max(A a, B b) {
  return a > b ? a : b;
}
template <class A, class B>
static inline __typeof__(*(A*)0 + *(B*)0) min(A a, B b) {
  return a < b ? a : b;
}
#endif

#endif
