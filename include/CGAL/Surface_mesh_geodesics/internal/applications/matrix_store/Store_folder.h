// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_MATRIX_STORE_STORE_FOLDER_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_MATRIX_STORE_STORE_FOLDER_H

// The folder of a store: the manifest, and which shards are done.
//
// A shard is done when its entry is in the manifest or in a record, a small file "rows_A_B.done" with the same entry.
// A process that has completed the files of a shard writes a record, and from time to time moves all records into the
// manifest, under a lock. So the end of a shard takes constant time, two processes never lose each other's entries, and
// a process that is killed at any time leaves a folder that others understand.
//
// Each file is written under a temporary name, synced and renamed, and the folder is synced before anything refers to
// the file: after a loss of power, what the manifest lists is there.
//
// A manifest, with one shard of two rows. Names of members are part of the format: a program that changes their meaning
// has to change the version, too, and to read the old one. Members that a reader does not know are ignored, and lost
// when the manifest is written again. Only a manifest with faces or edges to avoid has that member; a reader that does
// not know it finds that the hash does not fit. An edge is a face and a number: edge k leads from corner k of the face
// to the next one.
//
//   {
//     "format": "CGAL Surface_mesh_geodesics distance matrix",
//     "version": 1,
//     "mesh": {
//       "name": "/data/bunny.off",
//       "vertices": 4,
//       "faces": 4,
//       "hash": "57b42d0bb9384da7"
//     },
//     "matrix": {
//       "kind": "full",
//       "element": "float32",
//       "rows": 2,
//       "columns": 4,
//       "rows_per_shard": 16
//     },
//     "sources": [0, 3],
//     "targets": "all",
//     "faces_to_avoid": [2],
//     "edges_to_avoid": [[0, 1], [1, 2]],
//     "hash": "4c418aa5cc623c83",
//     "shards": [
//       {
//         "rows": [0, 2],
//         "files": [
//           {
//             "name": "rows_000000_000002.npy",
//             "elements": 8,
//             "checksum": "b59633b6cac75cec"
//           }
//         ]
//       }
//     ]
//   }

#include <CGAL/Surface_mesh_geodesics/internal/applications/matrix_store/Store_description.h>
#include <CGAL/Surface_mesh_geodesics/internal/applications/matrix_store/Store_layout.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/files/Json_value.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/files/Lock_file.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/files/Npy_file.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/files/System_files.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <filesystem>
#include <map>
#include <mutex>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// A shard that is done: the number of elements and the checksum of each of its arrays.
// In the order of Store_layout::arrays(). The checksum is that of the elements; header and size follow from the layout.
struct Shard_entry
{
  std::vector<std::pair<std::size_t, std::string>> arrays;
};

// What other processes do to the folder meanwhile: they add shards, move records into the manifest, replace damaged
// files by equal ones without the damage, and make and remove locks and temporary files. Nothing that is done is
// undone, except by a process that sleeps for ten minutes at a bad instant (write_manifest()).
//
// The order of steps makes each instant safe:
// - files of a shard, then the folder is synced, then the record: a record without its files cannot be;
// - the manifest with the entry of a record, then the record is removed: an entry is always in one of them;
// - the record is looked up before the manifest: a reader cannot miss an entry that moves meanwhile.
class Store_folder
{
public:
  // Does not touch the folder yet.
  // (The system would take the part before a null character for the name.)
  explicit Store_folder(const std::filesystem::path& path) : m_path(path)
  {
    const auto& name = path.native();
    if(std::find(name.begin(), name.end(), std::filesystem::path::value_type(0)) != name.end())
      throw Geodesic_matrix_store_error(Geodesic_matrix_store_error::Reason::INVALID_OPTION,
                                        std::string(path.string().c_str())
                                          + ": the name of the folder goes on behind a null character");
  }

  // The mutex cannot be copied, and two objects for one folder know nothing of each other's entries but what is in
  // the files, as two processes do.
  Store_folder(const Store_folder&) = delete;
  Store_folder& operator=(const Store_folder&) = delete;

  // --- the manifest ---

  // Any file of this name counts; reading it decides whether it is one.
  bool has_manifest() const
  {
    std::error_code error;
    return std::filesystem::exists(manifest(), error);
  }

  // Reads a manifest that is there.
  void open()
  {
    const std::lock_guard<std::mutex> guard(m_mutex);
    if(!has_manifest())
      throw Geodesic_matrix_store_error(Geodesic_matrix_store_error::Reason::NOT_A_STORE,
                                        m_path.string() + ": the folder has no manifest.json");
    read_manifest();
  }

