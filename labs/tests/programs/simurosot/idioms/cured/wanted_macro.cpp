// wanted_macro.cpp:4: the sources want a macro that is not set here.
// Cure: give its name to mirocup_simurosot_team in CMakeLists.txt, such as DEFINITIONS _WIN32.
#ifndef _WIN32
#error Windows only
#endif
