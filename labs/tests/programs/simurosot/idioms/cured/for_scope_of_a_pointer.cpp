// for_scope_of_a_pointer.cpp:6: "p" is the variable of the loop in line 5
// Cure: write "char * p;" before line 5, and "for (p" in place of "for (char * p" there.
int f(char *a)
{
  for (char *p = a; *p; p++) ;
  return *p;
}