  // Makes the folder with a manifest, or checks that the manifest there describes the same matrix; its shards count
  // then. Of several processes that call this at once, one makes the manifest.
  void open_or_create(const Store_description& description)
  {
    const std::lock_guard<std::mutex> guard(m_mutex);
    std::error_code error;
    std::filesystem::create_directories(m_path, error);
    // It may exist, and be a folder of the user with other files in it; these stay.
    if(error)
      complain_of_file(m_path, "cannot be made: " + error.message());
    if(!has_manifest())
    {
      sync_folder(std::filesystem::absolute(m_path, error).parent_path());
      const std::filesystem::path temporary = temporary_name(manifest());
      write_synced(temporary, text_of_manifest(description, description.hash()));
      static_cast<void>(give_new_name(temporary, manifest())); // another process may have been faster
      sync_folder(m_path);
    }
    read_manifest();
    check_is_same(description);
  }

  // Requires, for the functions below: open() or open_or_create() has returned.
  const Store_description& description() const { return m_description; }
  const Store_layout& layout() const { return m_description.layout; }
  const std::filesystem::path& path() const { return m_path; }

  // --- shards ---

  // The name of a file of a shard.
  std::filesystem::path file(std::size_t shard, const std::string& ending) const
  {
    return m_path / (layout().name(shard) + ending);
  }
  std::filesystem::path lock_of(std::size_t shard) const { return file(shard, ".lock"); }

  // Returns whether a shard is done, and its entry. Records are looked up first: they move into the manifest, not out.
  // Does not look at the files of the shard; is_intact() does. Takes constant time, unless the manifest has changed.
  bool find(std::size_t shard, Shard_entry& entry)
  {
    const std::lock_guard<std::mutex> guard(m_mutex);
    std::pair<std::size_t, Shard_entry> recorded;
    if(read_record(file(shard, ".done"), recorded))
    {
      entry = recorded.second;
      return true;
    }
    read_manifest_if_changed();
    const auto found = m_entries.find(shard);
    if(found != m_entries.end())
      entry = found->second;
    return found != m_entries.end();
  }

  // Are all files of a shard what its entry says? Reads them.
  // Several threads may call it at once.
  bool is_intact(std::size_t shard, const Shard_entry& entry) const
  {
    const std::vector<Shard_array> arrays = layout().arrays();
    for(std::size_t k = 0; k < arrays.size(); ++k)
    {
      // The number of elements decides about the header of a sparse matrix.
      const std::size_t elements = entry.arrays[k].first;
      const std::size_t size = arrays[k].element.back() == '8' ? 8 : 4;
      if(!internal::is_intact(file(shard, arrays[k].ending),
                              npy_header(arrays[k].element, layout().extents(shard, elements)), elements * size,
                              entry.arrays[k].second))
        return false;
    }
    return true;
  }

  // Notes that a shard is done. Requires: its files have their names, and the folder has been synced.
  // The manifest follows at most once in five seconds: it has an entry for each shard, and writing it for each of them
  // would take quadratic time.
  void add(std::size_t shard, const Shard_entry& entry)
  {
    const std::filesystem::path record = file(shard, ".done");
    // A record outlives its manifest, so it says what matrix it belongs to.
    Json_value value = to_json(shard, entry);
    value.add("mesh", m_description.mesh_hash);
    value.add("matrix", m_hash);
    write_renamed(record, value.written() + '\n');
    const std::lock_guard<std::mutex> guard(m_mutex);
    // The entry is known here at once; find() would see the record, too.
    m_entries[shard] = entry;
    if(m_is_merging && std::chrono::steady_clock::now() - m_last_merge > std::chrono::seconds(5))
      merge_records(std::chrono::milliseconds(0)); // no thread waits: another process is at it
  }

  // Whether this object moves records into the manifest from time to time. Of several that know each other, one does.
  bool is_merging() const { return m_is_merging; }
  void set_merging(bool is_merging) { m_is_merging = is_merging; }

  // Moves all records into the manifest.
  // Called at the end of each call, so that a folder at rest has no records, unless another process has locked the
  // manifest for long. Then they stay; they count as the manifest does.
  void merge()
  {
    const std::lock_guard<std::mutex> guard(m_mutex);
    merge_records(longest_wait);
  }

  // --- the folder ---

