// typename.cpp:4: a type that depends on a template's argument is named without "typename".
// Cure: write "typename std::vector<T>::iterator" there.
#include <vector>
template <class T> void g(std::vector<T> &v) { std::vector<T>::iterator i = v.begin(); }
