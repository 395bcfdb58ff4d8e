// SPDX-License-Identifier: MIT
#include "model/issue.h"

namespace slipstitch {
namespace {

constexpr std::size_t kLongestText = 200;       // of a path or a value [byte]
constexpr std::size_t kLongestExpected = 1000;  // lists the names there are [byte]

Issue all_others() {
  Issue issue{"", "", "at most " + std::to_string(kMaxIssues) + " problems; the rest is not listed"};
  issue.unlisted = true;
  return issue;
}

void shorten(std::string& text, std::size_t longest) {
  if (text.size() > longest) text = shortened(text, longest);
}

}  // namespace

std::string shortened(const std::string& text, std::size_t longest) {
  if (text.size() <= longest) return text;
  std::size_t cut = longest;
  while (cut > 0 && (static_cast<unsigned char>(text[cut]) & 0xC0) == 0x80) --cut;  // keep characters whole
  return text.substr(0, cut) + "...";
}

Issues::Issues(std::initializer_list<Issue> issues) {
  for (const Issue& issue : issues) push_back(issue);
}

void Issues::push_back(Issue issue) {
  any_too_big_ = any_too_big_ || issue.too_big;
  if (full()) return;
  if (list_.size() == kMaxIssues) issue = all_others();
  shorten(issue.path, kLongestText);
  shorten(issue.value, kLongestText);
  shorten(issue.expected, kLongestExpected);
  list_.push_back(std::move(issue));
}

}  // namespace slipstitch
