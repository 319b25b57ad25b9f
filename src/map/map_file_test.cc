// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "map/map_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>

#include "map/chunk_file.h"
#include "map/map_rows.h"
#include "map/test_map.h"

namespace yorb {
namespace {

using testing::HasSubstr;

constexpr ChunkFileKind kKind{"\x89YMAP\r\n\x1a", kMapFileVersion, "map"};

class MapFile : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = testing::TempDir() + "map_file_" + std::to_string(::getpid()) + "/";
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string In(const std::string& name) const { return folder_ + name; }

  std::string Bytes(const std::string& path) const {
    std::ifstream file(path, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(file), {});
  }
  void Put(const std::string& path, const std::string& bytes) const { std::ofstream(path, std::ios::binary) << bytes; }

  /// A map of a few keyframes, written to "m.map".
  Map Written() const {
    Map map = LivedInMap(1, 8);
    EXPECT_TRUE(WriteMapFile(In("m.map"), map, {"words"}).ok());
    return map;
  }

  void ExpectRefused(const std::string& path, const std::string& word) const {
    const auto read = ReadMapFile(path);
    ASSERT_FALSE(read.ok()) << path;
    EXPECT_EQ(read.error().kind, Error::Kind::kBadInput);
    EXPECT_THAT(read.error().message, HasSubstr(path));
    EXPECT_THAT(read.error().message, HasSubstr(word));
  }

  std::vector<Chunk> Chunks(const std::string& path) const {
    auto file = *ChunkFileReader::Open(path, kKind);
    std::vector<Chunk> chunks;
    for (auto chunk = *file.Next(); chunk; chunk = *file.Next()) chunks.push_back(*chunk);
    return chunks;
  }
  void PutChunks(const std::string& path, const std::vector<Chunk>& chunks) const {
    auto file = *ChunkFileWriter::Open(path, kKind);
    for (const Chunk& chunk : chunks) ASSERT_TRUE(file.Add(chunk.name.c_str(), chunk.content).ok());
    ASSERT_TRUE(file.Commit().ok());
  }

