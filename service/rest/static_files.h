// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "rest/message.h"
#include "rest/route.h"

namespace slipstitch::rest {

/// The viewer's files, read once at the start: what is asked for is looked up in a map, never on disk, so there is no
/// path to escape by.
class StaticFiles {
 public:
  /// Regular files below `folder`, no links, up to 64 MiB together. A folder that is not there leaves it empty.
  explicit StaticFiles(const std::filesystem::path& folder);

  bool empty() const { return files_.empty(); }

  /// "/" is index.html.
  Response answer(const Route& route) const;

 private:
  struct File {
    std::string bytes, etag;
  };
  void read(const std::filesystem::path& folder);

  std::map<std::string, File> files_;  // by path, with its leading slash
};

}  // namespace slipstitch::rest
