#include <windows.h>
#include <math.h>
#include <fstream.h>
