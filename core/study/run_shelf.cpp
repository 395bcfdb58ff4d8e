// SPDX-License-Identifier: MIT
#include "study/run_shelf.h"

#include <map>

namespace slipstitch {
namespace {

class MemoryShelf final : public RunShelf {
 public:
  std::optional<KeptRun> find(const std::string& key) override {
    const auto found = runs_.find(key);
    return found != runs_.end() ? std::optional<KeptRun>(found->second) : std::nullopt;
  }
  std::string keep(const std::string& key, const KeptRun& run) override {
    runs_[key] = run;
    return {};
  }

 private:
  std::map<std::string, KeptRun> runs_;
};

}  // namespace

std::unique_ptr<RunShelf> make_memory_shelf() { return std::make_unique<MemoryShelf>(); }

}  // namespace slipstitch
