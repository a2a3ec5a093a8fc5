// name_of_windows.cpp:4: "GetKeyboardState" is not declared.
// Cure: give after PRELUDE in CMakeLists.txt the team's header that declares it
#include <windows.h>
int pressed(unsigned char* keys) { return GetKeyboardState(keys); }
int released(unsigned char* keys) { return !GetKeyboardState(keys); }
