// value_to_a_reference.cpp:6: a value that nothing else holds is given to "V&"
// Cure: write "const V&" in place of "V&" there, and where that function is declared
struct V { double x; };
V made() { V v; return v; }

double g(V &v) { return v.x; }
double f() { return g(made()); }
