// SPDX-License-Identifier: MIT
// One run on every path there is: its own process, a worker of the server, the frame stream, the exported files.
#include <algorithm>
#include <set>

#include "cli/program.h"
#include "equality_scenes.h"
#include "flip_bit.h"
#include "run_paths.h"
#include "service_fixture.h"

namespace slipstitch::test {
namespace {

using PathNames = std::set<std::string>;

class Equality : public ServiceTest {
 protected:
  void run_on_every_path(const json& scene) {
    write_bytes(folder_ / "scene.json", scene.dump());
    start_server();
    ASSERT_NO_FATAL_FAILURE(run_in_own_process());
    ASSERT_NO_FATAL_FAILURE(run_as_job());
    for (const std::string format : {"obj", "bcc", "vtp"}) {
      read_files("exported " + format, format, {"export", local_.path});
      read_files("fetched " + format, format, {"frames", job_, "--server", server_->address()});
    }
  }

  // Frame 0 of the bare yarns, point by point as the scene has them: the order owes nothing to the topology.
  void expect_start(const json& scene) const {
    for (const auto& [path, frames] : paths_.files) {
      ASSERT_TRUE(!frames.empty() && frames[0]) << path;
      ASSERT_EQ(frames[0]->yarns.size(), scene["yarns"].size() + 1) << path;  // the knit's comes last
      for (std::size_t yarn = 0; yarn < scene["yarns"].size(); ++yarn) {
        std::vector<double> coordinates = scene["yarns"][yarn]["points_m"], found;
        for (const auto& point : frames[0]->yarns[yarn]) found.insert(found.end(), point.begin(), point.end());
        if (frames[0]->single) std::ranges::transform(coordinates, coordinates.begin(), rounded_to_float);
        EXPECT_EQ(found, coordinates) << path;
      }
    }
  }

  void expect_every_flip_noticed() const {
    const PathNames runs{"worker", "client"}, arc_lengths{"exported vtp", "fetched vtp"};
    const PathNames doubles{"exported obj", "exported vtp", "fetched obj", "fetched vtp"};
    const PathNames floats{"exported bcc", "fetched bcc"};
    const std::size_t frame = run_.frames.size() / 2;
    const int first_arc = run_.header.topology.arc_coord(0);
    Eigen::Index farthest = 0;  // not near 0, where float32 would keep no bit
    run_.frames[frame].q.head(first_arc).cwiseAbs().maxCoeff(&farthest);
    const auto x = static_cast<std::size_t>(farthest), arc = static_cast<std::size_t>(first_arc + 1);
    expect_noticed({frame, x, 0}, {&runs, &doubles});
    expect_noticed({frame, x, kFloatBit}, {&runs, &doubles, &floats});
    expect_noticed({frame, arc, 0}, {&runs, &arc_lengths});
  }

  std::string job_;
  RunDir local_;
  ShownRun run_;  // of local_
  RunPaths paths_;

 private:
  void run_in_own_process() {
    local_.path = folder_ / "local";
    const ProgramEnd end = slipstitch({"simulate", folder_ / "scene.json", "--out", local_.path, "--threads", "1"});
    ASSERT_EQ(end.exit_code, 0) << end.err;
    const Result<ShownRun> run = logged_run(local_);
    ASSERT_TRUE(run) << run.error;
    run_ = *run;
  }

  void run_as_job() {
    const std::string server = server_->address();
    const ProgramEnd end =
        slipstitch({"submit", folder_ / "scene.json", "--wait", "--json", "--threads", "1", "--server", server});
    ASSERT_EQ(end.exit_code, 0) << end.err;
    const json job = json::parse(end.out);
    job_ = job["name"];
    EXPECT_NE(worker_of(job_).pid, server_->pid());
    const Result<ShownRun> worker = logged_run(folder_of(job_));
    ASSERT_TRUE(worker) << worker.error;
    const Result<ShownRun> client = downloaded_run(server, job_, job["state_hash"]);
    ASSERT_TRUE(client) << client.error;
    paths_.runs = {{"worker", *worker}, {"client", *client}};
  }

  void read_files(const std::string& path, const std::string& format, std::vector<std::string> command) {
    command.insert(command.end(), {"--out", folder_ / path, "--format", format});
    const ProgramEnd end = slipstitch(command);
    EXPECT_EQ(end.exit_code, 0) << end.err;
    paths_.files[path] = parsed_frames(folder_ / path, format);
  }

  // In a copy of the local run: the checksum tells; where it is renewed, these paths do, and for that frame.
  void expect_noticed(const Flip& flip, const std::vector<const PathNames*>& by) const {
    SCOPED_TRACE("bit " + std::to_string(flip.bit) + " of coordinate " + std::to_string(flip.coord));
    const TemporaryFolder copy;
    std::filesystem::copy(local_.path, copy.path(), std::filesystem::copy_options::recursive);
    const RunDir dir{copy.path()};
    const std::string log = read_bytes(local_.frames());
    write_bytes(dir.frames(), flip_bit(log, flip, Checksum::stale));
    EXPECT_NE(logged_run(dir).error.find("checksum does not match"), std::string::npos);
    EXPECT_EQ(slipstitch({"export", dir.path, "--out", copy / "obj", "--format", "obj"}).exit_code, 1);
    write_bytes(dir.frames(), flip_bit(log, flip, Checksum::renewed));
    const Result<ShownRun> changed = logged_run(dir);
    ASSERT_TRUE(changed) << changed.error;
    PathNames expected, noticed;
    for (const PathNames* names : by) expected.insert(names->begin(), names->end());
    for (const auto& [path, lines] : differences(*changed, paths_)) {
      EXPECT_TRUE(lines.front().starts_with("frame " + std::to_string(flip.frame) + ": ")) << lines.front();
      noticed.insert(path);
    }
    EXPECT_EQ(noticed, expected);
  }
};

TEST_F(Equality, OfASlidingScene) {
  const json scene = sliding_scene();
  ASSERT_NO_FATAL_FAILURE(run_on_every_path(scene));
  const Topology& topology = run_.header.topology;
  const VecX slid = (run_.frames.back().q - run_.frames.front().q).tail(topology.num_visits()).cwiseAbs();
  EXPECT_GT(slid[topology.yarn_first[1] + 1], 1e-5);                            // over the other yarn
  EXPECT_GT(slid.tail(slid.size() - topology.yarn_first[2]).maxCoeff(), 1e-5);  // in the knit
  ASSERT_EQ(topology.num_bodies, 1);
  const int ball = topology.x_coord(topology.num_nodes - 1);
  EXPECT_GT((run_.frames.back().q - run_.frames.front().q).segment<3>(ball).norm(), 1e-3);
  ASSERT_EQ(differences(run_, paths_), PathDifferences());
  expect_start(scene);
  expect_every_flip_noticed();
}

TEST_F(Equality, OfFramesAboveAMebibyte) {
  const json scene = wide_scene();
  ASSERT_NO_FATAL_FAILURE(run_on_every_path(scene));
  constexpr std::size_t kMebibyte = std::size_t{1} << 20;
  EXPECT_GT(static_cast<std::size_t>(run_.frames.back().q.size()) * sizeof(double), kMebibyte);
  EXPECT_LE(stream_all(job_).largest_message, kMebibyte);
  ASSERT_EQ(differences(run_, paths_), PathDifferences());
  expect_start(scene);
  expect_every_flip_noticed();
}

}  // namespace
}  // namespace slipstitch::test
