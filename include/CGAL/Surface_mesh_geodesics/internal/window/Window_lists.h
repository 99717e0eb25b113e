// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_WINDOW_LISTS_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_WINDOW_LISTS_H

// The window lists of the wavefront (thesis, 3.3.2.1, definition 3.1): for each halfedge the windows that wait to enter
// its face, sorted by key.
//
// A list is a block of a pool, with a column for each field of its windows, because loops process several windows at a
// time (simd.h). Blocks hold 8, 16, 32, ... windows, and released blocks are used again. So the pool never allocates
// single windows, a list is read in one sweep, and the memory is that of the widest wavefront.
//
// Invariants of a stored list, from Window_pool::add() to Window_lists::take(): it is not empty, is_sorted_by_key(),
// and its windows are valid (Window.h). While it is pruned, windows may be empty; while it is split, it does not
// change.
//
// Invariants of the memory: each block has one owner, a list or the pool; all rows of a slab are initialized, so that
// the rows behind a list hold numbers whatever they mean; all columns are aligned (Window_pool::aligned()).

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/bit_counting.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/memory_hints.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Window.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/simd.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// The columns of a block. Each has `padding` more rows than its capacity, because loops over lanes and copies read and
// write all lanes of their last step.
//
// A value of this type refers to a block and does not own it. Its functions are const in the sense of a pointer: they
// change windows, not the block. Row i of all columns together is window i.
//
// The columns of numbers lie one behind the other from `numbers` on, `height` rows each, and so do those of words. A
// value without a block has the height 0.
template <typename FT>
struct Window_columns
{
  static constexpr std::size_t number_of_numbers = 7;
  static constexpr std::size_t number_of_words = 2;
  static constexpr std::size_t step = 4; // windows that are copied at a time
  // The largest number of lanes of any instruction set, so that blocks do not depend on the flags of the compilation.
  static constexpr std::size_t padding = 8;

  FT* numbers = nullptr;
  std::uint64_t* words = nullptr;
  std::size_t height = 0;

  FT* begin() const { return numbers; }
  FT* end() const { return numbers + height; }
  FT* image_x() const { return numbers + 2 * height; }
  FT* image_depth() const { return numbers + 3 * height; }
  FT* begin_distance() const { return numbers + 4 * height; }
  FT* end_distance() const { return numbers + 5 * height; }
  FT* root_distance() const { return numbers + 6 * height; }
  Window_key* key() const { return words; }
  Window_history* history() const { return words + height; }

  Window<FT> get(std::size_t i) const
  {
    Window<FT> w;
    w.begin = begin()[i];
    w.end = end()[i];
    w.image_x = image_x()[i];
    w.image_depth = image_depth()[i];
    w.begin_distance = begin_distance()[i];
    w.end_distance = end_distance()[i];
    w.root_distance = root_distance()[i];
    w.key = key()[i];
    w.set_history(history()[i]);
    return w;
  }

  void set(std::size_t i, const Window<FT>& w) const
  {
    begin()[i] = w.begin;
    end()[i] = w.end;
    image_x()[i] = w.image_x;
    image_depth()[i] = w.image_depth;
    begin_distance()[i] = w.begin_distance;
    end_distance()[i] = w.end_distance;
    root_distance()[i] = w.root_distance;
    key()[i] = w.key;
    history()[i] = w.history();
  }

  void copy_row(std::size_t from, std::size_t to) const { set(to, get(from)); }

  // Copies the windows [first, last) of another block to the rows from i on, and the rows behind them up to a full
  // step: the padding of both blocks holds these.
  void copy(const Window_columns& from, std::size_t first, std::size_t last, std::size_t i) const
  {
    for(; first < last; first += step, i += step)
      copy_step(from, first, i);
  }

  // Moves the windows [first, last) to the rows from i on, and no others: rows behind them may still be in use.
  // Requires: i < first.
  void move_down(std::size_t first, std::size_t last, std::size_t i) const
  {
    for(; first + step <= last; first += step, i += step)
      copy_step(*this, first, i);
    for(; first < last; ++first, ++i)
      set(i, get(first));
  }

private:
  // Copies the rows first .. first + step - 1 of another block, or of this one, to the rows from i on.
  // (All rows of a step are read before any is written, so that the two ranges may overlap.)
  void copy_step(const Window_columns& from, std::size_t first, std::size_t i) const
  {
    copy_step(from.begin() + first, begin() + i);
    copy_step(from.end() + first, end() + i);
    copy_step(from.image_x() + first, image_x() + i);
    copy_step(from.image_depth() + first, image_depth() + i);
    copy_step(from.begin_distance() + first, begin_distance() + i);
    copy_step(from.end_distance() + first, end_distance() + i);
    copy_step(from.root_distance() + first, root_distance() + i);
    copy_step(from.key() + first, key() + i);
    copy_step(from.history() + first, history() + i);
  }

