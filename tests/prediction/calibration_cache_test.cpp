// SPDX-License-Identifier: MIT
#include "prediction/calibration_cache.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "prediction/cpu_name.h"
#include "run_dir/atomic_file.h"
#include "support/sample_run.h"

namespace slipstitch::test {
namespace {

namespace fs = std::filesystem;

Calibration sample(double per_nonzero_s) {
  return {{per_nonzero_s, 1e-10},
          {6578, 105093.0, {867781.0, 99377497.0}},
          {{0.1, 24.0, 115.0}},
          {{1e-5, 2.0, 8.0}, {0.1, 44.0, 167.0}}};
}

class CalibrationCache : public ::testing::Test {
 protected:
  /// Of what the next calibration would find.
  double kept(double would_find, const std::string& key = "0.1.0 SkylakeX cpu") {
    const auto calibrate = [&] {
      ++made_;
      return sample(would_find);
    };
    return kept_calibration(cache_, key, calibrate).cost.per_nonzero_s;
  }
  fs::path only_file() const {
    const fs::directory_iterator files(cache_);
    EXPECT_EQ(std::distance(begin(files), end(files)), 1) << "no temporary file is left";
    return fs::directory_iterator(cache_)->path();
  }

  TemporaryFolder folder_;
  fs::path cache_ = folder_ / "made/at/need";
  int made_ = 0;
};

TEST_F(CalibrationCache, IsFilledOnceAKey) {
  EXPECT_EQ(kept(1e-7), 1e-7);
  EXPECT_EQ(kept(2e-7), 1e-7);
  EXPECT_EQ(made_, 1);
  EXPECT_EQ(kept(3e-7, "0.2.0 SkylakeX cpu"), 3e-7);
  EXPECT_EQ(kept(4e-7), 1e-7) << "one of another version leaves it alone";
  EXPECT_EQ(made_, 2);
}

TEST_F(CalibrationCache, KeepsEveryNumber) {
  const Calibration made = sample(1.0 / 3.0);
  const auto read = calibration_from_json(calibration_json(made, "k"), "k");
  ASSERT_TRUE(read);
  EXPECT_EQ(calibration_json(*read, "k"), calibration_json(made, "k"));
  EXPECT_EQ(read->cost.per_nonzero_s, 1.0 / 3.0);
  EXPECT_EQ(read->accurate.back().iterations, 167.0);
  EXPECT_FALSE(calibration_from_json(calibration_json(made, "k"), "another"));
}

TEST_F(CalibrationCache, OfBrokenFilesIsMadeAgain) {
  kept(1e-7);
  const std::string good = *read_file(only_file(), 1 << 20).value;
  double next = 2e-7;
  for (const std::string& broken :
       {std::string(), std::string("{}"), std::string("[1"), good.substr(0, good.size() / 2),
        std::string(good).replace(good.find("24.0"), 4, "null"), std::string(good).replace(good.find("6578"), 4, "0"),
        std::string(good).replace(good.find("0.1"), 3, "0.9"), std::string(2 << 20, ' ')}) {
    std::ofstream(only_file()) << broken;
    EXPECT_EQ(kept(next), next) << broken.substr(0, 200);
    EXPECT_EQ(kept(9e-7), next) << "and kept";
    next += 1e-7;
  }
}

TEST_F(CalibrationCache, WorksWhereNothingCanBeKept) {
  std::ofstream(folder_ / "file") << "in the way";
  cache_ = folder_ / "file";
  EXPECT_EQ(kept(1e-7), 1e-7);
  EXPECT_EQ(kept(2e-7), 2e-7);
  cache_.clear();
  EXPECT_EQ(kept(3e-7), 3e-7);
}

TEST_F(CalibrationCache, KeepsNothingThatIsNotSound) {
  EXPECT_EQ(kept(-1.0), -1.0);
  EXPECT_TRUE(!fs::exists(cache_) || fs::is_empty(cache_));
  EXPECT_EQ(kept(1e-7), 1e-7);
}

TEST(CacheFolder, IsTheUsers) {
  ::setenv("XDG_CACHE_HOME", "/x", 1);
  EXPECT_EQ(default_cache_folder(), "/x/slipstitch");
  ::setenv("XDG_CACHE_HOME", "", 1);
  ::setenv("HOME", "/h", 1);
  EXPECT_EQ(default_cache_folder(), "/h/.cache/slipstitch");
  ::unsetenv("HOME");
  EXPECT_EQ(default_cache_folder(), fs::path());
}

TEST(CalibrationKey, NamesTheCpu) {
  EXPECT_FALSE(cpu_name().empty());
  EXPECT_NE(calibration_key().find(cpu_name()), std::string::npos);
}

}  // namespace
}  // namespace slipstitch::test
