/* SPDX-License-Identifier: MIT */
#define _ASSERT(x) ((void)0)
#define _ASSERTE(x) ((void)0)
#define _RPT0(kind, text) ((void)0)
#define _CrtSetDbgFlag(x) 0
#define _CrtDumpMemoryLeaks() 0
#define _CRTDBG_ALLOC_MEM_DF 1
#define _CRTDBG_LEAK_CHECK_DF 32
