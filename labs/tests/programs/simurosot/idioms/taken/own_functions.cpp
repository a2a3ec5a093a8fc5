#include <windows.h>
#include <cmath>
#include <vector>
using namespace std;
double max(double a, double b, double c) { return a > b ? a : b > c ? b : c; }
double min(double a, double b) { return a < b ? a : b; }
double f(float x, long l)
{
  int a[9] = {0};
  return max(1.0, x) + min(x, 2.0f) + max(1, 2) + max(l, 3) + a[max(1, 2u)]
         + max(1.0, 2.0, 3.0) + min(1.0, 2.0);
}
