#include "stdafx.h"
#include <afxwin.h>
#include <afxext.h>
#include <afxtempl.h>
#include <atlstr.h>
#ifdef _DEBUG
#define new DEBUG_NEW
#endif

class CTeamApp : public CWinApp
{
public:
  CTeamApp();
  virtual BOOL InitInstance();
  DECLARE_MESSAGE_MAP()
};
BEGIN_MESSAGE_MAP(CTeamApp, CWinApp)
  //{{AFX_MSG_MAP(CTeamApp)
  //}}AFX_MSG_MAP
END_MESSAGE_MAP()
CTeamApp::CTeamApp() {}
BOOL CTeamApp::InitInstance() { return TRUE; }
CTeamApp theApp;

int f()
{
  CString text;
  text.Format("%d,%f", 3, 2.0);
  text += "x";
  CString longer = text + "abc";
  if (longer.IsEmpty()) longer = "y";
  AfxMessageBox(longer);
  TRACE("x %d\n", 3);
  ASSERT(1);
  const char *p = text;
  CPoint point(1, 2);
  CRect all(0, 0, 1, 1);
  CArray<int, int> numbers;
  numbers.Add(point.x);
  return p[0] + longer.GetLength() + all.Width() + numbers[0];
}
