// newer.cpp:4: the sources are in a newer C++.
// Cure: write STANDARD gnu++17 in CMakeLists.txt.
enum E { A, B };
int f() { E e = E::A; return e; }
