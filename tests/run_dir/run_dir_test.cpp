// SPDX-License-Identifier: MIT
#include "run_dir/run_dir.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <thread>

#include "run_dir/atomic_file.h"
#include "run_dir/control_log.h"
#include "support/sample_run.h"

namespace slipstitch::test {
namespace {

namespace fs = std::filesystem;

const JobInfo kJob{"simJobs/a", "r", "h", 3, "SkylakeX", "2024-05-01T00:00:00.000001Z", "drape"};

TEST(RunDir, CreatedRunsCanBeOpened) {
  const TemporaryFolder folder;
  const Result<RunDir> made = create_run_dir(folder / "a/b", kJob, "{\"name\":\"x\"}", false);
  ASSERT_TRUE(made) << made.error;
  const Result<RunDir> opened = open_run_dir(folder / "a/b/");
  ASSERT_TRUE(opened) << opened.error;
  EXPECT_EQ(to_json(*read_job(*opened)), to_json(kJob));
  EXPECT_EQ(*read_scene(*opened), "{\"name\":\"x\"}");
  EXPECT_FALSE(has_summary(*opened));
  EXPECT_FALSE(read_progress(*opened));
  EXPECT_FALSE(open_run_dir(folder / "a"));
}

TEST(RunDir, OccupiedFoldersNeedForceAndKeepForeignFiles) {
  const TemporaryFolder folder;
  const auto path = folder / "run";
  fs::create_directories(path);
  EXPECT_FALSE(occupied(path));
  ASSERT_TRUE(create_run_dir(path, kJob, "old", false));
  write_bytes(path / "mine.txt", "keep");
  write_bytes(path / "summary.json", "old");
  write_bytes(path / "frames.log", "old");
  write_bytes(path / "report/table.csv", "old");
  EXPECT_FALSE(create_run_dir(path, kJob, "new", false));
  EXPECT_EQ(read_bytes(path / "scene.json"), "old");
  const Result<RunDir> again = create_run_dir(path, kJob, "new", true);
  ASSERT_TRUE(again) << again.error;
  EXPECT_EQ(read_bytes(path / "scene.json"), "new");
  EXPECT_EQ(read_bytes(path / "mine.txt"), "keep");
  EXPECT_FALSE(has_summary(*again));
  EXPECT_FALSE(fs::exists(again->frames()));
  EXPECT_TRUE(list_artefacts(*again).empty());
  write_bytes(folder / "file", "");
  EXPECT_FALSE(create_run_dir(folder / "file", kJob, "", false));
  EXPECT_FALSE(create_run_dir(folder / "file", kJob, "", true));
}

TEST(RunDir, ReadersSeeTheOldOrTheNewFile) {
  const TemporaryFolder folder;
  const auto path = folder / "x.json";
  const std::string one(100'000, '1'), two(50'000, '2');
  ASSERT_EQ(write_file_atomic(path, one), "");
  std::atomic<bool> done = false;
  std::thread writer([&] {
    for (int round = 0; round < 100; ++round) EXPECT_EQ(write_file_atomic(path, round % 2 == 0 ? two : one), "");
    done = true;
  });
  int reads = 0;
  while (!done) {
    const Result<std::string> text = read_file(path, 1 << 20);
    EXPECT_TRUE(text && (*text == one || *text == two)) << text.error;
    ++reads;
  }
  writer.join();
  EXPECT_GT(reads, 0);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 1);  // no temporary file is left
}

TEST(RunDir, AKilledWriterLeavesTheOldOrTheNewFile) {
  const TemporaryFolder folder;
  const auto path = folder / "x.json";
  const std::string one(300'000, '1'), two(200'000, '2');
  for (int round = 0; round < 20; ++round) {
    ASSERT_EQ(write_file_atomic(path, one), "");
    const pid_t child = ::fork();
    if (child == 0) {
      while (true) {
        if (!write_file_atomic(path, two).empty()) ::_exit(1);
        if (!write_file_atomic(path, one).empty()) ::_exit(1);
      }
    }
    ::usleep(static_cast<useconds_t>(500 * round));
    ::kill(child, SIGKILL);
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_TRUE(WIFSIGNALED(status));
    const std::string text = read_bytes(path);
    EXPECT_TRUE(text == one || text == two) << text.size();
  }
}

TEST(RunDir, FailedWritesKeepTheOldFile) {
  const TemporaryFolder folder;
  EXPECT_NE(write_file_atomic(folder / "none/x.json", "new"), "");
  fs::create_directories(folder / "taken/inside");
  EXPECT_NE(write_file_atomic(folder / "taken", "new"), "");
  EXPECT_TRUE(fs::is_directory(folder / "taken/inside"));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 1);
}

TEST(RunDir, LargeFilesAreRefusedBeforeReading) {
  const TemporaryFolder folder;
  write_bytes(folder / "x", std::string(11, 'x'));
  EXPECT_TRUE(read_file(folder / "x", 11));
  EXPECT_FALSE(read_file(folder / "x", 10));
  EXPECT_FALSE(read_file(folder.path(), 10));
}

TEST(RunDir, CommandsArriveOnceAndWhole) {
  const TemporaryFolder folder;
  const RunDir dir{folder.path()};
  ControlLogReader reader(dir.control());
  EXPECT_TRUE(reader.poll().empty());
  ASSERT_EQ(request_cancel(dir), "");
  ASSERT_EQ(append_command(dir.control(), "later"), "");
  EXPECT_EQ(reader.poll(), (std::vector<std::string>{"cancel", "later"}));
  EXPECT_TRUE(reader.poll().empty());
  write_bytes(dir.control(), "cancel\nlater\ncan");
  EXPECT_TRUE(reader.poll().empty());
  write_bytes(dir.control(), "cancel\nlater\ncancel\n");
  EXPECT_EQ(reader.poll(), (std::vector<std::string>{"cancel"}));
}

TEST(RunDir, ArtefactsAreNamedFilesInReport) {
  const TemporaryFolder folder;
  const RunDir dir{folder.path()};
  fs::create_directories(dir.report() / "folder");
  write_bytes(dir.report() / "b.csv", "1");
  write_bytes(dir.report() / "a.png", "2");
  write_bytes(dir.report() / ".hidden", "3");
  fs::create_symlink("/etc/passwd", dir.report() / "link");
  EXPECT_EQ(list_artefacts(dir), (std::vector<std::string>{"a.png", "b.csv"}));
  for (const char* name : {"", ".", "..", "a/b", "../x", ".x", "a b", "a\n"}) {
    EXPECT_FALSE(valid_artefact_name(name)) << name;
  }
}

}  // namespace
}  // namespace slipstitch::test