  template <typename T>
  static void copy_step(const T* from, T* to)
  {
    const std::array<T, step> rows{from[0], from[1], from[2], from[3]};
    std::copy(rows.begin(), rows.end(), to);
  }
};

// A list of windows sorted by key, in a block of the pool, or an empty list without a block. A copy refers to the same
// block; only one of the two may go back to the pool.
template <typename FT>
struct Window_list
{
  Window_columns<FT> columns;
  std::uint32_t size = 0;
  std::uint32_t size_class = 0;
  std::uint32_t steps = 0; // joined_steps() of the windows, or a bound of it

  std::uint32_t number_of_faces_crossed() const { return steps / 2; }
  bool may_be_marked() const { return (steps & 1) != 0; }

  std::size_t capacity() const
  {
    return columns.height == 0 ? 0 : std::size_t(8) << size_class;
  }
};

// Are the windows of a list in the order of their keys, within its capacity, and do its `steps` bound theirs?
template <typename FT>
bool is_sorted_by_key(const Window_list<FT>& list)
{
  if(list.size > list.capacity())
    return false;
  for(std::size_t i = 0; i < list.size; ++i)
  {
    const Window<FT> w = list.columns.get(i);
    if((i > 0 && w.key < list.columns.key()[i - 1]) || w.number_of_faces_crossed() > list.number_of_faces_crossed()
       || (w.is_marked() && !list.may_be_marked()))
      return false;
  }
  return true;
}

// Does a list on an edge of the given length satisfy the invariants of a stored list? It is sorted by key, and each of
// its windows is valid.
template <typename FT>
bool is_valid(const Window_list<FT>& list, const FT& length)
{
  for(std::size_t i = 0; i < list.size; ++i)
    if(!is_valid(list.columns.get(i), length))
      return false;
  return is_sorted_by_key(list);
}

// The memory of lists: slabs of rows, cut into blocks of 8, 16, 32, ... rows (size classes 0, 1, 2, ...) and padding.
// Released blocks wait in one stack for each class. No slab is freed before clear(). All operations take time linear in
// the number of windows that they move, amortized. An object must not be used by two threads at the same time; a list
// may be released to another pool than its own, as long as both live until all lists are gone.
template <typename FT>
class Window_pool
{
public:
  using List = Window_list<FT>;
  using Columns = Window_columns<FT>;

  // Makes an empty list with a capacity of n windows at least. Its rows hold what the last list of the block has left.
  // Requires: n > 0.
  List allocate(std::size_t n)
  {
    List list;
    list.size_class = size_class_for(n);
    std::vector<Columns>& free_blocks = m_free_blocks[list.size_class];
    if(free_blocks.empty())
      list.columns = new_block(list.size_class);
    else
    {
      list.columns = free_blocks.back();
      free_blocks.pop_back();
    }
    return list;
  }

  // Releases the block of a list. The list is empty afterward.
  void release(List& list)
  {
    if(list.columns.height != 0)
      m_free_blocks[list.size_class].push_back(list.columns);
    list = List();
  }

  // Reserves capacity for n more windows behind those of a list. add() makes them part of the list. The list moves to a
  // larger block if it has to; then its columns change, and copies of the list refer to a block that is free.
  // Requires: n > 0.
  void reserve(List& list, std::size_t n)
  {
    if(list.columns.height == 0)
    {
      list = allocate(n);
      return;
    }
    if(list.size + n <= list.capacity())
      return;
    List larger = allocate(list.size + n);
    larger.columns.copy(list.columns, 0, list.size, 0);
    replace(list, larger);
  }

