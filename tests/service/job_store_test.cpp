// SPDX-License-Identifier: MIT
#include "jobs/job_store.h"

#include <algorithm>
#include <atomic>

#include "store_helpers.h"

namespace slipstitch::jobs {
namespace {

class JobStoreTest : public ::testing::Test {
 protected:
  test::TemporaryFolder folder_;
  HeldWork work_;
};

TEST_F(JobStoreTest, RunsAJobToItsEnd) {
  auto store = open_store(folder_.path(), work_, {1, 10, 3, "Haswell"});
  const Outcome<Job> created = store->create(new_job("r1"));
  ASSERT_TRUE(created) << created.error().message;
  EXPECT_EQ(created->info.name, "simJobs/" + created->id);
  EXPECT_EQ(created->info.threads, 3);
  EXPECT_EQ(created->info.blas, "Haswell");
  wait_for_state(*store, created->id, JobState::running);
  work_.let_go();
  const Job ended = wait_for_end(*store, created->id);
  EXPECT_EQ(ended.state, JobState::succeeded);
  EXPECT_GT(ended.revision, created->revision);
  EXPECT_FALSE(ended.failure);
  EXPECT_NE(ended.summary_json.find("succeeded"), std::string::npos);
  EXPECT_LE(ended.info.create_time, ended.start_time);
  EXPECT_LE(ended.start_time, ended.end_time);
}

TEST_F(JobStoreTest, RemembersThatAJobIsAStudy) {
  std::string id;
  {
    auto store = open_store(folder_.path(), work_);
    NewJob request = new_job("r1");
    request.study = StudyWork{true, 60.0};
    id = store->create(request)->id;
    EXPECT_FALSE(store->get(store->create(new_job("r2"))->id)->info.study);
  }
  HeldWork work;
  const Outcome<Job> job = open_store(folder_.path(), work)->get(id);
  ASSERT_TRUE(job && job->info.study);
  EXPECT_EQ(*job->info.study, (StudyWork{true, 60.0}));
}

TEST_F(JobStoreTest, IsOnDiskWhenCreateAnswers) {
  auto store = open_store(folder_.path(), work_);
  const Outcome<Job> created = store->create(new_job("r1", "{\"name\":\"x\"}"));
  ASSERT_TRUE(created);
  const RunDir dir{folder_ / "jobs" / created->id};
  EXPECT_EQ(*read_scene(dir), "{\"name\":\"x\"}");
  EXPECT_EQ(read_job(dir)->request_id, "r1");
  EXPECT_TRUE(std::filesystem::is_empty(folder_ / "tmp"));
}

TEST_F(JobStoreTest, AnswersARepeatedRequestWithTheSameJob) {
  auto store = open_store(folder_.path(), work_);
  const Outcome<Job> first = store->create(new_job("r1"));
  const Outcome<Job> again = store->create(new_job("r1"));
  ASSERT_TRUE(first && again);
  EXPECT_EQ(first->id, again->id);
  for (const NewJob& other : {new_job("r1", "{\"name\":\"other\"}"), new_job("r1", "{\"name\":\"a\"}", 7)}) {
    const Outcome<Job> refused = store->create(other);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::already_exists);
    EXPECT_EQ(refused.error().reason, "REQUEST_ID_REUSED");
  }
  EXPECT_EQ(store->list({})->jobs.size(), 1U);
}

TEST_F(JobStoreTest, ValidatesWithoutStoring) {
  auto store = open_store(folder_.path(), work_);
  const Outcome<Job> valid = store->validate(new_job("r1"));
  ASSERT_TRUE(valid);
  EXPECT_EQ(valid->info.name, "");
  EXPECT_FALSE(store->validate(new_job("bad id")));
  EXPECT_TRUE(std::filesystem::is_empty(folder_ / "jobs"));
}

TEST_F(JobStoreTest, RefusesBadRequestsNamingAllFields) {
  auto store = open_store(folder_.path(), work_);
  const Outcome<Job> refused = store->create(new_job("white space", "{}", -1));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().reason, "INVALID_FIELD");
  ASSERT_EQ(refused.error().violations.size(), 2U);
  EXPECT_EQ(refused.error().violations[0].path, "request_id");
  EXPECT_EQ(refused.error().violations[1].path, "spec.threads");
  EXPECT_TRUE(std::filesystem::is_empty(folder_ / "jobs"));
}

TEST_F(JobStoreTest, RefusesMoreThanTheQueueHoldsNamingTheFlag) {
  auto store = open_store(folder_.path(), work_, {1, 2, 1, ""});
  const Outcome<Job> running = store->create(new_job("r0"));
  wait_for_state(*store, running->id, JobState::running);
  ASSERT_TRUE(store->create(new_job("r1")));
  ASSERT_TRUE(store->create(new_job("r2")));
  const Outcome<Job> refused = store->create(new_job("r3"));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::resource_exhausted);
  EXPECT_EQ(refused.error().reason, "QUEUE_FULL");
  EXPECT_EQ(refused.error().metadata.at("flag"), "--queue");
  EXPECT_TRUE(refused.error().retry_after_s);
  EXPECT_TRUE(store->create(new_job("r2"))) << "a repeat needs no place";
}

