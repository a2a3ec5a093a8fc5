#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
const double M_PI = 3.14159, INFINITY = 1e9;
double y1, y0 = 2, gamma = 1;
int index = 3, read = 2, write, log2 = 1, random = 1, kill, select, error, time = 0, link = 1;
int round(double x) { return (int)(x + 0.5); }
double hypot(double a, double b, double c) { return a; }
bool isinf(double x) { return false; }
double trunc(double a) { return a; }
int signal(int a) { return a; }
int bind(int a) { return a; }
struct Own { double y1; int time; int round(int a) { return a; } };
int f()
{
  int unix = 1, linux = 2, and = 3, or = 4, not = 5;
  Own own = {1, 2};
  return index + read + time + link + signal(1) + bind(2) + round(2.5) + own.round(1)
         + (int)y1 + unix +
         linux + and + or + not + own.time + (int)trunc(M_PI) + isinf(INFINITY);
}
#ifdef _y1
#error as a parameter, "y1 = _y1" would do nothing
#endif
#if !WIN32
#error
#endif
