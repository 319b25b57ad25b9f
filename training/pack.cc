// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "training/pack.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <fstream>

#include "core/check.h"

namespace yorb {
namespace {

constexpr std::array<char, 8> kMagic{'Y', 'O', 'R', 'B', 'P', 'K', '0', '1'};

struct Header {
  std::array<char, 8> magic = kMagic;
  uint64_t index_offset = 0;  // 0 until the file is whole
  uint64_t num_pictures = 0, num_boxes = 0, num_names = 0, names_bytes = 0;
};

struct Entry {
  uint64_t offset = 0;
  uint32_t first_box = 0, num_boxes = 0;
  uint16_t width = 0, height = 0;
  uint32_t is_squashed = 0;
  std::array<uint64_t, 2> judged{};
};

static_assert(sizeof(LabelBox) == 20 && sizeof(Entry) == 40);

std::array<uint64_t, 2> ToWords(const ClassBits& bits) {
  std::array<uint64_t, 2> words{};
  for (size_t i = 0; i < bits.size(); ++i) words[i / 64] |= static_cast<uint64_t>(bits[i]) << (i % 64);
  return words;
}

ClassBits FromWords(const std::array<uint64_t, 2>& words) {
  ClassBits bits;
  for (size_t i = 0; i < bits.size(); ++i) bits[i] = (words[i / 64] >> (i % 64)) & 1;
  return bits;
}

template <typename T>
void WriteAll(std::ofstream& file, const std::vector<T>& values) {
  file.write(reinterpret_cast<const char*>(values.data()), static_cast<std::streamsize>(values.size() * sizeof(T)));
}

}  // namespace

struct PackWriter::State {
  std::string path;
  std::ofstream file;
  std::vector<std::string> names;
  std::vector<Entry> entries;
  std::vector<LabelBox> boxes;
  uint64_t offset = sizeof(Header);
};

PackWriter::PackWriter(std::unique_ptr<State> state) : state_(std::move(state)) {}
PackWriter::~PackWriter() = default;

Result<std::unique_ptr<PackWriter>> PackWriter::Create(const std::string& path, std::vector<std::string> class_names) {
  auto state = std::make_unique<State>();
  state->path = path;
  state->names = std::move(class_names);
  state->file.open(path, std::ios::binary | std::ios::trunc);
  const Header header;
  state->file.write(reinterpret_cast<const char*>(&header), sizeof(header));
  if (!state->file) return Failure(path + ": cannot be written");
  return std::unique_ptr<PackWriter>(new PackWriter(std::move(state)));
}

Status PackWriter::Add(const PackItem& item) {
  const cv::Mat pixels = item.pixels.isContinuous() ? item.pixels : item.pixels.clone();
  const size_t bytes = pixels.total() * 3;
  YORB_CHECK(pixels.type() == CV_8UC3, "a pack holds colour pictures of 8 bits");
  state_->entries.push_back({.offset = state_->offset,
                             .first_box = static_cast<uint32_t>(state_->boxes.size()),
                             .num_boxes = static_cast<uint32_t>(item.boxes.size()),
                             .width = static_cast<uint16_t>(pixels.cols),
                             .height = static_cast<uint16_t>(pixels.rows),
                             .is_squashed = item.is_squashed,
                             .judged = ToWords(item.judged)});
  state_->boxes.insert(state_->boxes.end(), item.boxes.begin(), item.boxes.end());
  state_->file.write(reinterpret_cast<const char*>(pixels.data), static_cast<std::streamsize>(bytes));
  state_->offset += bytes;
  return state_->file ? Status::Ok() : Failure(state_->path + ": cannot be written; is the disk full?");
}

Status PackWriter::Finish() {
  std::vector<char> names;
  for (const std::string& name : state_->names) names.insert(names.end(), name.c_str(), name.c_str() + name.size() + 1);
  const std::vector<char> padding((8 - state_->offset % 8) % 8);
  const Header header{.index_offset = state_->offset + padding.size(),
                      .num_pictures = state_->entries.size(),
                      .num_boxes = state_->boxes.size(),
                      .num_names = state_->names.size(),
                      .names_bytes = names.size()};
  WriteAll(state_->file, padding);
  WriteAll(state_->file, state_->entries);
  WriteAll(state_->file, state_->boxes);
  WriteAll(state_->file, names);
  state_->file.seekp(0);
  state_->file.write(reinterpret_cast<const char*>(&header), sizeof(header));
  state_->file.close();
  return state_->file ? Status::Ok() : Failure(state_->path + ": cannot be written; is the disk full?");
}

struct Pack::State {
  ~State() {
    if (data != nullptr) ::munmap(data, bytes);
  }
  char* data = nullptr;
  size_t bytes = 0;
  Header header;
  const Entry* entries = nullptr;
  const LabelBox* boxes = nullptr;
  std::vector<std::string> names;
};

Pack::Pack(std::unique_ptr<State> state) : state_(std::move(state)) {}
Pack::~Pack() = default;

Result<std::shared_ptr<const Pack>> Pack::Open(const std::string& path) {
  auto state = std::make_unique<State>();
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  struct stat info {};
  if (file < 0 || ::fstat(file, &info) != 0 || !S_ISREG(info.st_mode)) {
    if (file >= 0) ::close(file);
    return BadInput(path + ": cannot be read; `yorb-train pack` makes it");
  }
  state->bytes = static_cast<size_t>(info.st_size);
  void* data = state->bytes == 0 ? MAP_FAILED : ::mmap(nullptr, state->bytes, PROT_READ, MAP_PRIVATE, file, 0);
  ::close(file);
  if (data != MAP_FAILED) state->data = static_cast<char*>(data);
  Header& header = state->header;
  if (state->bytes >= sizeof(Header)) std::memcpy(&header, state->data, sizeof(Header));
  const uint64_t index_bytes =
      header.num_pictures * sizeof(Entry) + header.num_boxes * sizeof(LabelBox) + header.names_bytes;
  if (state->bytes < sizeof(Header) || header.magic != kMagic || header.index_offset == 0 ||
      header.index_offset + index_bytes != state->bytes || header.num_pictures == 0)
    return BadInput(path + ": is no whole pack of pictures; make it anew with `yorb-train pack`");
  state->entries = reinterpret_cast<const Entry*>(state->data + header.index_offset);
  state->boxes = reinterpret_cast<const LabelBox*>(state->entries + header.num_pictures);
  const char* name = reinterpret_cast<const char*>(state->boxes + header.num_boxes);
  for (uint64_t i = 0; i < header.num_names; ++i) {
    state->names.emplace_back(name);
    name += state->names.back().size() + 1;
  }
  return std::shared_ptr<const Pack>(new Pack(std::move(state)));
}

size_t Pack::size() const { return state_->header.num_pictures; }
const std::vector<std::string>& Pack::class_names() const { return state_->names; }

PackedPicture Pack::Get(size_t index) const {
  YORB_CHECK(index < size(), "a picture beyond the end of its pack");
  const Entry& entry = state_->entries[index];
  PackedPicture picture;
  picture.pixels = cv::Mat(entry.height, entry.width, CV_8UC3, state_->data + entry.offset);
  picture.boxes.assign(state_->boxes + entry.first_box, state_->boxes + entry.first_box + entry.num_boxes);
  picture.judged = FromWords(entry.judged);
  picture.is_squashed = entry.is_squashed != 0;
  return picture;
}

}  // namespace yorb
