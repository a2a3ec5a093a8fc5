#include <windows.h>
#include <process.h>
CRITICAL_SECTION section;
DWORD WINAPI run(LPVOID p) { return 0; }
void run_too(void *p) { _endthread(); }
void f()
{
  InitializeCriticalSection(&section); EnterCriticalSection(&section);
  if (TryEnterCriticalSection(&section)) LeaveCriticalSection(&section);
  InitializeCriticalSectionAndSpinCount(&section, 1); LeaveCriticalSection(&section);
  DWORD id;
  HANDLE thread = CreateThread(NULL, 0, (LPTHREAD_START_ROUTINE)run, NULL, 0, &id);
  _beginthread(run_too, 0, NULL);
  WaitForSingleObject(thread, INFINITE); TerminateThread(thread, 0); CloseHandle(thread);
  HANDLE event = CreateEvent(NULL, FALSE, FALSE, NULL); SetEvent(event); ResetEvent(event);
  HANDLE mutex = CreateMutex(0, 0, "x"); ReleaseMutex(mutex);
  Beep(1, 2); MessageBox(NULL, "a", "b", MB_OK | MB_ICONERROR); OutputDebugString("x");
  char text[100];
  wsprintf(text, "%d", 3); lstrcpy(text, "x"); lstrcat(text, "y"); int n = lstrlen(text);
  GetModuleFileName(NULL, text, 100); GetCurrentDirectory(100, text); ZeroMemory(text, 3);
  CopyMemory(text, "x", 2); FillMemory(text, 3, 0);
  SYSTEMTIME now; GetLocalTime(&now);
  FILETIME t; GetSystemTimeAsFileTime(&t); LARGE_INTEGER count; QueryPerformanceFrequency(&count);
  QueryPerformanceCounter(&count); double s = (double)count.QuadPart + count.LowPart;
  srand(GetTickCount() + timeGetTime()); Sleep(1);
  HMODULE library = LoadLibrary("a.dll"); FARPROC p = GetProcAddress(library, "x");
  FreeLibrary(library);
  int value = GetPrivateProfileInt("a", "b", 1, "c.ini");
  GetPrivateProfileString("a", "b", "d", text, 100, ".\\c.ini");
  HANDLE file = CreateFile("C:\\x", GENERIC_WRITE, 0, NULL, CREATE_ALWAYS,
                           FILE_ATTRIBUTE_NORMAL, NULL);
  DWORD written; WriteFile(file, text, 3, &written, NULL); ReadFile(file, text, 3, &written, NULL);
  if (GetAsyncKeyState(VK_SPACE)) AllocConsole();
  SetThreadPriority(GetCurrentThread(), THREAD_PRIORITY_HIGHEST);
  SetConsoleTextAttribute(GetStdHandle(STD_OUTPUT_HANDLE), FOREGROUND_RED | FOREGROUND_INTENSITY);
  HDC screen = GetDC(NULL); TextOut(screen, 0, 0, "x", 1); SetPixel(screen, 0, 0, RGB(1, 2, 3));
  DWORD process; GetWindowThreadProcessId(0, &process); GetWindowLongW(0, GWLP_USERDATA);
  PostMessage(0, WM_USER, 0, 0); HWND other = FindWindow(0, "x"); MAKEWORD(1, 2); LOWORD(3);
}