  // Removes temporary files and locks of processes that are dead, or of other hosts and older than locks may be.
  // Files of living processes stay: another process may be at work. So do files whose names are not those that this
  // class gives: they are the user's.
  void remove_stale_files() const
  {
    const Folder_clock clock(m_path);
    std::error_code error;
    for(const auto& each : std::filesystem::directory_iterator(m_path, error))
    {
      const std::string base = base_of(each.path());
      if(base != "manifest" && base != "clock" && !Store_layout::is_name(base))
        continue;
      if(each.path().extension() == ".tmp" && is_stale(each.path(), clock))
        std::filesystem::remove(each.path(), error);
      else if(each.path().extension() == ".lock" && !Lock_file::is_held_by_other(each.path(), clock))
        Lock_file lock(each.path()); // takes it over, and ends: nobody asks for the lock of a shard that is done
    }
  }

  // Is another process, or another call in this one, at work on a shard?
  bool is_locked(std::size_t shard, const Folder_clock& clock) const
  {
    return Lock_file::is_held_by_other(lock_of(shard), clock);
  }

private:
  // For the lock of the manifest, which others have for a moment at a time.
  static constexpr std::chrono::seconds longest_wait{20};

  std::filesystem::path manifest() const { return m_path / "manifest.json"; }
  std::filesystem::path manifest_lock() const { return m_path / "manifest.lock"; }

  // The name of a file up to the first dot: "manifest" or the name of a shard, unless the file is the user's.
  static std::string base_of(const std::filesystem::path& path)
  {
    const std::string name = path.filename().string();
    return name.substr(0, name.find('.'));
  }

  // The owner in the name of a temporary file (temporary_name()): behind the name of the file, whose endings are known
  // here, and before the count. Returns false for other names: names of hosts may contain dots, so nothing is guessed.
  static bool find_owner(const std::filesystem::path& path, Process_owner& owner)
  {
    const std::string name = path.stem().stem().string().substr(base_of(path).size()); // without ".tmp" and the count
    for(const std::string ending : {".indptr.npy.", ".indices.npy.", ".data.npy.", ".npy.", ".json.", ".lock.",
                                    ".done.", "."}) // the last one for "clock"
      if(name.compare(0, ending.size(), ending) == 0)
        return parse_owner(name.substr(ending.size()), owner);
    return false;
  }

  // A process of another host may write a file for longer than locks may be old before its first buffer is full: as
  // long as it has the lock, the file stays.
  bool is_stale(const std::filesystem::path& path, const Folder_clock& clock) const
  {
    Process_owner owner;
    if(!find_owner(path, owner))
      return false;
    if(knows_dead_processes && owner.host == this_process().host)
      return is_dead(owner);
    return clock.distance(path) > Lock_file::patience
        && !Lock_file::is_held_by_other(m_path / (base_of(path) + ".lock"), clock);
  }

  // The usual way of all small files: written, synced, renamed, and the folder synced.
  void write_renamed(const std::filesystem::path& path, const std::string& text) const
  {
    const std::filesystem::path temporary = temporary_name(path);
    write_synced(temporary, text);
    rename_file(temporary, path);
    sync_folder(m_path);
  }

  // --- the following functions require the mutex ---

  // The hash of the mesh is compared first: with another mesh, the rest means nothing.
  void check_is_same(const Store_description& other) const
  {
    using Reason = Geodesic_matrix_store_error::Reason;
    const std::string begin = m_path.string() + ": the folder has the matrix of ";
    if(other.mesh_hash != m_description.mesh_hash)
      throw Geodesic_matrix_store_error(Reason::DIFFERENT_MESH,
                                        begin + "a mesh with the hash " + m_description.mesh_hash
                                          + ", and this mesh has the hash " + other.mesh_hash);
    if(other.hash() != m_hash)
      throw Geodesic_matrix_store_error(Reason::DIFFERENT_MATRIX,
                                        begin + "sources, targets and options with the hash " + m_hash
                                          + ", and those of this call have the hash " + other.hash());
  }

  // The shards come in the order of rows. Takes time for the number of shards and of sources.
  std::string text_of_manifest(const Store_description& description, const std::string& hash) const
  {
    Json_value mesh, value;
    mesh.add("name", description.mesh_name);
    mesh.add("vertices", description.vertices);
    mesh.add("faces", description.faces);
    mesh.add("hash", description.mesh_hash);
    value.add("format", format());
    value.add("version", std::size_t(1));
    value.add("mesh", mesh);
    value.add("matrix", description.layout.to_json());
    value.add("sources", description.sources);
    value.add("targets", description.targets);
    if(!description.faces_to_avoid.empty())
      value.add("faces_to_avoid", description.faces_to_json());
    if(!description.edges_to_avoid.empty())
      value.add("edges_to_avoid", description.edges_to_json());
    value.add("hash", hash);
    // The entries are sorted by shard, so equal folders have equal manifests.
    std::vector<Json_value> shards;
    for(const auto& entry : m_entries)
      shards.push_back(to_json(entry.first, entry.second));
    value.add("shards", Json_value(std::move(shards)));
    return value.written() + '\n';
  }

