/* SPDX-License-Identifier: MIT
 *
 * Included before every source of an old team: what Microsoft's compilers know and others do not.
 */
#ifndef MIROCUP_SIMUROSOT_PREFIX_H
#define MIROCUP_SIMUROSOT_PREFIX_H

/* Keywords. */
#define __declspec(x)
#define _declspec(x)
#define __cdecl
#define __stdcall
#define __fastcall
#define __thiscall
#define _cdecl
#define _stdcall
#define _fastcall
#define __int64 long long
#define _int64 long long
#define __int32 int
#define __int16 short
#define __int8 char
#define __forceinline inline
#define _inline inline
#define __unaligned
#define __noop ((void)0)
#define __debugbreak() ((void)0)
#define __assume(x) ((void)0)
#define __FUNCSIG__ __PRETTY_FUNCTION__
#define __try try
/* clang-format off */
#define __except(x) catch (...)
/* clang-format on */
#define __finally \
  catch (...) {   \
  }
#define _CRT_SECURE_NO_WARNINGS

#include <assert.h>
#include <ctype.h>
#include <errno.h>
#include <float.h>
#include <limits.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <time.h>
#include <wchar.h>

/* Read before names of theirs mean others. */
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
/* Microsoft's <cmath> has the functions of <math.h> in std, too. */
namespace std {
using ::acosf;
using ::asinf;
using ::atan2f;
using ::atanf;
using ::ceilf;
using ::cosf;
using ::expf;
using ::fabsf;
using ::floorf;
using ::fmodf;
using ::hypotf;
using ::log10f;
using ::logf;
using ::powf;
using ::sinf;
using ::sqrtf;
using ::tanf;
}  // namespace std
#ifndef M_PI
#define M_PI 3.14159265358979323846
#endif

/* Names of the team's own that the C library here has and Microsoft's has not: forward.sh. */
#if __has_include("mirocup_own_names.h")
#include "mirocup_own_names.h"
#endif

/* g++ defines them, and they are good names for variables. */
#undef linux
#undef unix
#undef i386

/* Only a program has a main function; a library that has one keeps it for itself. */
#define main mirocup_simurosot_main

/* What a project of Visual C++ 6 for a library defined. */
#define WIN32 1
#define _WINDOWS 1

#include "microsoft.h"

#endif
