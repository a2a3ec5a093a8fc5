/* SPDX-License-Identifier: MIT */
/* The little of Microsoft's Foundation Classes that a library without windows uses. */
#ifndef MIROCUP_SIMUROSOT_AFXWIN_H
#define MIROCUP_SIMUROSOT_AFXWIN_H
#include "windows.h"

#include <string>
#include <vector>

#define ASSERT(x) ((void)0)
#define VERIFY(x) ((void)(x))
#define TRACE(...) ((void)0)
#define TRACE0(...) ((void)0)
#define TRACE1(...) ((void)0)
#define TRACE2(...) ((void)0)
#define AFX_EXT_CLASS
#define AFX_MANAGE_STATE(x)
#define DEBUG_NEW new
#define DECLARE_MESSAGE_MAP()
#define BEGIN_MESSAGE_MAP(of, base)
#define END_MESSAGE_MAP()
#define DECLARE_DYNAMIC(x)
#define IMPLEMENT_DYNAMIC(x, base)

static inline int AfxMessageBox(...) {
  return IDOK;
}

class CString {
 public:
  CString(const char* text = "") : text_(text != 0 ? text : "") {}
  CString(char c, int count = 1) : text_((size_t)count, c) {}
  operator const char*() const { return text_.c_str(); }
  int GetLength() const { return (int)text_.size(); }
  BOOL IsEmpty() const { return text_.empty(); }
  void Empty() { text_.clear(); }
  char GetAt(int i) const { return text_[(size_t)i]; }
  void SetAt(int i, char c) { text_[(size_t)i] = c; }
  char* GetBuffer(int size = 0) {
    text_.resize((size_t)size > text_.size() ? (size_t)size : text_.size());
    return &text_[0];
  }
  void ReleaseBuffer(int = -1) { text_.resize(strlen(text_.c_str())); }
  void Format(const char* format, ...) {
    char text[4096];
    va_list words;
    va_start(words, format);
    vsnprintf(text, sizeof text, format, words);
    va_end(words);
    text_ = text;
  }
  CString Left(int count) const { return text_.substr(0, (size_t)count).c_str(); }
  CString Right(int count) const { return text_.substr(text_.size() - (size_t)count).c_str(); }
  CString Mid(int first) const { return text_.substr((size_t)first).c_str(); }
  CString Mid(int first, int count) const {
    return text_.substr((size_t)first, (size_t)count).c_str();
  }
  int Find(const char* part) const { return (int)text_.find(part); }
  int Find(char part) const { return (int)text_.find(part); }
  int Compare(const char* other) const { return strcmp(text_.c_str(), other); }
  int CompareNoCase(const char* other) const { return strcasecmp(text_.c_str(), other); }
  void MakeUpper() { _strupr(&text_[0]); }
  void MakeLower() { _strlwr(&text_[0]); }
  CString& operator+=(const CString& other) {
    text_ += other.text_;
    return *this;
  }
  CString& operator+=(const char* other) {
    text_ += other;
    return *this;
  }
  CString& operator+=(char c) {
    text_ += c;
    return *this;
  }
  friend CString operator+(CString a, const CString& b) { return a += b; }
  friend CString operator+(CString a, const char* b) { return a += b; }
  friend CString operator+(CString a, char b) { return a += b; }
  friend CString operator+(const char* a, const CString& b) { return CString(a) += b; }
  friend bool operator==(const CString& a, const CString& b) { return a.text_ == b.text_; }
  friend bool operator==(const CString& a, const char* b) { return a.text_ == b; }
  friend bool operator!=(const CString& a, const CString& b) { return a.text_ != b.text_; }
  friend bool operator!=(const CString& a, const char* b) { return a.text_ != b; }

 private:
  std::string text_;
};

class CPoint : public tagPOINT {
 public:
  CPoint(int a = 0, int b = 0) { x = a, y = b; }
};
class CSize : public tagSIZE {
 public:
  CSize(int a = 0, int b = 0) { cx = a, cy = b; }
};
class CRect : public tagRECT {
 public:
  CRect(int l = 0, int t = 0, int r = 0, int b = 0) { left = l, top = t, right = r, bottom = b; }
  int Width() const { return right - left; }
  int Height() const { return bottom - top; }
};

template <class T, class Argument = const T&>
class CArray {
 public:
  int GetSize() const { return (int)all_.size(); }
  void SetSize(int size) { all_.resize((size_t)size); }
  int Add(Argument one) {
    all_.push_back(one);
    return GetSize() - 1;
  }
  T& GetAt(int i) { return all_[(size_t)i]; }
  void RemoveAll() { all_.clear(); }
  T& operator[](int i) { return all_[(size_t)i]; }

 private:
  std::vector<T> all_;
};

class CObject {
 public:
  virtual ~CObject() {}
};
/* The application object of a library, which is never started here. */
class CWinApp : public CObject {
 public:
  virtual BOOL InitInstance() { return TRUE; }
  virtual int ExitInstance() { return 0; }
};
#endif
