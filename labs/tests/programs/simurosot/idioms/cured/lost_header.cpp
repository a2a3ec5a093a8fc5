// lost_header.cpp:3: there is no Lost.h, neither beside the sources nor for it in mirocup.
// Cure: copy it to the sources
#include "Lost.h"
