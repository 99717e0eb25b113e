// Stored matrices: processes that are killed at random moments, several processes for one folder, and their locks.

#include "matrix_store_helpers.h"

#ifndef _WIN32
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#endif

#include <chrono>
#include <fstream>
#include <thread>

using namespace matrix_store;
namespace Internal = CGAL::Surface_mesh_geodesics::internal;

namespace {

Options small_shards()
{
  Options options;
  options.rows_per_shard = 10;
  return options;
}

Status store(const Mesh& tm, const Test_folder& folder, const Options& options = small_shards())
{
  return SMG::store_geodesic_distance_matrix(tm, vertices(tm), vertices(tm), folder.name(), named(options));
}

// --- locks ---

// The lock of another host is respected until it is ten minutes old; that of a dead process is taken over at once.
void locks_of_others()
{
  test_support::Scope scope("locks");
  const Mesh tm = to_face_graph(icosphere(1));
  Test_folder folder("locks");
  Options options = small_shards();
  options.end_row = 1;
  CHECK(store(tm, folder, options).is_complete());
  const fs::path lock = folder.path() / "rows_000010_000020.lock";
  const fs::path temporary = folder.path() / "rows_000010_000020.npy.far.away.12.34.0.tmp";
  write_bytes(lock, "far.away.12.34");
  write_bytes(temporary, "incomplete");
  Status status = store(tm, folder);
  CHECK_EQUAL(status.shards_done, 4u);
  CHECK_EQUAL(status.shards_in_work, 1u);
  CHECK_EQUAL(bytes_of(lock), "far.away.12.34");
  CHECK(fs::exists(temporary));
  const auto now = fs::file_time_type::clock::now();
  fs::last_write_time(lock, now - std::chrono::minutes(9));
  CHECK_EQUAL(store(tm, folder).shards_in_work, 1u);
  fs::last_write_time(lock, now - std::chrono::minutes(11));
  fs::last_write_time(temporary, now - std::chrono::minutes(11));
  CHECK(store(tm, folder).is_complete());
  check_is_tidy(folder.path());
  CHECK(stored_numbers(folder.path()) == flat(expected_matrix(tm)));
}

void owners_are_parsed()
{
  test_support::Scope scope("owners");
  Internal::Process_owner owner;
  CHECK(Internal::parse_owner("a.b.c.12.34", owner));
  CHECK(owner.host == "a.b.c" && owner.number == 12 && owner.birth == "34");
  CHECK_EQUAL(owner.text(), "a.b.c.12.34");
  for(const char* bad : {"", "a", "a.b", ".1.2", "a.x.2", "a.-1.2", "a..2", "a.9999999999999999999.2"})
  {
    CHECK(!Internal::parse_owner(bad, owner));
  }
  const Internal::Process_owner self = Internal::this_process();
  CHECK(Internal::parse_owner(self.text(), owner));
  CHECK(owner.text() == self.text() && !Internal::is_dead(owner));
  owner.host += "x";
  owner.birth = "1"; // another process of that number, but on another host
  CHECK(!Internal::is_dead(owner));
}

#ifndef _WIN32

// Runs a function in a child process, which leaves no trace in the counts of this one.
template <typename Function>
pid_t start(const Function& function)
{
  std::cout << std::flush;
  const pid_t child = fork();
  if(child == 0)
  {
    int status = 0;
    std::signal(SIGINT, SIG_DFL); // shells ignore it for processes in the background
    try
    {
      function();
    }
    catch(...)
    {
      status = 1;
    }
    _exit(status);
  }
  CHECK(child > 0);
  return child;
}

int status_of(pid_t child)
{
  int status = 0;
  CHECK_EQUAL(waitpid(child, &status, 0), child);
  return status;
}

std::size_t count_done(const Test_folder& folder)
{
  return fs::exists(folder.path() / "manifest.json") ? Store(folder.name()).status().shards_done : 0;
}

// Rests after each row, so that a kill comes in the middle of the work on any machine.
struct Slow_visitor
  : SMG::Geodesic_default_visitor
{
  void on_progress(std::size_t, double) { std::this_thread::sleep_for(std::chrono::milliseconds(2)); }
};

Options tiny_shards()
{
  Options options;
  options.rows_per_shard = 3;
  return options;
}

void store_slowly(const Mesh& tm, const Test_folder& folder)
{
  SMG::store_geodesic_distance_matrix(tm, vertices(tm), vertices(tm), folder.name(),
                                      named(tiny_shards()).visitor(Slow_visitor()));
}

// Waits until a number of shards is done, or a process has ended, and then for a random time.
void wait_for_shards(const Test_folder& folder, std::size_t number, pid_t child, test_support::Random& random)
{
  siginfo_t ended{};
  while(count_done(folder) < number && waitid(P_PID, static_cast<id_t>(child), &ended, WEXITED | WNOHANG | WNOWAIT) == 0
        && ended.si_pid == 0)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  std::this_thread::sleep_for(std::chrono::microseconds(random.index(20000)));
}

// Ten processes are killed at random moments, some while another one works on the same folder. What was done stays
// done, and at the end each bit is right.
void kills()
{
  test_support::Scope scope("kills");
  const Mesh tm = to_face_graph(icosphere(2));
  const std::vector<double> expected = flat(expected_matrix(tm));
  test_support::Random random(test_support::announce_seed(20261123));
  Test_folder folder("kills");
  std::size_t done = 0;
  for(int k = 0; k < 10; ++k)
  {
    const pid_t child = start([&] { store_slowly(tm, folder); });
    pid_t other = -1;
    if(k % 3 == 0)
    {
      other = start([&] { store_slowly(tm, folder); });
    }
    wait_for_shards(folder, done + random.index(6), child, random);
    kill(child, SIGKILL);
    if(other != -1)
    {
      kill(other, k % 2 == 0 ? SIGKILL : SIGINT); // Ctrl-C is SIGINT
      status_of(other);
    }
    status_of(child);
    const std::size_t now = count_done(folder);
    CHECK(now >= done);
    done = now;
    std::cout << "after kill " << k + 1 << ": " << done << " of 54 shards" << std::endl;
    CHECK(done == 0 || Store(folder.name()).damaged_shards().empty());
  }
  CHECK(done > 0);
  const Status status = store(tm, folder, tiny_shards());
  CHECK(status.is_complete());
  CHECK(stored_numbers(folder.path()) == expected);
  check_is_tidy(folder.path());
}

// A process that has ended, but whose parent has not asked for its status, is dead, too.
void zombies()
{
  test_support::Scope scope("zombies");
  const Mesh tm = to_face_graph(icosphere(1));
  Test_folder folder("zombies");
  Options options = small_shards();
  options.end_row = 0;
  store(tm, folder, options);
  const fs::path lock = folder.path() / "rows_000000_000010.lock";
  const pid_t child = start([&] { write_bytes(lock, Internal::this_process().text()); });
  while(bytes_of(lock).empty())
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  Internal::Process_owner owner;
  CHECK(Internal::parse_owner(bytes_of(lock), owner));
  for(int k = 0; k < 1000 && !Internal::is_dead(owner); ++k)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
#ifdef __linux__
  CHECK(store(tm, folder).is_complete());
#endif
  status_of(child);
  CHECK(Internal::is_dead(owner));
  CHECK(store(tm, folder).is_complete());
}

// Processes with ranges of rows, as the tasks of an array job; two of them have the same range.
void array_job()
{
  test_support::Scope scope("array job");
  const Mesh tm = to_face_graph(icosphere(2));
  const std::size_t n = num_vertices(tm);
  Test_folder folder("array");
  std::vector<pid_t> children;
  for(std::size_t task = 0; task < 4; ++task)
  {
    children.push_back(start([&] {
      Options options = small_shards();
      options.first_row = (task % 3) * n / 3;
      options.end_row = (task % 3 + 1) * n / 3;
      store(tm, folder, options);
    }));
  }
  for(const pid_t child : children)
  {
    CHECK_EQUAL(status_of(child), 0);
  }
  CHECK(Store(folder.name()).status().is_complete());
  CHECK(stored_numbers(folder.path()) == flat(expected_matrix(tm)));
  check_is_tidy(folder.path());
}

#endif // _WIN32

} // namespace

int main()
{
  owners_are_parsed();
  locks_of_others();
#ifndef _WIN32
  zombies();
  array_job();
  kills();
#endif
  return test_result();
}
