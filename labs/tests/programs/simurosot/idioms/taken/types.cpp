#include <windows.h>
BOOL a = TRUE; DWORD b = 0; BYTE c = 1; WORD d = 2; LONG e = 1; UINT f = 2; HANDLE g = NULL;
HWND h = 0; LPSTR i = 0; LPVOID j; COLORREF k = RGB(1, 2, 3); POINT l = {1, 2};
RECT m = {0, 0, 1, 1};
SIZE n; MSG o; HINSTANCE p; HMODULE q; HDC r; LPTSTR s; TCHAR t; UCHAR u; USHORT v; ULONGLONG w;
INT64 x; PCHAR y; HBITMAP z; HFONT aa; BOOLEAN ab; FILETIME ac; CRITICAL_SECTION ad; SHORT ae;
__int64 af = 3; unsigned __int64 ag = 3; _int64 ah; __int32 ai; __int16 aj; __int8 ak; HRESULT al;
LARGE_INTEGER am; int an = am.LowPart; SYSTEMTIME ao; COORD ap = {0, 0};
