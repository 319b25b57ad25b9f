// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "places/vocabulary_text.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>
#include <utility>
#include <vector>

#include "core/text.h"

namespace yorb {
namespace {

constexpr const char* kRemedy = "; is it a vocabulary of yorb vocab train, or in the format of ORBvoc.txt?";

/// A node as its line has it.
struct TextNode {
  uint32_t parent = 0;
  bool is_word = false;
  Descriptor centre{};
  float weight = 0;
  int line = 0;
};

/// Gives one field after the other of a line.
class Fields {
 public:
  explicit Fields(std::string_view line) : rest_(line) {}

  /// Empty at the end of the line.
  std::string_view Next() {
    size_t begin = 0;
    while (begin < rest_.size() && IsBlank(rest_[begin])) ++begin;
    size_t end = begin;
    while (end < rest_.size() && !IsBlank(rest_[end])) ++end;
    const std::string_view field = rest_.substr(begin, end - begin);
    rest_.remove_prefix(end);
    return field;
  }

  /// A whole number from 0 to `high`.
  std::optional<uint32_t> NextWhole(long long high) {
    const auto number = ParseInteger(Next());
    if (!number || *number < 0 || *number > high) return std::nullopt;
    return static_cast<uint32_t>(*number);
  }

 private:
  static bool IsBlank(char letter) { return letter == ' ' || letter == '\t' || letter == '\r'; }

  std::string_view rest_;
};

/// Gives the lines that say something.
class Lines {
 public:
  explicit Lines(std::string_view text) : rest_(text) {}

  std::optional<std::string_view> Next() {
    while (!rest_.empty()) {
      const size_t end = rest_.find('\n');
      const std::string_view line = Trim(rest_.substr(0, end));
      rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
      ++number_;
      if (!line.empty() && line.front() != '#') return line;
    }
    return std::nullopt;
  }

  int number() const { return number_; }  // of the line given last

