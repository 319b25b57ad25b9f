// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "map/map_file.h"

#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <unordered_set>
#include <utility>

#include "map/chunk_file.h"
#include "map/frame_setup.h"
#include "map/map_rows.h"

namespace yorb {
namespace {

// No text editor, and no transfer that changes line ends, leaves this as it is.
constexpr char kMagic[] = "\x89YMAP\r\n\x1a";
constexpr ChunkFileKind kKind{kMagic, kMapFileVersion, "map"};
constexpr size_t kRowsPerChunk = 4096;
constexpr uint32_t kMostFrames = 1u << 31;  // so that those of later runs have ids, too

/// What the head of a file promises.
struct Head {
  uint64_t num_keyframes = 0, num_landmarks = 0, num_loops = 0;
  KeyframeId next_keyframe;
  LandmarkId next_landmark;
  MapFacts facts;
};

std::string HeadBytes(const Map& map, const MapFacts& facts) {
  ByteWriter bytes;
  bytes.Put(static_cast<uint64_t>(map.num_keyframes()));
  bytes.Put(static_cast<uint64_t>(map.num_landmarks()));
  bytes.Put(map.next_keyframe().value());
  bytes.Put(map.next_landmark().value());
  bytes.Put(static_cast<uint64_t>(map.num_loops()));
  bytes.PutText(facts.vocabulary);
  return bytes.bytes();
}

std::optional<Head> ReadHead(const std::string& content) {
  ByteReader bytes(content);
  Head head;
  head.num_keyframes = bytes.Get<uint64_t>();
  head.num_landmarks = bytes.Get<uint64_t>();
  head.next_keyframe = KeyframeId(bytes.Get<uint32_t>());
  head.next_landmark = LandmarkId(bytes.Get<uint32_t>());
  head.num_loops = bytes.Get<uint64_t>();
  head.facts.vocabulary = bytes.GetText();
  if (!bytes.IsReadWhole()) return std::nullopt;
  return head;
}

std::string RootsBytes(const std::vector<KeyframeId>& roots) {
  ByteWriter bytes;
  for (const KeyframeId root : roots) bytes.Put(root.value());
  return bytes.bytes();
}

std::vector<KeyframeId> RootsOf(const std::string& content) {
  ByteReader bytes(content);
  std::vector<KeyframeId> roots;
  for (const uint32_t id : bytes.GetRow<uint32_t>(content.size() / sizeof(uint32_t))) roots.emplace_back(id);
  return bytes.IsReadWhole() ? roots : std::vector<KeyframeId>();
}

/// Whether each sub-map of a map is named once.
bool AreAllRoots(const Map& map, const std::vector<KeyframeId>& roots) {
  std::unordered_set<KeyframeId> left(roots.begin(), roots.end());
  if (left.size() != roots.size()) return false;
  bool are_known = true;
  map.VisitKeyframes([&](const Keyframe& keyframe) {
    if (keyframe.root == keyframe.id) are_known = left.erase(keyframe.id) == 1 && are_known;
  });
  return are_known && left.empty();
}

/// Writes the chunks; the first failure ends it.
class MapWriter {
 public:
  explicit MapWriter(ChunkFileWriter file) : file_(std::move(file)) {}

  Status Write(const Map& map, const MapFacts& facts) {
    Add("HEAD", HeadBytes(map, facts));
    FrameSetups setups;
    map.VisitKeyframes([&](const Keyframe& keyframe) { setups.IndexOf(*keyframe.frame); });
    Add("CAMS", setups.Bytes());
    map.VisitKeyframes([&](const Keyframe& keyframe) {
      if (status_) Add("KEYF", KeyframeBytes(keyframe, setups.IndexOf(*keyframe.frame)));
    });
    ByteWriter gone;
    for (const RemovedKeyframe& removed : MapAssembly::Removed(map)) PutRemoved(removed, gone);
    Add("GONE", gone.bytes());
    AddLandmarks(map);
    if (facts.roots.size() > 1) Add("ROOT", RootsBytes(facts.roots));
    return status_ ? file_.Commit() : status_;
  }

 private:
  void Add(const char* name, const std::string& content) {
    if (status_) status_ = file_.Add(name, content);
  }

  void AddLandmarks(const Map& map) {
    ByteWriter rows;
    size_t num_rows = 0;
    map.VisitLandmarks([&](const Landmark& landmark) {
      PutLandmark(landmark, rows);
      if (++num_rows < kRowsPerChunk) return;
      Add("LAND", rows.bytes());
      rows = {};
      num_rows = 0;
    });
    if (num_rows > 0) Add("LAND", rows.bytes());
  }

  ChunkFileWriter file_;
  Status status_;
};

/// Reads the chunks in the order in which they are written.
class MapReader {
 public:
  explicit MapReader(ChunkFileReader file) : file_(std::move(file)) {}