  std::string folder_;
};

/// Equal to the bit, NaN included.
template <typename T>
bool SameBits(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

bool SameBits(const Rigid3& a, const Rigid3& b) {
  return a.rotation.coeffs() == b.rotation.coeffs() && a.translation == b.translation;
}

void ExpectSame(const Frame& a, const Frame& b) {
  EXPECT_EQ(a.id, b.id);
  EXPECT_EQ(a.timestamp, b.timestamp);
  EXPECT_TRUE(SameBits(a.keypoints, b.keypoints));
  EXPECT_TRUE(SameBits(a.points_px, b.points_px));
  EXPECT_TRUE(SameBits(a.depth, b.depth));
  EXPECT_TRUE(SameBits(a.right_px, b.right_px));
  EXPECT_EQ(a.descriptors, b.descriptors);
  FrameSetups setups;
  EXPECT_EQ(setups.IndexOf(a), setups.IndexOf(b)) << "camera, pyramid and bounds";
  std::vector<uint32_t> near_a, near_b;
  a.grid.VisitNear(300, 200, 80, [&](uint32_t i) { near_a.push_back(i); });
  b.grid.VisitNear(300, 200, 80, [&](uint32_t i) { near_b.push_back(i); });
  EXPECT_EQ(near_a, near_b);
}

void ExpectSame(const Keyframe& a, const Keyframe& b) {
  EXPECT_EQ(a.id, b.id);
  EXPECT_TRUE(SameBits(a.cam_from_world, b.cam_from_world));
  EXPECT_EQ(a.landmarks, b.landmarks);
  EXPECT_TRUE(SameBits(a.neighbours, b.neighbours));
  EXPECT_EQ(a.parent, b.parent);
  EXPECT_EQ(a.children, b.children);
  EXPECT_EQ(a.root, b.root);
  EXPECT_EQ(a.loops, b.loops);
  ExpectSame(*a.frame, *b.frame);
}

void ExpectSame(const Landmark& a, const Landmark& b) {
  EXPECT_EQ(a.id, b.id);
  EXPECT_EQ(a.position, b.position);
  EXPECT_EQ(a.view_direction, b.view_direction);
  EXPECT_EQ(a.min_distance, b.min_distance);
  EXPECT_EQ(a.max_distance, b.max_distance);
  EXPECT_EQ(a.descriptor, b.descriptor);
  EXPECT_EQ(a.reference, b.reference);
  EXPECT_EQ(a.first_keyframe, b.first_keyframe);
  EXPECT_EQ(a.num_visible, b.num_visible);
  EXPECT_EQ(a.num_found, b.num_found);
  EXPECT_TRUE(SameBits(a.views, b.views));
}

void ExpectSame(const Map& a, const Map& b) {
  ASSERT_EQ(a.num_keyframes(), b.num_keyframes());
  ASSERT_EQ(a.num_landmarks(), b.num_landmarks());
  EXPECT_EQ(a.next_keyframe(), b.next_keyframe());
  EXPECT_EQ(a.next_landmark(), b.next_landmark());
  EXPECT_EQ(a.newest_keyframe(), b.newest_keyframe());
  EXPECT_EQ(a.num_loops(), b.num_loops());
  a.VisitKeyframes([&](const Keyframe& keyframe) { ExpectSame(keyframe, *b.Find(keyframe.id)); });
  a.VisitLandmarks([&](const Landmark& landmark) { ExpectSame(landmark, *b.Find(landmark.id)); });
  for (uint32_t id = 0; id < a.next_keyframe().value(); ++id) {
    EXPECT_EQ(a.Surviving(KeyframeId(id)), b.Surviving(KeyframeId(id)));
    EXPECT_TRUE(SameBits(*a.CamFromWorld(KeyframeId(id)), *b.CamFromWorld(KeyframeId(id)))) << id;
  }
}

TEST_F(MapFile, GivesBackTheSameMapToTheBit) {
  const Map map = Written();
  ASSERT_GT(MapAssembly::Removed(map).size(), 1u);
  const auto read = ReadMapFile(In("m.map"));
  ASSERT_TRUE(read.ok()) << read.error().message;
  EXPECT_EQ(read->map.Check(), "");
  ExpectSame(map, read->map);
  EXPECT_EQ(read->map.num_loops(), 1u);
  EXPECT_EQ(read->facts.vocabulary, "words");
  EXPECT_EQ(read->num_bytes, std::filesystem::file_size(In("m.map")));
  ASSERT_TRUE(WriteMapFile(In("again.map"), read->map, read->facts).ok());
  EXPECT_EQ(Bytes(In("again.map")), Bytes(In("m.map")));
}

TEST_F(MapFile, HoldsAMapOfManyPagesAndAnEmptyOne) {
  const Map map = LivedInMap(6, 20);
  ASSERT_TRUE(WriteMapFile(In("large.map"), map, {}).ok());
  ExpectSame(map, ReadMapFile(In("large.map"))->map);
  ASSERT_TRUE(WriteMapFile(In("empty.map"), Map(), {}).ok());
  EXPECT_EQ(ReadMapFile(In("empty.map"))->map.num_keyframes(), 0u);
}

TEST_F(MapFile, AMapThatWasReadGoesOnWithNewIds) {
  const Map before = Written();
  const SavedMap read = *ReadMapFile(In("m.map"));
  Map map = Map::Continuing(read.map);
  const auto view = SyntheticWorld(1).Look(Rigid3::Identity(), FrameId(1000), Timestamp{1});
  const KeyframeId added = map.AddKeyframe(view.frame, Rigid3::Identity(), map.newest_keyframe());
  EXPECT_EQ(added, before.next_keyframe());
  EXPECT_EQ(map.AddLandmark({0, 0, 2}, added, 0), before.next_landmark());
  const KeyframeId moved = before.newest_keyframe();
  map.SetPose(moved, Rigid3(Eigen::Quaterniond::Identity(), {9, 9, 9}));
  EXPECT_EQ(map.Check(), "");
  ExpectSame(before, read.map);  // what is continued is a copy
}

TEST_F(MapFile, RefusesWhatIsNoMapByName) {
  Written();
  const std::string good = Bytes(In("m.map"));
  ExpectRefused(In("missing.map"), "does not exist");
  ExpectRefused(folder_, "is a folder");
  ExpectRefused("/dev/null", "no regular file");
  Put(In("x.map"), "");
  ExpectRefused(In("x.map"), "is empty");
  Put(In("x.map"), "1305031102.1753 0.1 0.2 0.3 0 0 0 1\n");
  ExpectRefused(In("x.map"), "no map file");
  std::string newer = good;
  newer[8] = 9;
  Put(In("x.map"), newer);
  ExpectRefused(In("x.map"), "version 9");
  Put(In("x.map"), good + "more");
  ExpectRefused(In("x.map"), "damaged");
}

TEST_F(MapFile, RefusesEveryCutAndEveryChangedByte) {
  ASSERT_TRUE(WriteMapFile(In("m.map"), LivedInMap(1, 4), {}).ok());
  const std::string good = Bytes(In("m.map"));
  const size_t step = good.size() / 150;
  for (size_t at = 0; at < good.size(); at += at < 200 ? 1 : step) {
    Put(In("x.map"), good.substr(0, at));
    EXPECT_FALSE(ReadMapFile(In("x.map")).ok()) << "cut at " << at;
    std::string changed = good;
    changed[at] = static_cast<char>(changed[at] ^ 16);
    Put(In("x.map"), changed);
    EXPECT_FALSE(ReadMapFile(In("x.map")).ok()) << "changed at " << at;
  }
}

TEST_F(MapFile, RefusesMissingDoubledAndSwappedParts) {
  Written();
  const std::vector<Chunk> good = Chunks(In("m.map"));
  for (size_t i = 0; i < good.size(); ++i) {
    std::vector<Chunk> chunks = good;
    chunks.erase(chunks.begin() + static_cast<std::ptrdiff_t>(i));
    PutChunks(In("x.map"), chunks);
    EXPECT_FALSE(ReadMapFile(In("x.map")).ok()) << good[i].name << " is missing";
    chunks = good;
    chunks.insert(chunks.begin() + static_cast<std::ptrdiff_t>(i), good[i]);
    PutChunks(In("x.map"), chunks);
    EXPECT_FALSE(ReadMapFile(In("x.map")).ok()) << good[i].name << " is there twice";
  }
  std::vector<Chunk> chunks = good;
  std::swap(chunks[2], chunks[3]);
  PutChunks(In("x.map"), chunks);
  EXPECT_FALSE(ReadMapFile(In("x.map")).ok()) << "keyframes out of order";
}

/// Checksums that hold say nothing of the contents: those are made right again here after bytes were changed.
TEST_F(MapFile, WhatCannotBeIsRefusedWhereTheChecksumsHold) {
  ASSERT_TRUE(WriteMapFile(In("m.map"), LivedInMap(1, 4), {}).ok());
  const std::vector<Chunk> good = Chunks(In("m.map"));
  Random random(3);
  int num_refused = 0;
  constexpr int kTrials = 600;
  for (int trial = 0; trial < kTrials; ++trial) {
    std::vector<Chunk> chunks = good;
    std::string& content = chunks[random.Below(chunks.size())].content;
    if (content.empty()) continue;
    // Mostly near the start, where the counts and ids are.
    const size_t reach = trial % 3 == 0 ? content.size() : std::min<size_t>(content.size(), 130);
    content[random.Below(reach)] ^= static_cast<char>(1u << random.Below(8));
    if (trial % 7 == 0) content.resize(random.Below(content.size()));
    PutChunks(In("x.map"), chunks);
    const auto read = ReadMapFile(In("x.map"));
    num_refused += !read.ok();
    if (read) {
      EXPECT_EQ(read->map.Check(), "");
    }
  }
  EXPECT_GT(num_refused, kTrials / 4);
}

TEST_F(MapFile, PartsThatMakeNoMapAreNamed) {
  const auto why = [](const std::function<void(MapParts&)>& change) {
    MapParts parts = SyntheticMapParts(1, 4);
    change(parts);
    const auto map = MapAssembly::Make(std::move(parts));
    return map ? std::string("a map") : map.error().message;
  };
  EXPECT_EQ(why([](MapParts&) {}), "a map");
  EXPECT_THAT(why([](MapParts& p) { p.keyframes[1].landmarks[0] = LandmarkId(1u << 30); }), HasSubstr("not there"));
  EXPECT_THAT(why([](MapParts& p) { p.keyframes[1].landmarks[0] = p.keyframes[1].landmarks[1]; }), HasSubstr("twice"));
  EXPECT_THAT(why([](MapParts& p) { p.keyframes[2].parent = KeyframeId(3); }), HasSubstr("another parent"));
  EXPECT_THAT(why([](MapParts& p) { p.keyframes[2].loops = {KeyframeId(0)}; }), HasSubstr("loop"));
  EXPECT_THAT(why([](MapParts& p) {
                p.keyframes[0].children = {};
                p.keyframes[1].parent = KeyframeId(3);
                p.keyframes[3].children = {KeyframeId(1)};
              }),
              HasSubstr("another sub-map"))
      << "a ring hangs below no root";
  EXPECT_THAT(why([](MapParts& p) { p.keyframes[0].children.clear(); }), HasSubstr("children"));
  EXPECT_THAT(why([](MapParts& p) { p.keyframes[3].landmarks.pop_back(); }), HasSubstr("other keypoints"));
  EXPECT_THAT(why([](MapParts& p) { p.landmarks[5].reference = KeyframeId(); }), HasSubstr("reference"));
  EXPECT_THAT(why([](MapParts& p) { p.landmarks[5].first_keyframe = KeyframeId(99); }), HasSubstr("born"));
  EXPECT_THAT(why([](MapParts& p) { p.landmarks[5].position.x() = NAN; }), HasSubstr("nowhere"));
  EXPECT_THAT(why([](MapParts& p) { p.landmarks.pop_back(); }), HasSubstr("not there"));
  EXPECT_THAT(why([](MapParts& p) { p.next_landmark = LandmarkId(3); }), HasSubstr("ids"));
  EXPECT_THAT(why([](MapParts& p) { p.next_keyframe = KeyframeId(5); }), HasSubstr("all there"));
  EXPECT_THAT(why([](MapParts& p) {
                p.next_keyframe = KeyframeId(6);
                p.removed = {{KeyframeId(4), KeyframeId(5), {}}, {KeyframeId(5), KeyframeId(4), {}}};
              }),
              HasSubstr("follows itself"));
}

TEST_F(MapFile, AFullDiskLeavesTheOldFileWhole) {
  Written();
  const std::string old = Bytes(In("m.map"));
  rlimit was{};
  ::getrlimit(RLIMIT_FSIZE, &was);
  const rlimit little{old.size() / 2, was.rlim_max};
  std::signal(SIGXFSZ, SIG_IGN);
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &little), 0);
  const Status status = WriteMapFile(In("m.map"), LivedInMap(1, 8), {});
  ::setrlimit(RLIMIT_FSIZE, &was);
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().kind, Error::Kind::kFailure);
  EXPECT_THAT(status.error().message, HasSubstr("m.map"));
  EXPECT_EQ(Bytes(In("m.map")), old);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_), {}), 1) << "a draft is left";
}

