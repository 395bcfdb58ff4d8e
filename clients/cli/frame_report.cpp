// SPDX-License-Identifier: MIT
#include "cli/frame_report.h"

#include <iostream>
#include <nlohmann/json.hpp>

#include "cli/screen/text.h"

namespace slipstitch {

void report_frames(const FrameFileOptions& options, int frames, bool json) {
  if (!json) {
    std::cout << count_of(frames, "frame", "frames") << " as " << options.format << " in " << options.out << std::endl;
    return;
  }
  const nlohmann::ordered_json report{{"frames", frames},
                                      {"out", options.out},
                                      {"format", options.format},
                                      {"first", options.first},
                                      {"stride", options.stride}};
  std::cout << report.dump(2) << std::endl;
}

}  // namespace slipstitch