  // Merges the first n windows in the spare capacity behind a list with the list. Marks those whose key the list has
  // already. A list that stays empty releases its block.
  // Requires: the n windows are sorted by key, and `steps` are their joined_steps(). n may be 0.
  void add(List& list, std::size_t n, std::uint32_t steps)
  {
    if(n == 0)
    {
      if(list.size == 0)
        release(list);
      return;
    }
    const std::size_t middle = list.size;
    list.size += static_cast<std::uint32_t>(n);
    list.steps = joined_steps(list.steps, steps);
    const Window_key* const key = list.columns.key();
    CGAL_expensive_assertion(list.size <= list.capacity() && std::is_sorted(key + middle, key + list.size));
    if(middle > 0 && !(key[middle - 1] < key[middle])) // otherwise the list is sorted as it is
      merge(list, middle);
    CGAL_expensive_assertion(is_sorted_by_key(list));
  }

  // Moves the windows of another list, which came later, into a list. Linear in the sizes of both.
  void join(List& list, List& other)
  {
    reserve(list, other.size);
    list.columns.copy(other.columns, 0, other.size, list.size);
    add(list, other.size, other.steps);
    release(other);
  }

  // Releases all memory. Requires: no list has a block.
  void clear()
  {
    m_numbers.clear();
    m_words.clear();
    for(std::vector<Columns>& free_blocks : m_free_blocks)
      free_blocks.clear();
    m_slab = Columns();
    m_slab_rest = 0;
    m_number_of_rows = 0;
  }

  std::size_t memory() const
  {
    return m_number_of_rows
         * (Columns::number_of_numbers * sizeof(FT) + Columns::number_of_words * sizeof(std::uint64_t));
  }

private:
  // Moves a list into another block, which holds its windows already.
  void replace(List& list, List& other)
  {
    other.size = list.size;
    other.steps = list.steps;
    release(list);
    list = other;
  }

  // Merges the windows of a list before `middle` with those from there on, which came later; of equal keys the old ones
  // stay first. Copies runs, not single windows: in most lists, one part lies on the left of the other.
  //
  // A late window with the key of an old one is marked, as their order is not known (Window.h). Marks are set in the
  // lowest bit of the steps, which is one_step in the history.
  //
  // Invariant of the loop: the first n rows of `merged` are the old windows before `old` and the late ones before
  // `late`. Each copy may write up to three more rows; the next one writes over them, and the last one ends in the
  // padding. If an old window has the key of a late one, the last old one that is copied has it, as the old ones are
  // sorted.
  void merge(List& list, std::size_t middle)
  {
    List merged = allocate(list.size);
    const Columns& from = list.columns;
    const Columns& to = merged.columns;
    const Window_key* const key = from.key();
    std::size_t old = 0, late = middle, n = 0;
    while(late < list.size)
    {
      // The old windows up to the key of the next late one.
      const std::size_t old_end =
        std::size_t(std::upper_bound(key + old, key + middle, key[late]) - key);
      to.copy(from, old, old_end, n);
      n += old_end - old;
      old = old_end;
      // The late windows before the next old one: at least one.
      std::size_t late_end = old == middle ? list.size : late;
      while(late_end < list.size && key[late_end] < key[old])
        ++late_end;
      to.copy(from, late, late_end, n);
      for(; late < late_end; ++late, ++n)
        if(old > 0 && key[late] == key[old - 1])
        {
          to.history()[n] |= one_step;
          list.steps |= 1;
        }
    }
    to.copy(from, old, middle, n);
    replace(list, merged);
  }

  // The smallest class of blocks with a capacity of n windows: n - 1 has at most class + 3 bits. Requires: n > 0.
  static std::uint32_t size_class_for(std::size_t n)
  {
    return static_cast<std::uint32_t>(number_of_bits((n - 1) | 7) - 3);
  }

  // A slab serves several lists; larger blocks get a slab of their own.
  static constexpr std::size_t slab_rows = 1024;

  static std::size_t height(std::size_t size_class) { return (std::size_t(8) << size_class) + Columns::padding; }

  Columns new_block(std::size_t size_class)
  {
    const std::size_t rows = height(size_class);
    if(rows > slab_rows)
      return block(new_slab(rows), size_class);
    if(m_slab_rest < rows)
    {
      // The rest of the last slab becomes free blocks.
      for(std::size_t c = m_free_blocks.size(); c-- > 0;)
        while(m_slab_rest >= height(c))
          m_free_blocks[c].push_back(cut(c));
      m_slab = new_slab(slab_rows);
      m_slab_rest = slab_rows;
    }
    return cut(size_class);
  }