TEST_F(MapFile, APlaceWhereNoMapCanBeIsRefusedBeforehand) {
  Written();
  Put(In("picture.png"), "\x89PNG\r\n\x1a\n and so on");
  Put(In("empty"), "");
  std::filesystem::create_directories(In("folder"));
  EXPECT_TRUE(CheckMapTarget(In("m.map")).ok());
  EXPECT_TRUE(CheckMapTarget(In("empty")).ok());
  EXPECT_TRUE(CheckMapTarget(In("new/place/n.map")).ok());
  for (const char* name : {"folder", "picture.png", "picture.png/m.map"}) {
    const Status status = CheckMapTarget(In(name));
    ASSERT_FALSE(status.ok()) << name;
    EXPECT_EQ(status.error().kind, Error::Kind::kBadInput);
    EXPECT_THAT(status.error().message, HasSubstr(In(name)));
  }
  EXPECT_FALSE(CheckMapTarget("/dev/null").ok());
  EXPECT_FALSE(std::filesystem::exists(In("m.map.part")));
  EXPECT_TRUE(ReadMapFile(In("m.map")).ok());
}

TEST_F(MapFile, BehindASymbolicLinkTheMapItselfIsReplaced) {
  Written();
  std::filesystem::create_symlink("m.map", In("current.map"));
  ASSERT_TRUE(WriteMapFile(In("current.map"), Map(), {}).ok());
  EXPECT_TRUE(std::filesystem::is_symlink(In("current.map")));
  EXPECT_EQ(ReadMapFile(In("m.map"))->map.num_keyframes(), 0u);
}

}  // namespace
}  // namespace yorb
