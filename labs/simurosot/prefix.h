/* SPDX-License-Identifier: MIT
 *
 * Included before every source of an old team: names that only Microsoft's compilers know.
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

/* Included before macros below change names that these headers use. */
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
/* Microsoft's <cmath> also has the functions of <math.h> in std. */
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

/* Names that this C library has and Microsoft's lacks. A team may define them: see forward.sh. */
#if __has_include("mirocup_own_names.h")
#include "mirocup_own_names.h"
#endif

/* Macros of g++ that teams use as names of variables. */
#undef linux
#undef unix
#undef i386

/* A library that has a main function must not export it. */
#define main mirocup_simurosot_main

/* Macros that a project of Visual C++ 6 defined for a library. */
#define WIN32 1
#define _WINDOWS 1

#include "microsoft.h"

#endif