  // Cuts a block off the slab. Requires: the slab has that many rows left.
  Columns cut(std::size_t size_class)
  {
    const Columns columns = block(m_slab, size_class);
    m_slab.numbers += Columns::number_of_numbers * columns.height;
    m_slab.words += Columns::number_of_words * columns.height;
    m_slab_rest -= columns.height;
    return columns;
  }

  static Columns block(const Columns& slab, std::size_t size_class)
  {
    return Columns{slab.numbers, slab.words, height(size_class)};
  }

  // Initializes all rows, because loops over lanes read unused ones, too: these must hold numbers and an existing root.
  Columns new_slab(std::size_t rows)
  {
    m_numbers.emplace_back(new FT[Columns::number_of_numbers * rows + Columns::padding]());
    m_words.emplace_back(new std::uint64_t[Columns::number_of_words * rows + Columns::padding]());
    m_number_of_rows += rows;
    return Columns{aligned(m_numbers.back().get()), aligned(m_words.back().get()), 0};
  }

  // Vectors are loaded faster from addresses that are multiples of their size. Heights of blocks are multiples of
  // `padding` rows, so if a slab is aligned, all columns of its blocks are. (Numbers of other types have no vectors,
  // and there may be no such multiple.)
  template <typename T>
  static T* aligned(T* p)
  {
    while(std::is_arithmetic<T>::value && reinterpret_cast<std::uintptr_t>(p) % (Columns::padding * alignof(T)) != 0)
      ++p;
    return p;
  }

  std::vector<std::unique_ptr<FT[]>> m_numbers;
  std::vector<std::unique_ptr<std::uint64_t[]>> m_words;
  std::array<std::vector<Columns>, 32> m_free_blocks;
  Columns m_slab; // what is left of the last slab
  std::size_t m_slab_rest = 0;
  std::size_t m_number_of_rows = 0;
};

// What one thread needs to put lists aside and take them again: slots that are free, and how many windows it has put
// aside more than taken. Another thread may take what one has put aside, so only sums over all threads mean something.
struct Window_list_slots
{
  std::vector<std::uint32_t> free;
  std::ptrdiff_t number_of_windows = 0;
};

// The waiting lists, by halfedge. A table maps each halfedge to a slot; slots of taken lists are used again. So the
// table has four bytes for each halfedge of the mesh, and the lists take memory for the widest wavefront only.
//
// Threads that have slots of their own may take and put lists at the same time, as long as no two of them are concerned
// with the same halfedge: slots never move, and a lock guards the making of new ones.
//
// Invariant: each slot has a halfedge, of which it is the slot, and a list with windows; or it has neither, and is free
// in one Window_list_slots or in m_free_slots.
template <typename FT>
class Window_lists
{
public:
  using List = Window_list<FT>;

  explicit Window_lists(std::size_t number_of_faces) { resize(number_of_faces, 1); }

  // Removes all lists, gives their blocks to the pool, and prepares for a mesh with this number of faces. Linear in the
  // largest number of lists that have waited at the same time. Requires: `slots_of_threads` is a range of pointers to
  // the slots of all threads.
  template <typename RangeOfSlots>
  void restart(std::size_t number_of_faces, Window_pool<FT>& pool, const RangeOfSlots& slots_of_threads)
  {
    m_free_slots.clear();
    for(std::size_t slot = 0; slot < m_number_of_slots; ++slot)
    {
      Slot& s = at(static_cast<std::uint32_t>(slot));
      if(s.halfedge != null_id)
        m_slot_of_halfedge[dense_index(s.halfedge)] = null_id;
      s.halfedge = null_id;
      pool.release(s.list);
      m_free_slots.push_back(static_cast<std::uint32_t>(slot));
    }
    std::size_t number_of_threads = 0;
    for(Window_list_slots* own_slots : slots_of_threads)
    {
      *own_slots = Window_list_slots();
      ++number_of_threads;
    }
    resize(number_of_faces, number_of_threads);
  }

  bool has(Halfedge_id h) const { return m_slot_of_halfedge[dense_index(h)] != null_id; }

