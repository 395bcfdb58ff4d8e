// SPDX-License-Identifier: MIT
#include "jobs/job_store.h"

#include <algorithm>
#include <chrono>

namespace slipstitch::jobs {
namespace {

constexpr int kDefaultPage = 50, kLargestPage = 100;
constexpr int kMostThreads = 1024;
constexpr std::size_t kLongestRequestId = 128;
constexpr double kQueueRetry_s = 5.0;

// Microseconds since 1970 at the start, then one more a change: more than any revision an earlier server gave out.
std::uint64_t first_revision() {
  const auto since_epoch = std::chrono::system_clock::now().time_since_epoch();
  return static_cast<std::uint64_t>(std::chrono::duration_cast<std::chrono::microseconds>(since_epoch).count());
}

bool is_request_id(const std::string& text) {
  const auto allowed = [](unsigned char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' || c == '_' ||
           c == ':' || c == '-';
  };
  return text.size() <= kLongestRequestId && std::all_of(text.begin(), text.end(), allowed);
}

Error invalid_fields(Issues issues) {
  Error error = error_from_issues(std::move(issues));
  error.reason = "INVALID_FIELD";
  return error;
}

Error queue_full(int queue) {
  Error error{ErrorCode::resource_exhausted,
              "QUEUE_FULL",
              "the queue is full (--queue " + std::to_string(queue) + "); try again when a job has ended",
              {{"limit", std::to_string(queue)}, {"flag", "--queue"}},
              {},
              kQueueRetry_s};
  return error;
}

char list_name(const std::optional<JobState>& state) {
  return state ? static_cast<char>('A' + static_cast<int>(*state)) : 'a';
}

}  // namespace

std::string_view state_name(JobState state) {
  constexpr std::array<std::string_view, kJobStates.size()> names{"queued", "running", "succeeded", "failed",
                                                                  "cancelled"};
  return names[static_cast<std::size_t>(state)];
}

Issues check_fields(const std::string& request_id, std::int64_t threads) {
  Issues issues;
  if (!is_request_id(request_id)) {
    issues.push_back({"request_id", request_id.substr(0, 200), "at most 128 of A-Z a-z 0-9 . _ : -"});
  }
  if (threads < 0 || threads > kMostThreads) {
    issues.push_back({"spec.threads", std::to_string(threads), "0 to " + std::to_string(kMostThreads)});
  }
  return issues;
}

std::string page_token_after(const std::string& id, const ListQuery& query) {
  return encode_page_token({id, list_name(query.state)});
}

JobStore::JobStore(DataDir data, StoreOptions options, std::unique_ptr<Executor> executor,
                   std::vector<std::string>& warnings)
    : data_(std::move(data)),
      options_(std::move(options)),
      executor_(std::move(executor)),
      revision_(first_revision()) {
  recover(warnings);
  thread_ = std::thread([this] { schedule(); });
}

JobStore::~JobStore() { stop(); }

void JobStore::recover(std::vector<std::string>& warnings) {
  for (const std::string& id : data_.job_ids()) {
    ids_.keep_above(id);
    Result<JobRecord> record = load_job(data_.job(id), id);
    if (!record) {
      warnings.push_back("left alone, not a job: " + record.error);
      continue;
    }
    record->job.revision = ++revision_;
    if (!record->job.info.request_id.empty()) by_request_id_[record->job.info.request_id] = id;
    jobs_.emplace(id, std::move(*record));
  }
}

int JobStore::count(JobState state) const {
  return static_cast<int>(std::count_if(jobs_.begin(), jobs_.end(),
                                        [state](const auto& entry) { return entry.second.job.state == state; }));
}

std::map<JobState, int> JobStore::counts() const {
  const std::lock_guard lock(mutex_);
  std::map<JobState, int> counts;
  for (const JobState state : kJobStates) counts[state] = count(state);
  return counts;
}

JobInfo JobStore::info_of(const NewJob& request) const {
  const int threads = request.threads > 0 ? request.threads : options_.default_threads;
  return {"",           request.request_id, request.spec_hash(threads), threads, options_.blas, "", request.scene_name,
          request.study};
}

Outcome<Job> JobStore::validate(const NewJob& request) const {
  Issues issues = check_fields(request.request_id, request.threads);
  if (!issues.empty()) return invalid_fields(std::move(issues));
  Job job;
  job.info = info_of(request);
  return job;
}

Outcome<Job> JobStore::create(const NewJob& request) {
  Issues issues = check_fields(request.request_id, request.threads);
  if (!issues.empty()) return invalid_fields(std::move(issues));
  const std::lock_guard lock(mutex_);
  Outcome<Job> created = create_locked(request);
  new_work_ = true;
  work_.notify_all();
  return created;
}

Outcome<Job> JobStore::create_locked(const NewJob& request) {
  if (stopping_) return server_stopping();
  if (const auto known = by_request_id_.find(request.request_id); known != by_request_id_.end()) {
    return repeat_of(jobs_.at(known->second), request);
  }
  const int free_slots = std::max(0, options_.slots - count(JobState::running));
  if (count(JobState::queued) >= options_.queue + free_slots) return queue_full(options_.queue);

  JobRecord record;
  record.job.id = ids_.next();
  record.dir = data_.job(record.job.id);
  record.job.info = info_of(request);
  record.job.info.name = "simJobs/" + record.job.id;
  record.job.info.create_time = utc_now();
  record.job.revision = ++revision_;
  const IoError error = data_.create_job(record.job.id, record.job.info, request.scene_json);
  if (!error.empty()) return storage_failed(error);
  if (!request.request_id.empty()) by_request_id_[request.request_id] = record.job.id;
  return jobs_.emplace(record.job.id, std::move(record)).first->second.job;
}

Outcome<Job> JobStore::repeat_of(const JobRecord& existing, const NewJob& request) const {
  const JobInfo& info = existing.job.info;
  // A request that leaves the threads to the server repeats whatever the server chose then.
  const int threads = request.threads > 0 ? request.threads : info.threads;
  if (request.spec_hash(threads) == info.spec_hash) return existing.job;
  return Error{ErrorCode::already_exists,
               "REQUEST_ID_REUSED",
               "request_id " + info.request_id + " was used for " + info.name + " with another spec",
               {{"job", info.name}, {"request_id", info.request_id}},
               {},
               {}};
}

Outcome<Job> JobStore::get(const std::string& id) const {
  const std::lock_guard lock(mutex_);
  const auto found = jobs_.find(id);
  if (found == jobs_.end()) return job_not_found(id);
  return found->second.job;
}

Outcome<RunDir> JobStore::folder(const std::string& id) const {
  const std::lock_guard lock(mutex_);
  const auto found = jobs_.find(id);
  if (found == jobs_.end()) return job_not_found(id);
  return found->second.dir;
}

Outcome<JobPage> JobStore::list(const ListQuery& query) const {
  if (query.page_size < 0) return invalid_field("page_size", std::to_string(query.page_size), "0 or more");
  const int size = query.page_size == 0 ? kDefaultPage : std::min(query.page_size, kLargestPage);
  const std::optional<PageMark> after = decode_page_token(query.page_token);
  if (!query.page_token.empty() && (!after || after->list != list_name(query.state))) {
    Error error = invalid_field("page_token", query.page_token.substr(0, 100), "next_page_token of the same list");
    error.reason = "INVALID_PAGE_TOKEN";
    return error;
  }
  const std::lock_guard lock(mutex_);
  JobPage page;
  auto next = std::make_reverse_iterator(after ? jobs_.lower_bound(after->last_id) : jobs_.end());
  for (; next != jobs_.rend(); ++next) {
    const Job& job = next->second.job;
    if (query.state && job.state != *query.state) continue;
    if (static_cast<int>(page.jobs.size()) == size) {
      page.next_page_token = page_token_after(page.jobs.back().id, query);
      break;
    }
    page.jobs.push_back(job);
  }
  return page;
}

Outcome<Job> JobStore::cancel(const std::string& id) {
  Calls calls;
  Outcome<Job> result = [&]() -> Outcome<Job> {
    const std::lock_guard lock(mutex_);
    Outcome<Job> cancelled = cancel_locked(id);
    if (cancelled) wake_watchers(id, calls);
    return cancelled;
  }();
  for (const auto& call : calls) call();
  return result;
}

Outcome<Job> JobStore::cancel_locked(const std::string& id) {
  const auto found = jobs_.find(id);
  if (found == jobs_.end()) return job_not_found(id);
  JobRecord& record = found->second;
  Job& job = record.job;
  if (job.state == JobState::succeeded || job.state == JobState::failed) {
    return wrong_state(id, "JOB_ENDED", "has ended already");
  }
  if (job.cancel_requested || job.state == JobState::cancelled) return job;
  if (const IoError error = request_cancel(record.dir); !error.empty()) return storage_failed(error);
  job.cancel_requested = true;
  if (job.state == JobState::queued) settle_cancelled(record);
  job.revision = ++revision_;
  return job;
}

Outcome<Done> JobStore::remove(const std::string& id) {
  Calls calls;
  {
    const std::lock_guard lock(mutex_);
    const auto found = jobs_.find(id);
    if (found == jobs_.end()) return job_not_found(id);
    if (!is_terminal(found->second.job.state))
      return wrong_state(id, "JOB_NOT_ENDED", "has not ended; cancel it first");
    if (const IoError error = data_.remove_job(id); !error.empty()) return storage_failed(error);
    by_request_id_.erase(found->second.job.info.request_id);
    jobs_.erase(found);
    wake_watchers(id, calls);
  }
  for (const auto& call : calls) call();
  return Done{};
}

}  // namespace slipstitch::jobs
