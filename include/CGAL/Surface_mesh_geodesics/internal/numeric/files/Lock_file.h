// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_NUMERIC_FILES_LOCK_FILE_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_NUMERIC_FILES_LOCK_FILE_H

// Locks of files that processes on several machines share: a file next to what is locked, with the host, the number and
// the birth of the process that owns it.
//
// A lock is stale, and the next process takes it over, if
// - its owner ran on this host and is dead, or
// - it has not been refreshed for ten minutes: its host may be down. An owner refreshes its locks every ten seconds. (A
//   time that lies ten minutes in the future is no sign of life either.)
//
// Two processes can own one lock in rare cases: an owner that slept for more than ten minutes, or two that take over
// one stale lock at the same instant. So a lock saves work: each process writes files of its own, complete ones get
// their names at once, and the shards of both would be equal. A manifest is not: whoever replaces it asks is_owned()
// right before, and leaves it as it is if the lock is gone.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/files/System_files.h>

#include <chrono>
#include <filesystem>
#include <string>
#include <system_error>
#include <thread>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// The object is the lock: the constructor locks, and the destructor unlocks. A process that is killed leaves the file,
// and with it the host and the number by which others see that it is stale.
//
// The protocol needs neither fcntl() locks, which network file systems treat differently, nor a daemon: only that a
// name is given to one file, and that renaming a file happens at once. Every file system of POSIX and NTFS have that.
class Lock_file
{
public:
  // After this time without a sign of life, the lock of another host is stale.
  static constexpr std::chrono::minutes patience{10};

  // Tries to lock, for as long as `longest_wait`.
  explicit Lock_file(const std::filesystem::path& path,
                     std::chrono::milliseconds longest_wait = std::chrono::milliseconds(0))
    : m_path(path), m_owner(this_process().text()), m_last_refreshment(Clock::now())
  {
    const Clock::time_point end = m_last_refreshment + longest_wait;
    for(m_is_held = try_to_lock(); !m_is_held && Clock::now() < end; m_is_held = try_to_lock())
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }

  // Unlocks, unless another process has taken the lock over.
  ~Lock_file()
  {
    std::error_code error;
    if(is_owned())
      std::filesystem::remove(m_path, error);
  }

  Lock_file(const Lock_file&) = delete;
  Lock_file& operator=(const Lock_file&) = delete;

  // False if another process has the lock. The object does nothing then.
  bool is_held() const { return m_is_held; }

  // Is the lock held, and has no other process taken it over since? Reads the file.
  bool is_owned() const { return m_is_held && text_of_file(m_path) == m_owner; }

  // A sign of life, at most one in ten seconds: cheap enough for each visit of a run.
  void refresh()
  {
    const Clock::time_point now = Clock::now();
    if(now - m_last_refreshment < std::chrono::seconds(10))
      return;
    m_last_refreshment = now;
    set_time_to_now(m_path); // a lock that cannot be refreshed ages; others may compute the same
  }

  // Is there a lock that is not stale?
  // The text is read first: a lock that disappears between the two steps counts as none, never as a stale one. A text
  // that is not an owner may be one that is being written: only its age counts.
  static bool is_held_by_other(const std::filesystem::path& path, const Folder_clock& clock)
  {
    const std::string text = text_of_file(path);
    std::error_code error;
    if(!std::filesystem::exists(path, error))
      return false;
    Process_owner owner;
    return !(parse_owner(text, owner) && is_dead(owner)) && clock.distance(path) < patience;
  }

private:
  using Clock = std::chrono::steady_clock;

  // One attempt. If a stale lock is taken over, another process may still be the first to make a new one.
  bool try_to_lock()
  {
    const std::filesystem::path temporary = temporary_name(m_path);
    if(create_exclusively(m_path, temporary, m_owner))
      return true;
    return take_over() && create_exclusively(m_path, temporary, m_owner);
  }

  // Removes a stale lock; returns whether there is none any more. The lock first gets another name, which only one of
  // several processes can give it; if it turns out to be a new lock, it gets its name back.
  bool take_over()
  {
    const std::string text = text_of_file(m_path);
    const std::filesystem::path moved = temporary_name(m_path);
    if(is_held_by_other(m_path, Folder_clock(m_path.parent_path())))
      return false;
    std::error_code error;
    std::filesystem::rename(m_path, moved, error);
    const bool is_gone = error == std::errc::no_such_file_or_directory;
    const bool is_stale = is_gone || (!error && text_of_file(moved) == text);
    if(!error && !is_stale)
      std::filesystem::create_hard_link(moved, m_path, error);
    std::filesystem::remove(moved, error);
    return is_stale;
  }

  // The text of the lock is m_owner as long as the lock is held, unless it was taken over.
  std::filesystem::path m_path;
  std::string m_owner;
  Clock::time_point m_last_refreshment;
  bool m_is_held = false;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_NUMERIC_FILES_LOCK_FILE_H
