#include <windows.h>
int _stdcall f(int a);
int __stdcall f(int a) { return a; }
int WINAPI g(int a) { return a; }
int PASCAL h(int a) { return a; }
int __cdecl k(int a) { return a; }
typedef int(__stdcall *P)(int);
typedef int(CALLBACK *Q)(int);
extern "C" _declspec(dllexport) int w(int a) { return a; }
__declspec(dllimport) int imported(int);
_inline int inlined() { return 1; }
__forceinline int forced() { return 1; }
FARPROC procedure;
int FAR *far_one;
__declspec(selectany) int any = 1;
__declspec(align(16)) int aligned;
BOOL APIENTRY DllMain(HANDLE hModule, DWORD ul_reason_for_call, LPVOID lpReserved)
{
  switch (ul_reason_for_call)
  {
  case DLL_PROCESS_ATTACH: DisableThreadLibraryCalls((HMODULE)hModule); break;
  case DLL_PROCESS_DETACH: break;
  }
  return TRUE;
}
void main(int argc, char *argv[]) { }
