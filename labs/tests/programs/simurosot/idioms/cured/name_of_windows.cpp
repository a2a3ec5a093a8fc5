// name_of_windows.cpp:4: "GetKeyboardState" is not declared.
// Cure: write PRELUDE in CMakeLists.txt, and a header with it
#include <windows.h>
int pressed(unsigned char* keys) { return GetKeyboardState(keys); }
