// assembler.cpp:5: this is assembler of Visual C++.
// Cure: write it in C
double f(double x)
{
  __asm { fld x }
  return x;
}
