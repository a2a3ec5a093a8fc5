// suffix.cpp:3: only Visual C++ knows such a suffix of a number.
// Cure: write LL in place of i64
__int64 a = 3i64;
