// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "places/vocabulary_io.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <fstream>
#include <string_view>
#include <utility>

#include "core/files.h"
#include "core/text.h"
#include "places/digest.h"
#include "places/vocabulary_text.h"

namespace yorb {
namespace {

static_assert(std::endian::native == std::endian::little, "the format is that of machines with the low byte first");

/// A file of ours: this head, num_children of each node, centres of each but the root, weights of the words, and last
/// the digest of all that stands before.
struct Head {
  char magic[8];
  uint32_t version = 1;
  uint32_t branching = 0, levels = 0;
  uint32_t unused = 0;
  uint64_t num_nodes = 0, num_words = 0;
};
static_assert(sizeof(Head) == 40);

constexpr std::string_view kMagic("yorbvoc\0", 8);

uint64_t DigestOf(std::string_view bytes) {
  Digest digest;
  digest.Add(bytes.data(), bytes.size());
  return digest.value();
}

Result<std::string> ReadBytes(const std::string& path) {
  std::ifstream stream(path, std::ios::binary | std::ios::ate);
  std::string bytes(static_cast<size_t>(std::max<std::streamoff>(stream.tellg(), 0)), '\0');
  stream.seekg(0);
  if (!stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()))) return BadInput(path + " cannot be read");
  return bytes;
}

/// Copies the next bytes into rows of their own.
template <typename T>
std::vector<T> Take(std::string_view& rest, size_t count) {
  std::vector<T> rows(count);
  std::memcpy(rows.data(), rest.data(), count * sizeof(T));
  rest.remove_prefix(count * sizeof(T));
  return rows;
}

/// Whether the file has the very size that its head asks for; nothing is reserved before that is known.
bool HasItsSize(const Head& head, size_t size) {
  if (head.num_nodes < 2 || head.num_nodes > kMostTreeNodes || head.num_words > head.num_nodes) return false;
  return size == sizeof(Head) + head.num_nodes + (head.num_nodes - 1) * sizeof(Descriptor) +
                     head.num_words * sizeof(float) + sizeof(uint64_t);
}

Result<VocabularyPtr> FromBytes(const std::string& path, std::string_view bytes) {
  const std::string damaged = path + " is damaged or cut; get the whole vocabulary again";
  Head head;
  if (bytes.size() < sizeof head) return BadInput(damaged);
  std::memcpy(&head, bytes.data(), sizeof head);
  if (head.version != Head().version)
    return BadInput(path + " is a vocabulary of format " + std::to_string(head.version) +
                    ", or damaged; this program reads format 1: train it anew with yorb vocab train");
  if (!HasItsSize(head, bytes.size())) return BadInput(damaged);
  const std::string_view content = bytes.substr(0, bytes.size() - sizeof(uint64_t));
  uint64_t digest = 0;
  std::memcpy(&digest, bytes.data() + content.size(), sizeof digest);
  if (DigestOf(content) != digest) return BadInput(damaged);

  std::string_view rest = content.substr(sizeof head);
  VocabularyTree tree;
  tree.branching = static_cast<int>(std::min<uint32_t>(head.branching, kMostBranches + 1));
  tree.levels = static_cast<int>(std::min<uint32_t>(head.levels, kMostTreeLevels + 1));
  tree.num_children = Take<uint8_t>(rest, head.num_nodes);
  tree.centres.resize(head.num_nodes);
  std::memcpy(tree.centres.data() + 1, rest.data(), (head.num_nodes - 1) * sizeof(Descriptor));
  rest.remove_prefix((head.num_nodes - 1) * sizeof(Descriptor));
  tree.word_weights = Take<float>(rest, head.num_words);
  auto vocabulary = Vocabulary::Make(std::move(tree));
  if (!vocabulary) return BadInput(path + ": " + vocabulary.error().message);
  return vocabulary;
}

template <typename T>
void Append(const T* rows, size_t count, std::string& bytes) {
  bytes.append(reinterpret_cast<const char*>(rows), count * sizeof(T));
}

}  // namespace

bool BeginsAsVocabulary(const std::string& path) {
  char begin[kMagic.size()] = {};
  std::ifstream(path, std::ios::binary).read(begin, sizeof begin);
  return std::string_view(begin, sizeof begin) == kMagic;
}

Result<VocabularyPtr> ReadVocabulary(const std::string& path) {
  if (BeginsAsVocabulary(path)) {
    const auto bytes = ReadBytes(path);
    return bytes ? FromBytes(path, *bytes) : bytes.error();
  }
  const auto text = ReadWholeText(path);
  if (text) return VocabularyFromText(path, *text);
  return BadInput(text.error().message +
                  "; a vocabulary is what yorb vocab train writes, or has the format of ORBvoc.txt");
}

Status WriteVocabulary(const Vocabulary& vocabulary, const std::string& path) {
  const VocabularyTree& tree = vocabulary.tree();
  Head head;
  std::memcpy(head.magic, kMagic.data(), sizeof head.magic);
  head.branching = static_cast<uint32_t>(tree.branching), head.levels = static_cast<uint32_t>(tree.levels);
  head.num_nodes = tree.num_children.size(), head.num_words = tree.word_weights.size();
  std::string bytes;
  Append(&head, 1, bytes);
  Append(tree.num_children.data(), tree.num_children.size(), bytes);
  Append(tree.centres.data() + 1, tree.centres.size() - 1, bytes);
  Append(tree.word_weights.data(), tree.word_weights.size(), bytes);
  const uint64_t digest = DigestOf(bytes);
  Append(&digest, 1, bytes);
  return WriteFileWhole(path, bytes);
}

}  // namespace yorb