  // Moves the list of h to `list`. The slot stays with the thread of `slots`. Requires: has(h), and `list` has no
  // block.
  void take(Halfedge_id h, List& list, Window_list_slots& own_slots)
  {
    CGAL_assertion(has(h) && list.columns.height == 0);
    const std::uint32_t slot = m_slot_of_halfedge[dense_index(h)];
    own_slots.free.push_back(slot); // first: if it throws, nothing has changed
    m_slot_of_halfedge[dense_index(h)] = null_id;
    Slot& s = at(slot);
    list = s.list;
    s.list = List();
    s.halfedge = null_id;
    own_slots.number_of_windows -= static_cast<std::ptrdiff_t>(list.size);
  }

  // Moves a list to h, where it is merged with the list that waits already. Of windows with the same key, those of that
  // one come first. `pool` and `slots` are those of the calling thread. Requires: the list is not empty.
  void put(Halfedge_id h, List& list, Window_pool<FT>& pool, Window_list_slots& own_slots)
  {
    CGAL_assertion(list.size > 0);
    own_slots.number_of_windows += static_cast<std::ptrdiff_t>(list.size);
    const std::uint32_t occupied = m_slot_of_halfedge[dense_index(h)];
    if(occupied != null_id)
    {
      pool.join(at(occupied).list, list);
      return;
    }
    if(own_slots.free.empty())
      make_slots(own_slots);
    const std::uint32_t slot = own_slots.free.back();
    own_slots.free.pop_back();
    m_slot_of_halfedge[dense_index(h)] = slot;
    at(slot).halfedge = h;
    at(slot).list = list;
    list = List();
  }

  // Lets other threads use slots that a thread has too many of. Requires: no thread takes or puts lists meanwhile, as
  // this takes no lock.
  void share_surplus(Window_list_slots& own_slots)
  {
    if(own_slots.free.size() <= 2 * slots_in_chunk)
      return;
    m_free_slots.insert(m_free_slots.end(), own_slots.free.begin() + slots_in_chunk, own_slots.free.end());
    own_slots.free.resize(slots_in_chunk);
  }

  std::size_t memory() const { return m_number_of_slots * sizeof(Slot); }

  // The memory of the table, which has an entry for each halfedge of the mesh.
  std::size_t table_memory() const { return m_slot_of_halfedge.capacity() * sizeof(std::uint32_t); }

private:
  struct Slot
  {
    List list;
    Halfedge_id halfedge = null_id; // null_id if the slot is free
  };

  static constexpr std::size_t slots_in_chunk = 128;

  Slot& at(std::uint32_t slot) { return m_chunks[slot / slots_in_chunk][slot % slots_in_chunk]; }

  // Makes the table, and reserves as many chunks as can ever be needed: threads read the positions of chunks while
  // another one makes a chunk. Beside the slots in use, each thread has at most three chunks (share_surplus()).
  void resize(std::size_t number_of_faces, std::size_t number_of_threads)
  {
    reserve_large(m_slot_of_halfedge, 3 * number_of_faces);
    m_slot_of_halfedge.resize(3 * number_of_faces, null_id);
    const std::size_t n = 3 * number_of_faces / slots_in_chunk + 1 + 3 * number_of_threads;
    if(m_chunks.size() < n)
      m_chunks.resize(n);
  }

  // Gives a thread slots that are free.
  void make_slots(Window_list_slots& own_slots)
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    own_slots.free.reserve(slots_in_chunk); // what follows changes nothing if it throws
    if(m_free_slots.empty())
    {
      m_free_slots.reserve(slots_in_chunk);
      CGAL_assertion(m_number_of_slots / slots_in_chunk < m_chunks.size());
      m_chunks[m_number_of_slots / slots_in_chunk].reset(new Slot[slots_in_chunk]);
      for(std::size_t i = 0; i < slots_in_chunk; ++i)
        m_free_slots.push_back(static_cast<std::uint32_t>(m_number_of_slots++));
    }
    for(std::size_t i = 0; i < slots_in_chunk && !m_free_slots.empty(); ++i)
    {
      own_slots.free.push_back(m_free_slots.back());
      m_free_slots.pop_back();
    }
  }

  // By dense_index(): the slot, null_id if no list waits. Threads read and write different entries.
  std::vector<std::uint32_t> m_slot_of_halfedge;
  std::vector<std::unique_ptr<Slot[]>> m_chunks;
  std::size_t m_number_of_slots = 0;
  std::mutex m_mutex;                      // guards the members above, except the table, and m_free_slots
  std::vector<std::uint32_t> m_free_slots; // of no thread
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_WINDOW_LISTS_H
