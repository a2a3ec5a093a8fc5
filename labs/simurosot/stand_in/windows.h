/* SPDX-License-Identifier: MIT
 *
 * Stands in for <windows.h>: the names that teams of SimuroSot use. No function here has an effect
 * on a match, and all clocks stop between two calls of the strategy.
 */
#ifndef MIROCUP_SIMUROSOT_WINDOWS_H
#define MIROCUP_SIMUROSOT_WINDOWS_H

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <time.h>
#include <wchar.h>

extern "C" {

typedef int BOOL;
typedef unsigned char BYTE, UCHAR, BOOLEAN;
typedef unsigned short WORD, USHORT;
typedef short SHORT;
typedef uint32_t DWORD, DWORD32, COLORREF;
typedef int INT;
typedef unsigned int UINT;
typedef int32_t LONG;
typedef uint32_t ULONG;
typedef int64_t LONGLONG, INT64, __time64_t;
typedef uint64_t ULONGLONG, DWORDLONG, UINT64;
typedef uintptr_t WPARAM, ULONG_PTR, DWORD_PTR;
typedef intptr_t LPARAM, LRESULT;
typedef void *HANDLE, *HWND, *HINSTANCE, *HMODULE, *LPVOID, *PVOID, *HDC, *HGDIOBJ, *HBITMAP,
    *HFONT;
typedef void *HPEN, *HBRUSH, *HICON, *HCURSOR, *HMENU, *HKEY, *HGLOBAL, *HRSRC;
typedef const void* LPCVOID;
typedef char CHAR, TCHAR, _TCHAR, *LPSTR, *PSTR, *LPTSTR, *PCHAR;
typedef const char *LPCSTR, *LPCTSTR, *PCSTR, *PCTSTR;
typedef wchar_t WCHAR, *LPWSTR, *PWSTR;
typedef const wchar_t *LPCWSTR, *PCWSTR;
typedef double DOUBLE;
typedef float FLOAT;
typedef BOOL *LPBOOL, *PBOOL;
typedef BYTE *LPBYTE, *PBYTE;
typedef WORD* LPWORD;
typedef DWORD *LPDWORD, *PDWORD;
typedef LONG *LPLONG, *PLONG, HRESULT;
typedef int (*FARPROC)(void);
#ifndef TRUE
#define TRUE 1
#endif
#ifndef FALSE
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
#define PASCAL
#define FAR
#define NEAR
#define far
#define near
#define IN
#define OUT
#define WINUSERAPI
#define DECLSPEC_NOTHROW
#define MAX_PATH 260
#define MAXINT 0x7fffffff
#define MAXLONG 0x7fffffff
#define MAXDWORD 0xffffffffu
#define DLL_PROCESS_DETACH 0
#define DLL_PROCESS_ATTACH 1
#define DLL_THREAD_ATTACH 2
#define DLL_THREAD_DETACH 3
#define INVALID_HANDLE_VALUE ((HANDLE)(intptr_t)-1)
#define INFINITE 0xffffffffu
#define WAIT_OBJECT_0 0
#define WAIT_TIMEOUT 258
#define S_OK 0
#define SUCCEEDED(x) ((x) >= 0)
#define FAILED(x) ((x) < 0)
#define MB_OK 0
#define MB_OKCANCEL 1
#define MB_YESNO 4
#define MB_ICONERROR 0x10
#define MB_ICONSTOP 0x10
#define MB_ICONQUESTION 0x20
#define MB_ICONWARNING 0x30
#define MB_ICONEXCLAMATION 0x30
#define MB_ICONINFORMATION 0x40
#define IDOK 1
#define IDCANCEL 2
#define IDYES 6
#define IDNO 7
#define GENERIC_READ 0x80000000u
#define GENERIC_WRITE 0x40000000u
#define CREATE_NEW 1
#define CREATE_ALWAYS 2
#define OPEN_EXISTING 3
#define OPEN_ALWAYS 4
#define FILE_SHARE_READ 1
#define FILE_SHARE_WRITE 2
#define FILE_ATTRIBUTE_NORMAL 0x80
#define FILE_BEGIN 0
#define FILE_CURRENT 1
#define FILE_END 2
#define THREAD_PRIORITY_NORMAL 0
#define THREAD_PRIORITY_HIGHEST 2
#define THREAD_PRIORITY_TIME_CRITICAL 15
#define NORMAL_PRIORITY_CLASS 0x20
#define HIGH_PRIORITY_CLASS 0x80
#define REALTIME_PRIORITY_CLASS 0x100
#define STD_INPUT_HANDLE ((DWORD)-10)
#define STD_OUTPUT_HANDLE ((DWORD)-11)
#define FOREGROUND_BLUE 1
#define FOREGROUND_GREEN 2
#define FOREGROUND_RED 4
#define FOREGROUND_INTENSITY 8
#define SW_HIDE 0
#define SW_SHOW 5
#define VK_ESCAPE 0x1b
#define VK_SPACE 0x20
#define VK_LEFT 0x25
#define VK_UP 0x26
#define VK_RIGHT 0x27
#define VK_DOWN 0x28
#define VK_RETURN 0x0d
#define VK_SHIFT 0x10
#define VK_CONTROL 0x11
#define SND_ASYNC 1
#define WM_USER 0x0400
#define WM_CLOSE 0x0010
#define WM_PAINT 0x000F
#define WM_TIMER 0x0113
#define RGB(r, g, b) ((COLORREF)((r) | (g) << 8 | (b) << 16))
#define LOWORD(x) ((WORD)((DWORD_PTR)(x)&0xffff))
#define HIWORD(x) ((WORD)((DWORD_PTR)(x) >> 16 & 0xffff))
#define LOBYTE(x) ((BYTE)((DWORD_PTR)(x)&0xff))
#define HIBYTE(x) ((BYTE)((DWORD_PTR)(x) >> 8 & 0xff))
#define MAKEWORD(low, high) ((WORD)((BYTE)(low) | (WORD)(BYTE)(high) << 8))
#define MAKELONG(low, high) ((LONG)((WORD)(low) | (DWORD)(WORD)(high) << 16))
#define EXCEPTION_EXECUTE_HANDLER 1
#define WM_COPYDATA 0x004A
#define TEXT(x) x
#define _T(x) x
#define _TEXT(x) x

typedef union {
  struct {
    DWORD LowPart;
    LONG HighPart;
  };
  struct {
    DWORD LowPart;
    LONG HighPart;
  } u;
  LONGLONG QuadPart;
} LARGE_INTEGER, *PLARGE_INTEGER;
typedef LARGE_INTEGER ULARGE_INTEGER;
typedef struct {
  WORD wYear, wMonth, wDayOfWeek, wDay, wHour, wMinute, wSecond, wMilliseconds;
} SYSTEMTIME, *LPSYSTEMTIME;
typedef struct {
  DWORD dwLowDateTime, dwHighDateTime;
} FILETIME;
typedef struct tagPOINT {
  LONG x, y;
} POINT, *LPPOINT, *PPOINT;
typedef struct tagSIZE {
  LONG cx, cy;
} SIZE, *LPSIZE;
typedef struct tagRECT {
  LONG left, top, right, bottom;
} RECT, *LPRECT, *PRECT;
typedef struct tagMSG {
  HWND hwnd;
  UINT message;
  WPARAM wParam;
  LPARAM lParam;
  DWORD time;
  POINT pt;
} MSG, *LPMSG;
typedef struct {
  SHORT X, Y;
} COORD;
typedef struct {
  LONG of_no_use;
} CRITICAL_SECTION, SECURITY_ATTRIBUTES, OVERLAPPED, PAINTSTRUCT, *LPCRITICAL_SECTION,
    *LPSECURITY_ATTRIBUTES, *LPOVERLAPPED;
typedef struct {
  ULONG_PTR dwData;
  DWORD cbData;
  PVOID lpData;
} COPYDATASTRUCT, *PCOPYDATASTRUCT;
typedef DWORD (*LPTHREAD_START_ROUTINE)(LPVOID);
typedef BOOL (*WNDENUMPROC)(HWND, LPARAM);

/* Returns the simulated time, ms (runtime.cpp). */
DWORD mirocup_simurosot_ms(void);

static inline DWORD GetTickCount(void) {
  return mirocup_simurosot_ms();
}
static inline DWORD timeGetTime(void) {
  return mirocup_simurosot_ms();
}
static inline BOOL QueryPerformanceCounter(LARGE_INTEGER* count) {
  count->QuadPart = mirocup_simurosot_ms();
  return 1;
}
static inline BOOL QueryPerformanceFrequency(LARGE_INTEGER* count) {
  count->QuadPart = 1000;
  return 1;
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
static inline void GetSystemTimeAsFileTime(FILETIME* now) {
  now->dwLowDateTime = mirocup_simurosot_ms() * 10000u;
  now->dwHighDateTime = 0;
}
static inline ULONGLONG GetTickCount64(void) {
  return mirocup_simurosot_ms();
}
static inline BOOL SystemTimeToFileTime(const SYSTEMTIME*, FILETIME* to) {
  GetSystemTimeAsFileTime(to);
  return 1;
}
static inline HWND FindWindowA(LPCSTR, LPCSTR) {
  return 0;
}
static inline HWND FindWindowW(LPCWSTR, LPCWSTR) {
  return 0;
}
static inline BOOL EnumWindows(WNDENUMPROC, LPARAM) {
  return 1;
}
#define GWLP_USERDATA (-21)
static inline LONG GetWindowLongW(HWND, int) {
  return 0;
}
static inline LONG GetWindowLongA(HWND, int) {
  return 0;
}
static inline DWORD GetWindowThreadProcessId(HWND, LPDWORD process) {
  if (process != NULL) *process = 0;
  return 0;
}
static inline int GetWindowTextW(HWND, LPWSTR text, int) {
  text[0] = 0;
  return 0;
}
/* Files of Windows: no file can be opened, and nothing is read. */
static inline HANDLE CreateFileA(LPCSTR, ...) {
  return INVALID_HANDLE_VALUE;
}
static inline BOOL WriteFile(HANDLE, const void*, DWORD size, DWORD* written, void*) {
  if (written != 0) *written = size;
  return 1;
}
static inline BOOL ReadFile(HANDLE, void*, DWORD, DWORD* read, void*) {
  if (read != 0) *read = 0;
  return 0;
}
static inline DWORD copy_of(LPCSTR from, LPSTR to, DWORD size) {
  if (size > 0) snprintf(to, size, "%s", from);
  return size > 0 ? (DWORD)strlen(to) : 0;
}
static inline DWORD GetModuleFileNameA(HMODULE, LPSTR to, DWORD size) {
  return copy_of("C:\\team.dll", to, size);
}
static inline DWORD GetCurrentDirectoryA(DWORD size, LPSTR to) {
  return copy_of("C:\\", to, size);
}
static inline UINT GetPrivateProfileIntA(LPCSTR, LPCSTR, INT value, LPCSTR) {
  return (UINT)value;
}
static inline DWORD GetPrivateProfileStringA(LPCSTR, LPCSTR, LPCSTR value, LPSTR to, DWORD size,
                                             LPCSTR) {
  return copy_of(value != 0 ? value : "", to, size);
}
static inline LONG InterlockedIncrement(LONG volatile* number) {
  return ++*number;
}
static inline LONG InterlockedDecrement(LONG volatile* number) {
  return --*number;
}
static inline LONG InterlockedExchange(LONG volatile* number, LONG value) {
  const LONG old = *number;
  *number = value;
  return old;
}

/* Defines a function that accepts any arguments, does nothing, and returns `value`, with which the
 * function of Windows reports success. */
#define MIROCUP_DOES_NOTHING(type, name, value) \
  static inline type name(...) {                \
    return value;                               \
  }
MIROCUP_DOES_NOTHING(void, Sleep, )
MIROCUP_DOES_NOTHING(DWORD, SleepEx, 0)
MIROCUP_DOES_NOTHING(HANDLE, CreateThread, 0)
MIROCUP_DOES_NOTHING(HANDLE, CreateEventA, 0)
MIROCUP_DOES_NOTHING(HANDLE, CreateMutexA, 0)
MIROCUP_DOES_NOTHING(HANDLE, CreateSemaphoreA, 0)
MIROCUP_DOES_NOTHING(HANDLE, CreateFileMappingA, 0)
MIROCUP_DOES_NOTHING(HANDLE, OpenFileMappingA, 0)
MIROCUP_DOES_NOTHING(LPVOID, MapViewOfFile, 0)
MIROCUP_DOES_NOTHING(BOOL, UnmapViewOfFile, TRUE)
MIROCUP_DOES_NOTHING(BOOL, CloseHandle, TRUE)
MIROCUP_DOES_NOTHING(BOOL, SetEvent, TRUE)
MIROCUP_DOES_NOTHING(BOOL, ResetEvent, TRUE)
MIROCUP_DOES_NOTHING(BOOL, ReleaseMutex, TRUE)
MIROCUP_DOES_NOTHING(BOOL, ReleaseSemaphore, TRUE)
MIROCUP_DOES_NOTHING(BOOL, TerminateThread, TRUE)
MIROCUP_DOES_NOTHING(DWORD, ResumeThread, 0)
MIROCUP_DOES_NOTHING(DWORD, SuspendThread, 0)
MIROCUP_DOES_NOTHING(void, ExitThread, )
MIROCUP_DOES_NOTHING(DWORD, WaitForSingleObject, WAIT_OBJECT_0)
MIROCUP_DOES_NOTHING(DWORD, WaitForMultipleObjects, WAIT_OBJECT_0)
MIROCUP_DOES_NOTHING(void, InitializeCriticalSection, )
MIROCUP_DOES_NOTHING(BOOL, InitializeCriticalSectionAndSpinCount, TRUE)
MIROCUP_DOES_NOTHING(BOOL, InitializeCriticalSectionEx, TRUE)
MIROCUP_DOES_NOTHING(void, EnterCriticalSection, )
MIROCUP_DOES_NOTHING(BOOL, TryEnterCriticalSection, TRUE)
MIROCUP_DOES_NOTHING(void, LeaveCriticalSection, )
MIROCUP_DOES_NOTHING(void, DeleteCriticalSection, )
MIROCUP_DOES_NOTHING(DWORD, GetCurrentThreadId, 1)
MIROCUP_DOES_NOTHING(DWORD, GetCurrentProcessId, 1)
MIROCUP_DOES_NOTHING(HANDLE, GetCurrentThread, 0)
MIROCUP_DOES_NOTHING(HANDLE, GetCurrentProcess, 0)
MIROCUP_DOES_NOTHING(BOOL, SetThreadPriority, TRUE)
MIROCUP_DOES_NOTHING(BOOL, SetPriorityClass, TRUE)
MIROCUP_DOES_NOTHING(BOOL, DisableThreadLibraryCalls, TRUE)
MIROCUP_DOES_NOTHING(UINT, timeBeginPeriod, 0)
MIROCUP_DOES_NOTHING(UINT, timeEndPeriod, 0)
MIROCUP_DOES_NOTHING(UINT, timeSetEvent, 0)
MIROCUP_DOES_NOTHING(UINT, timeKillEvent, 0)
MIROCUP_DOES_NOTHING(DWORD, GetLastError, 0)
MIROCUP_DOES_NOTHING(DWORD, GetVersion, 5)
MIROCUP_DOES_NOTHING(HMODULE, LoadLibraryA, 0)
MIROCUP_DOES_NOTHING(HMODULE, GetModuleHandleA, 0)
MIROCUP_DOES_NOTHING(FARPROC, GetProcAddress, 0)
MIROCUP_DOES_NOTHING(BOOL, FreeLibrary, TRUE)
MIROCUP_DOES_NOTHING(BOOL, SetCurrentDirectoryA, TRUE)
MIROCUP_DOES_NOTHING(BOOL, CreateDirectoryA, TRUE)
MIROCUP_DOES_NOTHING(BOOL, DeleteFileA, TRUE)
MIROCUP_DOES_NOTHING(BOOL, CopyFileA, TRUE)
MIROCUP_DOES_NOTHING(BOOL, WritePrivateProfileStringA, TRUE)
MIROCUP_DOES_NOTHING(DWORD, SetFilePointer, 0)
MIROCUP_DOES_NOTHING(DWORD, GetFileSize, 0)
MIROCUP_DOES_NOTHING(BOOL, FlushFileBuffers, TRUE)
MIROCUP_DOES_NOTHING(BOOL, Beep, TRUE)
MIROCUP_DOES_NOTHING(BOOL, MessageBeep, TRUE)
MIROCUP_DOES_NOTHING(BOOL, PlaySoundA, TRUE)
MIROCUP_DOES_NOTHING(SHORT, GetAsyncKeyState, 0)
MIROCUP_DOES_NOTHING(SHORT, GetKeyState, 0)
MIROCUP_DOES_NOTHING(BOOL, AllocConsole, TRUE)
MIROCUP_DOES_NOTHING(BOOL, FreeConsole, TRUE)
MIROCUP_DOES_NOTHING(BOOL, SetConsoleTitleA, TRUE)
MIROCUP_DOES_NOTHING(BOOL, SetConsoleCursorPosition, TRUE)
MIROCUP_DOES_NOTHING(BOOL, SetConsoleTextAttribute, TRUE)
MIROCUP_DOES_NOTHING(BOOL, WriteConsoleA, TRUE)
MIROCUP_DOES_NOTHING(HANDLE, GetStdHandle, 0)
MIROCUP_DOES_NOTHING(int, MessageBoxA, IDOK)
MIROCUP_DOES_NOTHING(int, MessageBoxW, IDOK)
MIROCUP_DOES_NOTHING(void, OutputDebugStringA, )
MIROCUP_DOES_NOTHING(void, OutputDebugStringW, )
MIROCUP_DOES_NOTHING(LRESULT, SendMessageA, 0)
MIROCUP_DOES_NOTHING(LRESULT, SendMessageW, 0)
MIROCUP_DOES_NOTHING(BOOL, PostMessageA, TRUE)
MIROCUP_DOES_NOTHING(BOOL, PostThreadMessageA, TRUE)
MIROCUP_DOES_NOTHING(HWND, GetForegroundWindow, 0)
MIROCUP_DOES_NOTHING(HWND, GetDesktopWindow, 0)
MIROCUP_DOES_NOTHING(HWND, GetConsoleWindow, 0)
MIROCUP_DOES_NOTHING(BOOL, ShowWindow, TRUE)
MIROCUP_DOES_NOTHING(BOOL, UpdateWindow, TRUE)
MIROCUP_DOES_NOTHING(BOOL, InvalidateRect, TRUE)
MIROCUP_DOES_NOTHING(HDC, GetDC, 0)
MIROCUP_DOES_NOTHING(int, ReleaseDC, 1)
MIROCUP_DOES_NOTHING(BOOL, TextOutA, TRUE)
MIROCUP_DOES_NOTHING(BOOL, MoveToEx, TRUE)
MIROCUP_DOES_NOTHING(BOOL, LineTo, TRUE)
MIROCUP_DOES_NOTHING(BOOL, Ellipse, TRUE)
MIROCUP_DOES_NOTHING(COLORREF, SetPixel, 0)
MIROCUP_DOES_NOTHING(HGDIOBJ, SelectObject, 0)
MIROCUP_DOES_NOTHING(BOOL, DeleteObject, TRUE)
MIROCUP_DOES_NOTHING(HPEN, CreatePen, 0)
MIROCUP_DOES_NOTHING(HBRUSH, CreateSolidBrush, 0)
#undef MIROCUP_DOES_NOTHING

#define CreateEvent CreateEventA
#define CreateFile CreateFileA
#define CreateMutex CreateMutexA
#define CreateSemaphore CreateSemaphoreA
#define CreateFileMapping CreateFileMappingA
#define OpenFileMapping OpenFileMappingA
#define CreateDirectory CreateDirectoryA
#define CopyFile CopyFileA
#define DeleteFile DeleteFileA
#define FindWindow FindWindowA
#define GetWindowLong GetWindowLongA
#define GetCurrentDirectory GetCurrentDirectoryA
#define SetCurrentDirectory SetCurrentDirectoryA
#define GetModuleFileName GetModuleFileNameA
#define GetModuleHandle GetModuleHandleA
#define GetPrivateProfileInt GetPrivateProfileIntA
#define GetPrivateProfileString GetPrivateProfileStringA
#define WritePrivateProfileString WritePrivateProfileStringA
#define LoadLibrary LoadLibraryA
#define MessageBox MessageBoxA
#define OutputDebugString OutputDebugStringA
#define PlaySound PlaySoundA
#define PostMessage PostMessageA
#define PostThreadMessage PostThreadMessageA
#define SendMessage SendMessageA
#define SetConsoleTitle SetConsoleTitleA
#define TextOut TextOutA
#define WriteConsole WriteConsoleA
#define ZeroMemory(to, size) memset((to), 0, (size))
#define FillMemory(to, size, value) memset((to), (value), (size))
#define CopyMemory(to, from, size) memcpy((to), (from), (size))
#define MoveMemory(to, from, size) memmove((to), (from), (size))
#define wsprintf sprintf
#define wsprintfA sprintf
#define wvsprintf vsprintf
#define lstrcpy strcpy
#define lstrcat strcat
#define lstrlen (int)strlen
#define lstrcmp strcmp
#define lstrcmpi strcasecmp
}

/* Macros on Windows, but functions here, because the C++ library has functions of these names. */
#ifndef NOMINMAX
template <class A, class B>
struct mirocup_wider {
  typedef __typeof__(*(A*)0 + *(B*)0) type;
};
#ifndef max
template <class A, class B>
static inline typename mirocup_wider<A, B>::type max(A a, B b) {
  return a > b ? a : b;
}
#endif
#ifndef min
template <class A, class B>
static inline typename mirocup_wider<A, B>::type min(A a, B b) {
  return a < b ? a : b;
}
#endif
#endif

#endif
