#include "StdAfx.h"
#include <Windows.h>
#include <Process.h>
#include <conio.h>
#include <io.h>
#include <direct.h>
#include <mmsystem.h>
#include <WinBase.h>
#include <winuser.h>
#include <windef.h>
#include <shellapi.h>
#include <commctrl.h>
#include <crtdbg.h>
#include <new.h>
#include <malloc.h>
#include <memory.h>
#include <share.h>
#include <sys/timeb.h>
#include <sys\types.h>
#include <tchar.h>
#include <iostream.h>
#include <iomanip.h>
#include <fstream.h>
#include <xstring>
#pragma comment(lib, "winmm.lib")
#pragma warning(disable : 4996)
#if _MSC_VER > 1000
#pragma once
#endif

// Names of the team's own; the old header of streams brought none of them.
int count = 0, left = 1, right = 2;
double distance(double a, double b) { return a - b; }

int f()
{
  cout << setw(3) << "x" << endl;
  ofstream log("C:\\log.txt");
  log << distance(1.0, 2.0);
  struct _timeb now;
  _ftime(&now);
  if (kbhit()) getch();
  _access("x", 0);
  _tprintf(_T("x"));
  TCHAR text[10];
  _tcscpy(text, _T("x"));
  return ++count + left + right + now.millitm;
}
