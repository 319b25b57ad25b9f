// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "detection/net_join.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

namespace yorb {
namespace {

/// Who reads what; null stands for whoever reads the results of the network.
class Readers {
 public:
  explicit Readers(const OnnxModel& model) {
    for (const OnnxNode& node : model.nodes) {
      for (const std::string& name : node.inputs) readers_[name].push_back(&node);
    }
    for (const OnnxValue& output : model.outputs) readers_[output.name].push_back(nullptr);
  }

  template <typename IsFine>
  bool AreAll(const std::string& name, const IsFine& is_fine) const {
    const auto found = readers_.find(name);
    return found != readers_.end() && std::all_of(found->second.begin(), found->second.end(), is_fine);
  }

  const OnnxNode* Only(const std::string& name) const {
    const auto found = readers_.find(name);
    return found != readers_.end() && found->second.size() == 1 ? found->second[0] : nullptr;
  }

 private:
  std::map<std::string, std::vector<const OnnxNode*>> readers_;
};

bool IsEnlargement(const OnnxNode& node) { return node.op == "Resize" || node.op == "Upsample"; }

/// Whether a node convolves pixel by pixel, all channels with all, by weights that are in the file.
bool IsOfSinglePixels(const OnnxNode& node, const std::set<std::string>& weights) {
  const auto all = [&node](const char* name, int64_t wanted) {
    const std::vector<int64_t> numbers = node.Integers(name, {});
    return std::all_of(numbers.begin(), numbers.end(), [wanted](int64_t number) { return number == wanted; });
  };
  return node.op == "Conv" && node.inputs.size() > 1 && weights.count(node.inputs[1]) > 0 &&
         node.Integer("group", 1) == 1 && all("strides", 1) && all("pads", 0);
}

/// The part of a convolution's weights for the channels from `start`.
NetValue WeightsFrom(const NetNode& node, int64_t start, int64_t count) {
  const NetValue& all = node.inputs[1];
  const std::vector<float> from = NumbersOf(all);
  NetValue part = NewConstant({all.dims[0], count, 1, 1});
  for (int64_t out = 0; out < all.dims[0]; ++out) {
    const auto row = from.begin() + out * all.dims[1] + start;
    std::copy(row, row + count, part.data.get() + out * count);
  }
  return part;
}

int64_t RowStep(const NetValue& value) { return value.dims[3] * value.dims[1]; }

/// Adds to each pixel the one of the small picture that it lies in.
void AddEnlarged(const NetNode& node, const NetValue& whole, const NetPart& part, float least, float most) {
  const int64_t rows = whole.dims[0] * whole.dims[2], columns = whole.dims[3], channels = whole.dims[1];
  node.Add([=, by_y = part.by_y, by_x = part.by_x, to = whole.data.get(), from = part.picture.data.get(),
            to_step = RowStep(whole), from_step = RowStep(part.picture)] {
    for (int64_t y = 0; y < rows; ++y) {
      for (int64_t x = 0; x < columns; ++x) {
        float* pixel = to + y * to_step + x * channels;
        const float* other = from + y / by_y * from_step + x / by_x * channels;
        for (int64_t c = 0; c < channels; ++c) pixel[c] = std::min(std::max(pixel[c] + other[c], least), most);
      }
    }
  });
}

}  // namespace

Result<std::vector<int64_t>> JoinedDims(const std::vector<NetPart>& parts) {
  std::vector<int64_t> joined;
  for (const NetPart& part : parts) {
    std::vector<int64_t> dims = part.picture.dims;
    if (dims.size() != 4) return BadInput(": only pictures are read");
    dims[2] *= part.by_y, dims[3] *= part.by_x;
    if (joined.empty()) {
      joined = dims;
    } else if (dims[0] == joined[0] && dims[2] == joined[2] && dims[3] == joined[3]) {
      joined[1] += dims[1];
    } else {
      return BadInput(": its inputs do not fit together");
    }
  }
  return joined;
}

std::set<const OnnxNode*> NodesToPutOff(const OnnxModel& model) {
  std::set<std::string> weights;
  for (const OnnxTensor& tensor : model.constants) {
    if (tensor.dims.size() == 4 && tensor.dims[2] == 1 && tensor.dims[3] == 1) weights.insert(tensor.name);
  }
  const Readers readers(model);
  std::map<std::string, const OnnxNode*> enlargements;  // by what they give, those of which one joint is made
  for (const OnnxNode& node : model.nodes) {
    if (IsEnlargement(node) && readers.Only(node.outputs[0]) != nullptr) enlargements[node.outputs[0]] = &node;
  }
  std::set<const OnnxNode*> put_off;
  for (const OnnxNode& node : model.nodes) {
    if (node.op != "Concat" || (node.Integer("axis", 0) != 1 && node.Integer("axis", 0) != -3)) continue;
    const auto is_enlarged = [&](const std::string& name) { return enlargements.count(name) > 0; };
    const auto num_enlarged = std::count_if(node.inputs.begin(), node.inputs.end(), is_enlarged);
    const auto is_fine = [&](const OnnxNode* reader) {
      return reader != nullptr && IsOfSinglePixels(*reader, weights) && reader->inputs[0] == node.outputs[0];
    };
    const bool has_both = num_enlarged > 0 && num_enlarged < static_cast<int64_t>(node.inputs.size());
    if (!has_both || !readers.AreAll(node.outputs[0], is_fine)) continue;
    put_off.insert(&node);
    for (const std::string& name : node.inputs) {
      if (is_enlarged(name)) put_off.insert(enlargements.at(name));
    }
  }
  return put_off;
}

NetOutputs AddConvolutionOfParts(const NetNode& node, const std::vector<NetPart>& parts) {
  std::vector<NetPart> convolved;
  int64_t start = 0, channels = 0;
  for (const NetPart& part : parts) channels += part.picture.dims[1];
  if (node.inputs[1].dims[1] != channels) return BadInput(": its weights do not fit its input");
  const auto base = std::find_if(parts.begin(), parts.end(), [](const NetPart& part) { return !part.IsEnlarged(); });
  if (base == parts.end()) return BadInput(": all that it reads is enlarged");
  for (const NetPart& part : parts) {
    NetNode one{node.node, {part.picture, WeightsFrom(node, start, part.picture.dims[1])}, node.program, node.opset};
    if (&part == &*base && node.Has(2)) one.inputs.push_back(node.inputs[2]);
    const NetOutputs outputs = AddPictureOperator(one);
    if (!outputs) return outputs.error();
    convolved.push_back({(*outputs)[0], part.by_y, part.by_x});
    start += part.picture.dims[1];
  }
  const auto index = static_cast<size_t>(base - parts.begin());
  const NetValue whole = convolved[index].picture;
  convolved.erase(convolved.begin() + static_cast<std::ptrdiff_t>(index));
  for (const NetPart& part : convolved) {
    const bool is_last = &part == &convolved.back();
    AddEnlarged(node, whole, part, is_last ? node.least : -HUGE_VALF, is_last ? node.most : HUGE_VALF);
  }
  return std::vector<NetValue>{whole};
}

}  // namespace yorb