TEST_F(JobStoreTest, CancelsAQueuedJobAtOnceAndARunningOneThroughItsLog) {
  auto store = open_store(folder_.path(), work_);
  const Outcome<Job> running = store->create(new_job("r0"));
  wait_for_state(*store, running->id, JobState::running);
  const Outcome<Job> queued = store->create(new_job("r1"));
  EXPECT_EQ(store->cancel(queued->id)->state, JobState::cancelled);
  EXPECT_TRUE(store->cancel(queued->id)) << "repeating is harmless";
  EXPECT_TRUE(store->cancel(running->id)->cancel_requested);
  EXPECT_EQ(wait_for_end(*store, running->id).state, JobState::cancelled);
}

TEST_F(JobStoreTest, CancelOfAnEndedJobAndDeleteOfALiveOneAreRefused) {
  auto store = open_store(folder_.path(), work_);
  const Outcome<Job> job = store->create(new_job("r0"));
  EXPECT_EQ(store->remove(job->id).error().reason, "JOB_NOT_ENDED");
  work_.let_go();
  wait_for_end(*store, job->id);
  EXPECT_EQ(store->cancel(job->id).error().reason, "JOB_ENDED");
  ASSERT_TRUE(store->remove(job->id));
  EXPECT_EQ(store->get(job->id).error().reason, "JOB_NOT_FOUND");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "jobs" / job->id));
  EXPECT_NE(store->create(new_job("r0"))->id, job->id) << "its request id is free again";
}

TEST_F(JobStoreTest, ListsNewestFirstInPages) {
  auto store = open_store(folder_.path(), work_);
  std::vector<std::string> ids;
  for (int i = 0; i < 5; ++i) ids.push_back(store->create(new_job("r" + std::to_string(i)))->id);
  std::vector<std::string> listed;
  ListQuery query{2, "", {}};
  do {
    const Outcome<JobPage> page = store->list(query);
    ASSERT_TRUE(page) << page.error().message;
    EXPECT_LE(page->jobs.size(), 2U);
    for (const Job& job : page->jobs) listed.push_back(job.id);
    query.page_token = page->next_page_token;
  } while (!query.page_token.empty());
  EXPECT_EQ(listed, std::vector<std::string>(ids.rbegin(), ids.rend()));
}

TEST_F(JobStoreTest, RefusesBadPagesAndTokensOfAnotherList) {
  auto store = open_store(folder_.path(), work_);
  for (int i = 0; i < 3; ++i) store->create(new_job("r" + std::to_string(i)));
  const std::string token = store->list({1, "", {}})->next_page_token;
  EXPECT_EQ(store->list({-1, "", {}}).error().reason, "INVALID_FIELD");
  EXPECT_EQ(store->list({1, "nonsense", {}}).error().reason, "INVALID_PAGE_TOKEN");
  EXPECT_EQ(store->list({1, token, JobState::queued}).error().reason, "INVALID_PAGE_TOKEN");
  EXPECT_EQ(store->list({1, "", JobState::failed})->jobs.size(), 0U);
}

TEST_F(JobStoreTest, WakesWatchersOfTheJobWithGrowingRevisions) {
  auto store = open_store(folder_.path(), work_);
  const Outcome<Job> job = store->create(new_job("r0"));
  std::mutex mutex;
  std::vector<std::uint64_t> revisions;
  const auto watch = store->watch(job->id, [&] {
    const std::lock_guard lock(mutex);
    revisions.push_back(store->get(job->id)->revision);
  });
  std::atomic<int> calls_of_other = 0;
  store->watch("0000000000000000", [&] { ++calls_of_other; });
  work_.let_go();
  const Job ended = wait_for_end(*store, job->id);
  for (std::uint64_t last = 0; last < ended.revision;) {
    const std::lock_guard lock(mutex);
    last = revisions.empty() ? 0 : revisions.back();
  }
  store->unwatch(watch);
  EXPECT_TRUE(std::is_sorted(revisions.begin(), revisions.end()));
  EXPECT_EQ(calls_of_other, 0);
}

TEST_F(JobStoreTest, TakesNothingNewWhileStopping) {
  auto store = open_store(folder_.path(), work_);
  const Outcome<Job> job = store->create(new_job("r0"));
  wait_for_state(*store, job->id, JobState::running);
  store->stop();
  EXPECT_EQ(store->create(new_job("r1")).error().reason, "SERVER_STOPPING");
  EXPECT_EQ(store->get(job->id)->state, JobState::running) << "stop leaves jobs alone";
  store->stop_jobs(60.0);
  EXPECT_EQ(store->get(job->id)->state, JobState::cancelled);
}

TEST_F(JobStoreTest, FailsAJobWhoseWorkerLeavesNoSummary) {
  auto store = open_store(folder_.path(), make_in_process_executor([](const RunDir&, const JobInfo&) {}));
  const Job ended = wait_for_end(*store, store->create(new_job("r0"))->id);
  EXPECT_EQ(ended.state, JobState::failed);
  ASSERT_TRUE(ended.failure);
  EXPECT_EQ(ended.failure->reason, "WORKER_CRASHED");
  EXPECT_NE(ended.failure->message.find("exit code 0"), std::string::npos);
  EXPECT_NE(ended.summary_json.find("\"newton_iterations\": null"), std::string::npos) << "not measured is not 0";
}

}  // namespace
}  // namespace slipstitch::jobs
