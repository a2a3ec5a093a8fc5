/* SPDX-License-Identifier: MIT */
/* Functions for folders and files: here every folder and file is missing. */
#ifndef MIROCUP_SIMUROSOT_IO_H
#define MIROCUP_SIMUROSOT_IO_H
struct _finddata_t {
  unsigned attrib, size;
  char name[260];
};
static inline long _findfirst(const char*, _finddata_t*) {
  return -1;
}
static inline int _findnext(long, _finddata_t*) {
  return -1;
}
static inline int _findclose(long) {
  return -1;
}
static inline int _access(const char*, int) {
  return -1;
}
static inline int _unlink(const char*) {
  return -1;
}
static inline int _mkdir(const char*) {
  return -1;
}
static inline int _chdir(const char*) {
  return -1;
}
static inline char* _getcwd(char* to, int size) {
  snprintf(to, (size_t)size, "C:\\");
  return to;
}
#endif
