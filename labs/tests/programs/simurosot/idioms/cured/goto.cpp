// goto.cpp:6: "b" gets its value here
// Cure: declare "b" without a value before the jump, and set it here.
int f(int a)
{
  if (a) goto end;
  int b = 3;
  a = b;
end:
  return a;
}