  // Replaces the manifest. Returns false, and leaves it as it is, if another process has taken over the lock meanwhile:
  // it may have written entries that are not known here. (A process that sleeps for ten minutes between the question
  // and the renaming undoes entries nevertheless. Their shards are computed again then, and are the same.)
  bool write_manifest(const Lock_file& lock)
  {
    const std::filesystem::path temporary = temporary_name(manifest());
    write_synced(temporary, text_of_manifest(m_description, m_hash));
    if(!lock.is_owned())
    {
      std::error_code error;
      std::filesystem::remove(temporary, error);
      return false;
    }
    rename_file(temporary, manifest());
    sync_folder(m_path);
    m_last_state = state_of_manifest();
    return true;
  }

  // The state is taken before the contents: if the file changes in between, it is read once more, never too seldom.
  // An error about what the manifest says begins with its name, as all errors do. (The reader of the text does not know
  // which file it is from.)
  void read_manifest()
  {
    m_last_state = state_of_manifest();
    // Somebody has removed it while this process was at work.
    if(!has_manifest())
      complain_of_file(manifest(), "is gone");
    try
    {
      take_manifest(Json_reader(text_of_file(manifest())).read());
    }
    catch(const Geodesic_matrix_store_error& error)
    {
      if(error.reason() != Geodesic_matrix_store_error::Reason::NOT_A_STORE)
        throw;
      throw Geodesic_matrix_store_error(error.reason(), manifest().string() + ": " + error.what());
    }
  }

  // Takes what the file says, or complains.
  void take_manifest(const Json_value& value)
  {
    if(!value.at("format").is_text(format()) || value.at("version").count() != 1)
      Json_value::complain("it has another format or version");
    Store_description d;
    const Json_value& mesh = value.at("mesh");
    d.mesh_name = mesh.at("name").text();
    d.vertices = mesh.at("vertices").count();
    d.faces = mesh.at("faces").count();
    d.mesh_hash = mesh.at("hash").text();
    d.layout = Store_layout::from_json(value.at("matrix"));
    d.sources = value.at("sources");
    d.targets = value.at("targets");
    if(const Json_value* const avoided = value.find("faces_to_avoid"))
      d.set_faces_to_avoid(*avoided);
    if(const Json_value* const avoided = value.find("edges_to_avoid"))
      d.set_edges_to_avoid(*avoided);
    const std::string hash = d.hash();
    if(!value.at("hash").is_text(hash) || (m_is_open && !is_same(d, hash)))
      Json_value::complain("its hash does not fit its contents");
    // Later readings find the same description, or an error: threads read it without the mutex.
    if(!m_is_open)
      describe(d, hash);
    m_entries.clear();
    for(const Json_value& shard : value.at("shards").elements())
      m_entries.insert(entry_from_json(shard));
  }

  // Opens the folder.
  void describe(const Store_description& description, const std::string& hash)
  {
    m_description = description;
    m_hash = hash;
    m_is_open = true;
  }

  // Other processes add shards to the manifest, and nothing else changes in it.
  bool is_same(const Store_description& d, const std::string& hash) const
  {
    return hash == m_hash && d.mesh_hash == m_description.mesh_hash
        && d.layout.rows_per_shard == layout().rows_per_shard;
  }

  void read_manifest_if_changed()
  {
    if(state_of_manifest() != m_last_state)
      read_manifest();
  }

  // Does nothing if another process keeps the lock for longer than `wait`, or takes it over meanwhile. If the process
  // dies between the manifest and the removal of records, the next merge finds entries that it has already.
  void merge_records(std::chrono::milliseconds wait)
  {
    m_last_merge = std::chrono::steady_clock::now();
    if(!has_records()) // the folder may be one that can only be read
      return;
    Lock_file lock(manifest_lock(), wait);
    if(!lock.is_held())
      return;
    read_manifest();
    std::vector<std::filesystem::path> records;
    std::error_code error;
    for(const auto& each : std::filesystem::directory_iterator(m_path, error))
    {
      // Records that say nothing stay: they are the user's, or their shards are computed again and have new ones.
      std::pair<std::size_t, Shard_entry> found;
      lock.refresh();
      if(each.path().extension() != ".done" || !read_record(each.path(), found))
        continue;
      records.push_back(each.path());
      m_entries[found.first] = found.second;
    }
    if(records.empty() || !write_manifest(lock))
      return;
    for(const std::filesystem::path& record : records)
      std::filesystem::remove(record, error);
  }

