// no_type.cpp:3: "count" has no type
// Cure: write "int count" there.
static count = 0;
int f() { return 0; }
