// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "core/check.h"
#include "core/id.h"

namespace yorb {

/// Rows named by dense ids, kept in pages that copies of the table share. Copying costs a pointer a page; the writer
/// clones a page on its first write after a copy was taken. Which pages it may write is judged by a generation number
/// of its own, not by `use_count()`, which races with readers that let go.
template <typename T>
class PagedTable {
 public:
  PagedTable() = default;

  /// A copy to be read; the original goes on as the one to be written.
  PagedTable Share() {
    ++generation_;
    return *this;
  }

  /// The next id, with `row` behind it.
  Id<T> Add(T row) {
    const Id<T> id(next_++);
    if (PageOf(id) >= pages_.size()) pages_.resize(PageOf(id) + 1);
    Page& page = WritablePage(id);
    page.rows[SlotOf(id)].emplace(std::move(row));
    ++page.count;
    ++size_;
    return id;
  }

  /// The ids below `next` that were not given yet never will be: the next row has this one.
  void SkipTo(Id<T> next) {
    YORB_CHECK(next.value() >= next_, "ids are never used again");
    next_ = next.value();
  }

  /// The row, or null where it was removed or never was.
  const T* Find(Id<T> id) const {
    if (!id.IsValid() || PageOf(id) >= pages_.size()) return nullptr;
    const auto& page = pages_[PageOf(id)];
    if (!page) return nullptr;
    const auto& row = page->rows[SlotOf(id)];
    return row ? &*row : nullptr;
  }

  /// The row to be written; it must be there.
  T& Writable(Id<T> id) {
    YORB_CHECK(Find(id) != nullptr, "a row that is written must be there");
    return *WritablePage(id).rows[SlotOf(id)];
  }

  /// Takes the row out; its id is never used again. A page without rows is given back.
  void Remove(Id<T> id) {
    YORB_CHECK(Find(id) != nullptr, "a row that is removed must be there");
    Page& page = WritablePage(id);
    page.rows[SlotOf(id)].reset();
    --size_;
    if (--page.count == 0 && PageOf(id) + 1 < pages_.size()) pages_[PageOf(id)] = nullptr;
  }

  /// Calls `visit(row)` for each row by ascending id.
  template <typename Visitor>
  void Visit(Visitor&& visit) const {
    for (const auto& page : pages_) {
      if (!page) continue;
      for (const auto& row : page->rows) {
        if (row) visit(*row);
      }
    }
  }

  size_t size() const { return size_; }

  /// The id that the next row will have.
  Id<T> next_id() const { return Id<T>(next_); }

 private:
  static constexpr size_t kRowsPerPage = 64;
  struct Page {
    uint64_t generation;
    size_t count;
    std::array<std::optional<T>, kRowsPerPage> rows;
  };

  static size_t PageOf(Id<T> id) { return id.value() / kRowsPerPage; }
  static size_t SlotOf(Id<T> id) { return id.value() % kRowsPerPage; }

  Page& WritablePage(Id<T> id) {
    std::shared_ptr<Page>& page = pages_[PageOf(id)];
    if (!page) page = std::make_shared<Page>(Page{generation_, 0, {}});
    if (page->generation != generation_) {
      page = std::make_shared<Page>(*page);
      page->generation = generation_;
    }
    return *page;
  }

  std::vector<std::shared_ptr<Page>> pages_;
  uint64_t generation_ = 0;
  uint32_t next_ = 0;
  size_t size_ = 0;
};

}  // namespace yorb
