typedef struct tagP { double x, y; } P, *LPP;
g(int a) { return a; }
class A
{
public:
  A::A() {}
  go(int x) { return x; }
  void A::set(double v) { d = v; }
  static const double half = 0.5;
  double d;
};
int missing_value(int a) { if (a) return 1; }
double nothing() { return; }
int narrow[3] = {1.5, 2, 3.7}; float big[] = {1e300}; unsigned char bytes[2] = {-1, 256};
void takes(char *s) {}
typedef union { struct { double x, y; }; double v[2]; } U;
int f(int n)
{
  double a, b; int c[5]; char *s = "abc";
  for (int i = 0; i < 5; i++) a += c[i];
  for (int i = 0; i < n; i++) b += a;
  takes("x");
  int sized[n];
  U u; u.x = 1;
  enum { X, Y, };
  int *p = 3; void *v = p; int *q = v; long l = p; q = malloc(4);
  const int k = 3; switch (n) { case k: { int z = 1; n = z; } break; default: ; };
  double large[200000]; large[3] = 1;
  __try { n = 1; } __except (1) { n = 2; }
  __try { n = 1; } __finally { n = 2; }
  bool flag = false; flag++;
  const char *where = __FUNCTION__; __noop;
  return n ? f(n - 1) + large[n] + q[0] + 'ab' : u.v[0] + g(2);
};
