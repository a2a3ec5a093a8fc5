// SPDX-License-Identifier: MIT
//
// Bounds what a stranger or a bad network can make the server say.
#pragma once

#include <functional>
#include <string>

namespace mirocup::dds {

// Sentences of one kind: after `max` of them, and a last one that says so, it is silent.
class FewWords {
 public:
  explicit FewWords(int max = 10) : left_(max) {}

  void say(const std::function<void(const std::string&)>& tell, const std::string& what) {
    if (left_ <= 0) return;
    tell(--left_ > 0 ? what : what + "; more of this kind is counted, but not told");
  }

 private:
  int left_;
};

}  // namespace mirocup::dds
