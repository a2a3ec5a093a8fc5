// for_scope.cpp:7: "k" is the variable of the loop in line 5
// Cure: write "int k;" before line 5, and "for (k" in place of "for (int k" there.
int f(int *a)
{
  for (int k = 0; k < 5; k++)
    if (a[k]) break;
  return k;
}
