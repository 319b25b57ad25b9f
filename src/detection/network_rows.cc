// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "detection/network_rows.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <utility>

#include "detection/net_compile.h"

namespace yorb {
namespace {

/// The part of a network that a node's name begins with: "5" of "5.expand"; empty where it does not begin with a number
/// and a point.
std::string PartOf(const std::string& name) {
  size_t length = 0;
  while (length < name.size() && std::isdigit(static_cast<unsigned char>(name[length]))) ++length;
  const bool is_part = length > 0 && (length == name.size() || name[length] == '.');
  return is_part ? name.substr(0, length) : "";
}

bool IsWeighty(const OnnxNode& node) {
  return node.op == "Conv" || node.op == "ConvTranspose" || node.op == "Gemm" || node.op == "MatMul";
}

/// Sorts nodes into rows, in the order of the file.
class RowSorter {
 public:
  RowSorter(const OnnxModel& model, const std::vector<std::vector<int64_t>>& shapes) : model_(model), shapes_(shapes) {
    for (const OnnxTensor& tensor : model.constants) constants_[tensor.name] = &tensor;
  }

  NetworkTable Sort() {
    for (size_t i = 0; i < model_.nodes.size(); ++i) Take(model_.nodes[i], i);
    NetworkTable table;
    double gflops = 0;
    for (Row& row : rows_) row.table.from = FromOf(row);
    for (Row& row : rows_) {
      table.parameters += row.table.parameters;
      gflops += row.table.gflops;
      table.rows.push_back(std::move(row.table));
    }
    for (const OnnxNode& node : model_.nodes) table.num_convolutions += node.op == "Conv" ? 1 : 0;
    if (!shapes_.empty()) table.gflops = gflops;
    return table;
  }

 private:
  struct Row {
    NetworkRow table;
    std::set<size_t> from;
    bool has_part = false;
  };

  /// The row that made what a node reads; nothing for the picture and constants.
  std::vector<size_t> RowsRead(const OnnxNode& node) const {
    std::vector<size_t> rows;
    for (const std::string& name : node.inputs) {
      if (const auto found = row_of_.find(name); found != row_of_.end()) rows.push_back(found->second);
    }
    return rows;
  }

  /// A node goes to the row of its own name, to that of what it reads where it only changes that, or to a new one.
  size_t RowFor(const OnnxNode& node) {
    const std::vector<size_t> read = RowsRead(node);
    const std::string part = PartOf(node.name);
    if (IsWeighty(node)) {
      const auto known = parts_.find(part);
      if (!part.empty() && known != parts_.end()) return known->second;
      return NewRow(part);
    }
    const bool is_one =
        !read.empty() && std::all_of(read.begin(), read.end(), [&](size_t row) { return row == read[0]; });
    const bool stands_alone = node.op == "Resize" || node.op == "Upsample" || (node.op == "Concat" && !is_one);
    if (read.empty() || stands_alone) return NewRow("");
    return *std::max_element(read.begin(), read.end());
  }

  size_t NewRow(const std::string& part) {
    Row row;
    row.has_part = !part.empty();
    row.table.name = row.has_part ? part : "(" + std::to_string(rows_.size()) + ")";
    if (row.has_part) parts_[part] = rows_.size();
    rows_.push_back(std::move(row));
    return rows_.size() - 1;
  }

  void Take(const OnnxNode& node, size_t index) {
    bool is_of_constants = !node.inputs.empty();
    for (const std::string& name : node.inputs) is_of_constants &= name.empty() || constants_.count(name) > 0;
    if (node.op == "Constant" || is_of_constants) return;
    const size_t place = RowFor(node);
    Row& row = rows_[place];
    for (const size_t read : RowsRead(node)) {
      if (read != place) row.from.insert(read);
    }
    for (const std::string& name : node.outputs) row_of_[name] = place;
    Describe(node, row.table);
    int64_t weights = 0;
    for (const std::string& name : node.inputs) {
      const auto found = constants_.find(name);
      const bool counts =
          found != constants_.end() && !found->second->is_whole && (IsWeighty(node) || node.op == "BatchNormalization");
      if (counts) weights += static_cast<int64_t>(found->second->size());
    }
    row.table.parameters += weights;
    if (shapes_.empty()) return;
    row.table.shape = shapes_[index];
    if (node.op == "Conv") row.table.gflops += 2e-9 * Multiplications(node, shapes_[index]);
  }

  double Multiplications(const OnnxNode& node, const std::vector<int64_t>& shape) const {
    const auto weights = constants_.find(node.inputs.size() > 1 ? node.inputs[1] : "");
    if (weights == constants_.end() || shape.size() != 4) return 0;
    return static_cast<double>(weights->second->size()) * static_cast<double>(shape[2] * shape[3]);
  }

  /// Operators that say what kind of row it is; those that are only glue are left out.
  void Describe(const OnnxNode& node, NetworkRow& row) const {
    std::string word = node.op;
    if (node.op == "Conv") {
      const auto kernel = node.Integers("kernel_shape", {1, 1}), strides = node.Integers("strides", {1, 1});
      word = (node.Integer("group", 1) > 1 ? "DWConv" : "Conv") + std::to_string(kernel[0]) + "x" +
             std::to_string(kernel.back());
      if (strides[0] > 1) word += "/" + std::to_string(strides[0]);
    }
    for (const char* glue : {"Mul", "Reshape", "Transpose", "Cast", "Identity"}) {
      if (node.op == glue) return;
    }
    const size_t last = row.module.rfind(' ');
    const std::string before = row.module.substr(last == std::string::npos ? 0 : last + 1);
    if (before == word) return;
    row.module += (row.module.empty() ? "" : " ") + word;
  }

  std::string FromOf(const Row& row) const {
    std::string text;
    for (const size_t from : row.from) text += (text.empty() ? "" : ", ") + rows_[from].table.name;
    return text.empty() ? "picture" : text;
  }

  const OnnxModel& model_;
  const std::vector<std::vector<int64_t>>& shapes_;
  std::map<std::string, const OnnxTensor*> constants_;
  std::vector<Row> rows_;
  std::map<std::string, size_t> row_of_, parts_;  // by the names of values, of parts
};

}  // namespace

NetworkTable TableOf(const Network& network) {
  const auto net = CompileNet(network.model, network.input, nullptr);
  const std::vector<std::vector<int64_t>> none;
  return RowSorter(network.model, net ? net->shapes : none).Sort();
}

}  // namespace yorb