  Result<SavedMap> Read() {
    for (auto chunk = file_.Next(); !chunk || *chunk; chunk = file_.Next()) {
      if (!chunk) return chunk.error();
      if (!Take(**chunk)) return file_.Damaged("a part '" + (*chunk)->name + "' holds what cannot be");
    }
    const std::string missing = WhatIsMissing();
    if (!missing.empty()) return file_.Damaged(missing);
    parts_.next_keyframe = head_->next_keyframe;
    parts_.next_landmark = head_->next_landmark;
    parts_.num_loops = head_->num_loops;
    auto map = MapAssembly::Make(std::move(parts_));
    if (!map) return file_.Damaged(map.error().message);
    if (!head_->facts.roots.empty() && !AreAllRoots(*map, head_->facts.roots)) {
      return file_.Damaged("its list of sub-maps does not fit");
    }
    return SavedMap{*std::move(map), head_->facts, file_.num_bytes()};
  }

 private:
  bool Take(const Chunk& chunk) {
    if (chunk.name == "HEAD") return !head_ && (head_ = ReadHead(chunk.content));
    if (chunk.name == "CAMS") return !setups_ && (setups_ = ReadFrameSetups(chunk.content));
    if (!head_ || !setups_) return false;
    if (chunk.name == "KEYF") return TakeKeyframe(chunk.content);
    if (chunk.name == "GONE") return Append(ReadRemoved(chunk.content), parts_.removed);
    if (chunk.name == "ROOT") return TakeRoots(chunk.content);
    return chunk.name == "LAND" && Append(ReadLandmarks(chunk.content), parts_.landmarks);
  }

  bool TakeRoots(const std::string& content) {
    if (!head_->facts.roots.empty()) return false;
    head_->facts.roots = RootsOf(content);
    return !head_->facts.roots.empty();
  }

  bool TakeKeyframe(const std::string& content) {
    auto keyframe = ReadKeyframe(content, *setups_);
    if (!keyframe || keyframe->frame->id.value() >= kMostFrames) return false;
    if (!frames_.insert(keyframe->frame->id).second) return false;
    parts_.keyframes.push_back(*std::move(keyframe));
    return true;
  }

  template <typename Row>
  static bool Append(std::optional<std::vector<Row>> rows, std::vector<Row>& all) {
    if (!rows) return false;
    all.insert(all.end(), std::make_move_iterator(rows->begin()), std::make_move_iterator(rows->end()));
    return true;
  }

  std::string WhatIsMissing() const {
    if (!head_ || !setups_) return "its head is missing";
    if (parts_.keyframes.size() != head_->num_keyframes) return "keyframes are missing";
    return parts_.landmarks.size() != head_->num_landmarks ? "landmarks are missing" : "";
  }

  ChunkFileReader file_;
  std::optional<Head> head_;
  std::optional<std::vector<FrameSetup>> setups_;
  std::unordered_set<FrameId> frames_;
  MapParts parts_;
};

/// Whether what lies there may be replaced by a map: a map, or an empty file.
bool IsReplaceable(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  char start[sizeof(kMagic) - 1];
  file.read(start, sizeof(start));
  return file.gcount() == 0 || (file.gcount() == sizeof(start) && std::memcmp(start, kMagic, sizeof(start)) == 0);
}

/// Whether a path can only be a folder's, there or not: it ends in a slash or a dot.
bool IsFolderName(const std::string& path) {
  const std::filesystem::path name = std::filesystem::path(path).filename();
  return name.empty() || name == "." || name == "..";
}

}  // namespace

Result<SavedMap> ReadMapFile(const std::string& path) {
  auto file = ChunkFileReader::Open(path, kKind);
  if (!file) return file.error();
  return MapReader(*std::move(file)).Read();
}

Result<Rig> ReadMapCamera(const std::string& path) {
  auto file = ChunkFileReader::Open(path, kKind);
  if (!file) return file.error();
  for (auto chunk = file->Next(); !chunk || *chunk; chunk = file->Next()) {
    if (!chunk) return chunk.error();
    if ((*chunk)->name != "CAMS") continue;
    const auto setups = ReadFrameSetups((*chunk)->content);
    if (!setups) return file->Damaged("a part 'CAMS' holds what cannot be");
    if (!setups->empty()) return *setups->back().rig;
  }
  return BadInput(path + " holds no keyframe; make the map anew");
}

Status WriteMapFile(const std::string& path, const Map& map, const MapFacts& facts) {
  auto file = ChunkFileWriter::Open(path, kKind);
  if (!file) return file.error();
  return MapWriter(*std::move(file)).Write(map, facts);
}

Status CheckMapTarget(const std::string& path) {
  std::error_code error;
  if (IsFolderName(path) || std::filesystem::is_directory(path, error)) {
    return BadInput(path + " is a folder, no place for a map file; name a file in it, such as " +
                    (std::filesystem::path(path) / "my.map").string());
  }
  if (std::filesystem::is_regular_file(path, error)) {
    if (::access(path.c_str(), W_OK) != 0) return BadInput(path + " is write-protected; name another file for the map");
    if (!IsReplaceable(path)) return BadInput(path + " is there and no map of this program; name another file");
  }
  const auto draft = FileDraft::Open(path);  // let go at once
  if (draft) return Status::Ok();
  return BadInput("no map can be written there: " + draft.error().message);
}

}  // namespace yorb
