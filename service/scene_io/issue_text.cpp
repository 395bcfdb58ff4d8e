// SPDX-License-Identifier: MIT
#include "scene_io/issue_text.h"

namespace slipstitch {

std::string describe(const Issue& issue) {
  std::string text;
  if (!issue.value.empty()) text = "is " + issue.value + ", ";
  text += "expected " + issue.expected;
  if (issue.line > 0) {
    text += " (line " + std::to_string(issue.line);
    if (issue.column > 0) text += ", column " + std::to_string(issue.column);
    text += ")";
  }
  return text;
}

std::string issue_line(const Issue& issue) {
  return issue.path.empty() ? describe(issue) : issue.path + ": " + describe(issue);
}

std::string issue_lines(const Issues& issues) {
  std::string text;
  for (const Issue& issue : issues) text += issue_line(issue) + "\n";
  return text;
}

}  // namespace slipstitch
