#define max(a, b) (((a) > (b)) ? (a) : (b))
#define min(a, b) (((a) < (b)) ? (a) : (b))
#define random(x) (rand() % x)
#define round(x) ((int)((x) + 0.5))
#define PI 3.14
#define TRUE 1
#include <vector>
#include <algorithm>
#include <string>
#include <windows.h>
using namespace std;
vector<int> all;
int f() { sort(all.begin(), all.end()); return max(1, 2) + random(3) + round(1.5); }
