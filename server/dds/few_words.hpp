// SPDX-License-Identifier: MIT
//
// Limits the number of sentences that a stranger or a bad network can make the server print.
#pragma once

#include <functional>
#include <string>

namespace mirocup::dds {

// Prints at most `max` sentences of one kind. The last sentence says that no more follow.
class FewWords {
 public:
  explicit FewWords(int max = 10) : left_(max) {}

  void say(const std::function<void(const std::string&)>& tell, const std::string& what) {
    if (left_ <= 0) return;
    tell(--left_ > 0 ? what
                     : what + "; further messages of this kind are counted, but not printed");
  }

 private:
  int left_;
};

}  // namespace mirocup::dds
