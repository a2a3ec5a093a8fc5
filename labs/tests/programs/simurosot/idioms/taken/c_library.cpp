#include <stdio.h>
#include <math.h>
#include <cmath>
#include < time.h >
#include <float.h>
void f()
{
  char b[50]; char *p = b; char *rest; wchar_t w[30]; struct tm t; time_t now = 0;
  sprintf_s(b, "%d", 1); sprintf_s(b, 50, "%d", 1); sprintf_s(p, 50, "x"); strcpy_s(b, "x");
  strcpy_s(b, 50, "x"); strcat_s(b, "x"); strcat_s(b, 50, "y"); strncpy_s(b, 50, "x", 1);
  _snprintf(b, 50, "x"); _snprintf_s(b, 50, 49, "x"); _snprintf_s(b, 50, _TRUNCATE, "x");
  memcpy_s(b, 50, "x", 1); strtok_s(b, " ", &rest); _itoa_s(3, b, 50, 10); _itoa_s(3, b, 10);
  itoa(3, b, 10); _itoa(3, b, 2); ltoa(3, b, 10); ultoa(3, b, 10); _gcvt(1.5, 5, b); strupr(b);
  _strlwr(b); strrev(b); stricmp(b, "x"); strcmpi(b, "x"); strnicmp(b, "x", 1); _stricmp(b, "y");
  localtime_s(&t, &now); wcscpy_s(w, L"x"); swprintf_s(w, L"x%d", 3); _countof(b); _atoi64("3");
  double m = __max(1, 2.5) + __min(1, 2) + _chgsign(m) + _hypot(m, m); _controlfp(0, 0);
  if (_isnan(m) || !_finite(m)) m = sqrt(2) + pow(2, 3) + atan2(1, 2) + abs(-1.5);
  FILE *file = fopen("C:\\strategy\\a.txt", "w"); fprintf(file, "x"); fclose(file);
  fopen_s(&file, "x", "a+"); fscanf_s(file, "%d", &t.tm_sec); _fcloseall();
  float e = std::sqrtf(2.0f) + std::atan2f(1, 2) + std::fabsf(-1) + std::powf(2, 3); _tzset();
  long zone = _timezone + _daylight;
  freopen("out.txt", "w", stdout); clock_t ticks = clock() / CLK_TCK;
}