 private:
  std::string_view rest_;
  int number_ = 0;
};

/// What is wrong with a node's line, in words; nothing where it is fine.
std::optional<std::string> ReadNode(std::string_view line, size_t num_known, TextNode& node) {
  Fields fields(line);
  const auto parent = fields.NextWhole(static_cast<long long>(num_known) - 1);
  if (!parent) return "the first field must be a node of a line above, from 0 to " + std::to_string(num_known - 1);
  node.parent = *parent;
  const auto is_word = fields.NextWhole(1);
  if (!is_word) return "the second field must be 0, or 1 for a word";
  node.is_word = *is_word == 1;
  unsigned char bytes[sizeof(Descriptor)];
  for (unsigned char& byte : bytes) {
    const auto value = fields.NextWhole(255);
    if (!value) return "32 bytes from 0 to 255 must stand behind the second field; is the file cut?";
    byte = static_cast<unsigned char>(*value);
  }
  std::memcpy(node.centre.data(), bytes, sizeof bytes);
  const auto weight = ParseDouble(fields.Next());
  if (!weight || !std::isfinite(*weight) || *weight < 0)
    return "the last field must be a weight, a number of at least 0; is the file cut?";
  node.weight = static_cast<float>(*weight);
  if (!fields.Next().empty()) return "35 fields are wanted, and there are more";
  return std::nullopt;
}

/// The nodes with the root first, and how many children each has.
struct TextTree {
  int branching = 0, levels = 0;
  std::vector<TextNode> nodes;
  std::vector<int> num_children, depth;
};

/// Puts a node below its parent; in words what speaks against it.
std::optional<std::string> AddNode(const TextNode& node, TextTree& tree) {
  const std::string parent = "its parent " + std::to_string(node.parent);
  if (node.parent > 0 && tree.nodes[node.parent].is_word) return parent + " is a word and has no children";
  if (++tree.num_children[node.parent] > tree.branching)
    return parent + " has more children than the " + std::to_string(tree.branching) + " of the first line";
  tree.depth.push_back(tree.depth[node.parent] + 1);
  if (tree.depth.back() > tree.levels)
    return "it lies deeper than the " + std::to_string(tree.levels) + " levels of the first line";
  if (tree.nodes.size() >= kMostTreeNodes) return std::string("more than 33 million nodes are too many");
  tree.nodes.push_back(node);
  tree.num_children.push_back(0);
  return std::nullopt;
}

Error Complaint(const std::string& path, int line, const std::string& what) {
  return BadInput(path + ", line " + std::to_string(line) + ": " + what);
}

Result<TextTree> ReadHead(const std::string& path, Lines& lines) {
  constexpr int kMostScorings = 5, kMostWeightings = 3;
  const auto line = lines.Next();
  if (!line) return BadInput(path + " is empty" + kRemedy);
  Fields fields(*line);
  const auto branching = fields.NextWhole(kMostBranches), levels = fields.NextWhole(kMostTreeLevels);
  const auto scoring = fields.NextWhole(kMostScorings), weighting = fields.NextWhole(kMostWeightings);
  if (!branching || *branching < 2 || !levels || *levels < 1 || !scoring || !weighting || !fields.Next().empty()) {
    return Complaint(
        path, lines.number(),
        std::string("it does not begin with `branching levels scoring weighting`, such as 10 6 0 0") + kRemedy);
  }
  TextTree tree;
  tree.branching = static_cast<int>(*branching), tree.levels = static_cast<int>(*levels);
  tree.nodes.emplace_back();
  tree.num_children = {0};
  tree.depth = {0};
  return tree;
}

Result<TextTree> ReadTree(const std::string& path, std::string_view text) {
  Lines lines(text);
  auto tree = ReadHead(path, lines);
  if (!tree) return tree;
  while (const auto line = lines.Next()) {
    TextNode node;
    node.line = lines.number();
    auto wrong = ReadNode(*line, tree->nodes.size(), node);
    if (!wrong) wrong = AddNode(node, *tree);
    if (wrong) return Complaint(path, lines.number(), *wrong);
  }
  for (size_t i = 0; i < tree->nodes.size(); ++i) {
    const TextNode& node = tree->nodes[i];
    if (node.is_word || tree->num_children[i] > 0) continue;
    const std::string which =
        i == 0 ? "the root" : "node " + std::to_string(i) + " of line " + std::to_string(node.line);
    return BadInput(path + " is cut: " + which + " has no words below it; get the whole file again");
  }
  return tree;
}

/// The nodes breadth first, children of a node in the order of their lines.
VocabularyTree BreadthFirst(const TextTree& text) {
  std::vector<size_t> next_child(text.nodes.size(), 0);  // where in `children` a node's next one goes
  for (size_t i = 0, sum = 0; i < text.nodes.size(); sum += static_cast<size_t>(text.num_children[i]), ++i)
    next_child[i] = sum;
  const std::vector<size_t> first_child = next_child;
  std::vector<size_t> children(text.nodes.size() - 1);
  for (size_t i = 1; i < text.nodes.size(); ++i) children[next_child[text.nodes[i].parent]++] = i;

  VocabularyTree tree;
  tree.branching = text.branching, tree.levels = text.levels;
  std::vector<size_t> order = {0};
  for (size_t at = 0; at < order.size(); ++at) {
    const size_t node = order[at];
    const auto count = static_cast<size_t>(text.num_children[node]);
    for (size_t i = 0; i < count; ++i) order.push_back(children[first_child[node] + i]);
    tree.num_children.push_back(static_cast<uint8_t>(count));
    tree.centres.push_back(text.nodes[node].centre);
    if (count == 0) tree.word_weights.push_back(text.nodes[node].weight);
  }
  return tree;
}

}  // namespace

Result<VocabularyPtr> VocabularyFromText(const std::string& path, std::string_view text) {
  const auto tree = ReadTree(path, text);
  if (!tree) return tree.error();
  auto vocabulary = Vocabulary::Make(BreadthFirst(*tree));
  if (!vocabulary) return BadInput(path + ": " + vocabulary.error().message);
  return vocabulary;
}

}  // namespace yorb
