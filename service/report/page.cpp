// SPDX-License-Identifier: MIT
#include "report/page.h"

#include "report/svg.h"

namespace slipstitch {
namespace {

constexpr std::string_view kHead = R"(<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<style>
body { font: 15px/1.5 system-ui, Helvetica, Arial, sans-serif; color: #222; background: #fff; margin: 2rem auto;
       max-width: 75rem; padding: 0 1rem; }
h1 { font-size: 1.5rem; } h2 { font-size: 1.15rem; margin-top: 2rem; }
.wide { overflow-x: auto; } svg { max-width: 100%; height: auto; }
table { border-collapse: collapse; font-size: 13px; white-space: nowrap; }
th, td { padding: .25rem .6rem; text-align: right; border-bottom: 1px solid #e3e3e3; }
th:first-child, td:first-child, th:nth-child(2), td:nth-child(2) { text-align: left; }
tr.front td { background: #fdf3d0; }
td.why { white-space: normal; text-align: left; color: #666; font-style: italic; }
code { background: #f3f3f3; padding: .1rem .3rem; }
dt { font-weight: 600; margin-top: .6rem; } dd { margin: 0; max-width: 60rem; }
</style>
)";

}  // namespace

std::string page_begin(const std::string& title) {
  return std::string(kHead) + "<title>" + escaped(title) + "</title>\n</head>\n<body>\n<h1>" + escaped(title) +
         "</h1>\n";
}

std::string page_end() { return "</body>\n</html>\n"; }

}  // namespace slipstitch