  bool has_records() const
  {
    std::error_code error;
    for(const auto& each : std::filesystem::directory_iterator(m_path, error))
      if(each.path().extension() == ".done")
        return true;
    return false;
  }

  // Reads the record of a shard. Returns false if there is none, if it cannot be read, or if it belongs to another
  // matrix, which was in the folder before its manifest was removed: then the shard is computed, and has a new record.
  bool read_record(const std::filesystem::path& path, std::pair<std::size_t, Shard_entry>& found) const
  {
    const std::string text = text_of_file(path);
    if(text.empty())
      return false;
    try
    {
      const Json_value value = Json_reader(text).read();
      if(!value.at("mesh").is_text(m_description.mesh_hash) || !value.at("matrix").is_text(m_hash))
        return false;
      found = entry_from_json(value);
    }
    catch(const Geodesic_matrix_store_error&)
    {
      return false;
    }
    // Another name: a copy, or a file of the user.
    return path.filename() == layout().name(found.first) + ".done";
  }

  // The names of files are for people: they follow from the rows.
  Json_value to_json(std::size_t shard, const Shard_entry& entry) const
  {
    const std::vector<Shard_array> arrays = layout().arrays();
    std::vector<Json_value> files;
    for(std::size_t k = 0; k < arrays.size(); ++k)
    {
      Json_value file;
      file.add("name", layout().name(shard) + arrays[k].ending);
      file.add("elements", entry.arrays[k].first);
      file.add("checksum", entry.arrays[k].second);
      files.push_back(file);
    }
    Json_value value;
    value.add("rows", Json_value(std::vector<Json_value>{layout().first_row(shard), layout().end_row(shard)}));
    value.add("files", Json_value(std::move(files)));
    return value;
  }

  // Throws if the entry does not fit the layout: with wrong rows, it would hide that others are missing.
  std::pair<std::size_t, Shard_entry> entry_from_json(const Json_value& value) const
  {
    const std::vector<Json_value>& rows = value.at("rows").elements();
    // The first row tells which shard it is; both rows must be those of the layout.
    const std::size_t shard = rows.empty() ? 0 : rows[0].count() / layout().rows_per_shard;
    if(rows.size() != 2 || shard >= layout().number_of_shards() || rows[0].count() != layout().first_row(shard)
       || rows[1].count() != layout().end_row(shard))
      Json_value::complain("a shard does not fit the matrix");
    Shard_entry entry;
    std::vector<std::size_t> elements;
    for(const Json_value& file : value.at("files").elements())
    {
      entry.arrays.emplace_back(file.at("elements").count(), file.at("checksum").text());
      elements.push_back(entry.arrays.back().first);
    }
    if(!layout().may_have(shard, elements))
      Json_value::complain("a shard has other numbers of files or of elements than the matrix");
    return {shard, entry};
  }

  // What makes a file with the name manifest.json one of ours.
  static const char* format() { return "CGAL Surface_mesh_geodesics distance matrix"; }

  // What tells whether the manifest is another one: its time and its size.
  // Renaming another file into place changes at least one of them: manifests grow, or are made at another time.
  using State = std::pair<std::filesystem::file_time_type, std::uintmax_t>;
  State state_of_manifest() const
  {
    std::error_code error;
    const auto time = std::filesystem::last_write_time(manifest(), error);
    return {time, std::filesystem::file_size(manifest(), error)};
  }

  const std::filesystem::path m_path;
  mutable std::mutex m_mutex; // guards the members below
  // Both are constant after opening, so that they are read without the mutex. The hash takes time for the list of
  // sources, and each record has it.
  Store_description m_description;
  std::string m_hash;
  bool m_is_open = false;
  bool m_is_merging = true; // constant while threads use the object
  std::map<std::size_t, Shard_entry> m_entries;
  State m_last_state{};
  std::chrono::steady_clock::time_point m_last_merge = std::chrono::steady_clock::now();
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_MATRIX_STORE_STORE_FOLDER_H
