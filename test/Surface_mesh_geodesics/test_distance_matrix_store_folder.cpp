// The folders of stored matrices: records, locks and files of others and of the user, damaged shards.

#include "matrix_store_helpers.h"

#include <atomic>
#include <chrono>
#include <thread>

using namespace matrix_store;
using CGAL::Surface_mesh_geodesics::internal::Shard_entry;
using CGAL::Surface_mesh_geodesics::internal::Store_folder;

namespace {

// What a kill before the next writing of the manifest leaves: the entries as records.
void leave_records(Store_folder& store)
{
  store.open();
  store.set_merging(false);
  for(std::size_t shard = 0; shard < store.layout().number_of_shards(); ++shard)
  {
    Shard_entry entry;
    CHECK(store.find(shard, entry));
    store.add(shard, entry);
  }
}

// A sphere with its stored matrix.
struct Stored_sphere
{
  explicit Stored_sphere(const std::string& name) : folder(name) { CHECK(store_again().is_complete()); }

  Status store_again() const { return store_all(tm, folder, options); }

  fs::path file(const std::string& name) const { return folder.path() / name; }

  const Mesh tm = to_face_graph(icosphere(1));
  const Options options = shards_of_five_rows();
  const Test_folder folder;
};

// --- what else may lie in the folder ---

// A process that is killed leaves records. If the user then removes the manifest and stores another matrix there, the
// records must not pass for its shards.
void records_of_another_matrix_do_not_count()
{
  test_support::Scope scope("records of another matrix");
  const Mesh before = to_face_graph(noisy_sphere(1, .1, 5)), tm = to_face_graph(noisy_sphere(1, .1, 6));
  Test_folder folder("records"), undisturbed("undisturbed");
  const Options options = shards_of_five_rows();
  CHECK(store_all(before, folder, options).is_complete());
  CHECK(store_all(tm, undisturbed, options).is_complete());
  Store_folder store(folder.name());
  leave_records(store);
  fs::remove(folder.path() / "manifest.json");
  Row_visitor visitor;
  CHECK(store_all(tm, folder, options, visitor).is_complete());
  CHECK_EQUAL(visitor.found, 0u);
  CHECK(stored_numbers(folder.path()) == stored_numbers(undisturbed.path()));
  check_is_tidy(folder.path());
}

void damaged_records_do_not_count()
{
  test_support::Scope scope("damaged records");
  const Stored_sphere sphere("damaged_records");
  const std::vector<double> numbers = stored_numbers(sphere.folder.path());
  fs::remove(sphere.file("manifest.json"));
  std::ofstream(sphere.file("rows_000000_000005.done")) << "{\"rows\": [0,";
  std::ofstream(sphere.file("todo.done")) << "buy milk";
  fs::create_directory(sphere.file("folder.done"));
  CHECK(sphere.store_again().is_complete());
  CHECK(stored_numbers(sphere.folder.path()) == numbers);
  CHECK(!fs::exists(sphere.file("rows_000000_000005.done")));
  CHECK(fs::exists(sphere.file("todo.done")));
}

void files_of_the_user_stay()
{
  test_support::Scope scope("files of the user");
  const Mesh tm = to_face_graph(icosphere(0));
  Test_folder folder("user");
  fs::create_directories(folder.path());
  const std::vector<std::string> names{"poetry.lock", "notes.tmp", "draft.2024.tmp", "rows.tmp",
                                       "rows_of_trees.lock", "manifest.before.tmp", "rows_2024.tmp", "clock.tmp",
                                       "rows_2024.npy.my.0.tmp"};
  for(const std::string& name : names)
  {
    std::ofstream(folder.path() / name) << "text";
    fs::last_write_time(folder.path() / name, fs::file_time_type::clock::now() - std::chrono::hours(24));
  }
  CHECK(store_all(tm, folder, Options()).is_complete());
  for(const std::string& name : names)
  {
    CHECK(fs::exists(folder.path() / name));
  }
}

// A process of another host has begun a file, and not written to it for an hour, but it refreshes its lock.
void files_of_living_processes_stay()
{
  test_support::Scope scope("files of other hosts");
  const Stored_sphere sphere("hosts");
  const fs::path lock = sphere.file("rows_000000_000005.lock");
  const fs::path temporary = sphere.file("rows_000000_000005.npy.node7.example.org.123.456.0.tmp");
  // The name of another host may end with that of this one.
  const std::string host = CGAL::Surface_mesh_geodesics::internal::this_process().host;
  const fs::path other = sphere.file("rows_000005_000010.npy.node7." + host + ".999999.5.0.tmp");
  for(const fs::path& file : {lock, temporary, other})
  {
    std::ofstream(file) << "node7.example.org.123.456";
  }
  fs::last_write_time(temporary, fs::file_time_type::clock::now() - std::chrono::hours(1));
  sphere.store_again();
  CHECK(fs::exists(temporary) && fs::exists(lock) && fs::exists(other));
  fs::remove(other);
  fs::last_write_time(lock, fs::file_time_type::clock::now() - std::chrono::hours(1));
  sphere.store_again();
  sphere.store_again(); // (the first call may meet the file before the lock)
  CHECK(!fs::exists(temporary) && !fs::exists(lock));
}

// Makes temporary files so old that they count as those of dead processes, where the system does not tell.
void let_temporary_files_grow_old(const fs::path& folder)
{
  if(!CGAL::Surface_mesh_geodesics::internal::knows_dead_processes)
  {
    for(const fs::path& file : files_with(folder, ".tmp"))
    {
      fs::last_write_time(file, fs::file_time_type::clock::now() - std::chrono::hours(1));
    }
  }
}

// A lock from a host whose clock went wrong, and the clock file of a process of this host that was killed.
void files_of_dead_processes_go()
{
  test_support::Scope scope("files of dead processes");
  const Stored_sphere sphere("dead");
  auto owner = CGAL::Surface_mesh_geodesics::internal::this_process();
  owner.birth = "1"; // an earlier process of this number
  write_bytes(sphere.file("clock." + owner.text() + ".3.tmp"), " ");
  let_temporary_files_grow_old(sphere.folder.path());
  fs::remove(sphere.file("rows_000005_000010.npy"));
  const fs::path lock = sphere.file("rows_000005_000010.lock");
  write_bytes(lock, "node7.12.34");
  fs::last_write_time(lock, fs::file_time_type::clock::now() + std::chrono::hours(1000));
  CHECK(sphere.store_again().is_complete());
  check_is_tidy(sphere.folder.path());
}

// A shard of another process is damaged: until that process has replaced it, it is not done.
void damaged_shards_of_others_are_not_done()
{
  test_support::Scope scope("damaged and locked");
  const Stored_sphere sphere("damaged_and_locked");
  const fs::path file = sphere.file("rows_000010_000015.npy"), lock = sphere.file("rows_000010_000015.lock");
  std::string bytes = bytes_of(file);
  bytes[200] = static_cast<char>(bytes[200] ^ 1);
  write_bytes(file, bytes);
  write_bytes(lock, "node7.12.34");
  const Status status = sphere.store_again();
  CHECK_EQUAL(status.rows_done + 5, status.rows);
  CHECK_EQUAL(status.shards_in_work, 1u);
  // Without checksums, nobody notices.
  Options trusting = sphere.options;
  trusting.compare_checksums = false;
  CHECK(store_all(sphere.tm, sphere.folder, trusting).is_complete());
  fs::remove(lock);
  Row_visitor visitor;
  CHECK(store_all(sphere.tm, sphere.folder, sphere.options, visitor).is_complete());
  CHECK_EQUAL(visitor.computed, 5u);
  CHECK(stored_numbers(sphere.folder.path()) == flat(expected_matrix(sphere.tm)));
}

// The columns of a sparse row may be anything.
void damaged_sparse_shards()
{
  test_support::Scope scope("damaged sparse shards");
  const Mesh tm = to_face_graph(icosphere(1));
  Test_folder folder("damaged_sparse");
  Options options;
  options.maximum_distance = .8;
  CHECK(store_all(tm, folder, options).is_complete());
  const fs::path file = files_with(folder.path(), ".indices.npy").front();
  std::string bytes = bytes_of(file);
  for(std::size_t i = 128; i < bytes.size(); ++i)
  {
    bytes[i] = '\x11';
  }
  write_bytes(file, bytes);
  message_of(Store_error::Reason::DAMAGED, [&] { Store(folder.name()).sparse_row(0); });
  message_of(Store_error::Reason::DAMAGED, [&] { SMG::check_geodesic_distance_matrix(tm, folder.name()); });
}

// --- the lock of the manifest ---

// A process that lost the lock, because it slept for too long, must not replace the manifest by one without the entries
// that others have added since.
void manifest_of_a_lost_lock_is_not_written()
{
  test_support::Scope scope("lost lock");
  const Mesh tm = to_face_graph(icosphere(2));
  Options options;
  options.rows_per_shard = 1;
  bool is_kept = false;
  // The other one has to come between the lock and the writing. It may come too late.
  for(int attempt = 0; attempt < 50 && !is_kept; ++attempt)
  {
    Test_folder folder("lost");
    CHECK(store_all(tm, folder, options).is_complete());
    Store_folder store(folder.name());
    leave_records(store);
    const fs::path lock = folder.path() / "manifest.lock", manifest = folder.path() / "manifest.json";
    const fs::file_time_type before = fs::last_write_time(manifest);
    std::atomic<bool> is_over{false};
    std::thread other([&]
    {
      while(!is_over && !fs::exists(lock))
      {
      }
      write_bytes(lock, "node7.12.34");
    });
    store.merge();
    is_over = true;
    other.join();
    is_kept = fs::last_write_time(manifest) == before;
    const std::size_t records = files_with(folder.path(), ".done").size();
    CHECK_EQUAL(records, is_kept ? store.layout().number_of_shards() : 0u);
    // (Windows does not remove a file that the other one is writing, under another name.)
    CHECK(files_with(folder.path(), ".tmp").empty() || !CGAL::Surface_mesh_geodesics::internal::knows_dead_processes);
    let_temporary_files_grow_old(folder.path());
    fs::remove(lock);
    CHECK(store_all(tm, folder, options).is_complete());
    check_is_tidy(folder.path());
  }
  CHECK(is_kept);
}

// A folder in the place of the manifest cannot be read.
void manifest_that_cannot_be_read()
{
  test_support::Scope scope("manifest that is a folder");
  Test_folder folder("manifest");
  fs::create_directories(folder.path() / "manifest.json");
  const std::string message = message_of(
    Store_error::Reason::NOT_A_STORE, [&] { store_all(to_face_graph(icosphere(0)), folder, Options()); });
  CHECK(message.find("manifest.json") != std::string::npos);
}

} // namespace

int main()
{
  records_of_another_matrix_do_not_count();
  damaged_records_do_not_count();
  files_of_the_user_stay();
  files_of_living_processes_stay();
  files_of_dead_processes_go();
  manifest_that_cannot_be_read();
  damaged_shards_of_others_are_not_done();
  damaged_sparse_shards();
  manifest_of_a_lost_lock_is_not_written();
  return test_result();
}
