// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "detection/network.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "core/text.h"
#include "detection/class_names.h"
#include "detection/head_layout.h"
#include "detection/own_suppression.h"

namespace yorb {
namespace {

constexpr int kUsualSize = 640;  // px

std::string Metadata(const OnnxModel& model, const std::string& key) {
  const auto found = model.metadata.find(key);
  return found == model.metadata.end() ? std::string() : found->second;
}

/// The input's size as the metadata has it: height before width, or one number for both.
cv::Size SizeOfMetadata(const OnnxModel& model) {
  const std::vector<double> sizes = NumbersIn(Metadata(model, "imgsz"));
  if (sizes.empty() || sizes[0] < 1 || sizes.back() < 1 || sizes[0] > kLargestSize || sizes.back() > kLargestSize)
    return {kUsualSize, kUsualSize};
  return {static_cast<int>(sizes.size() > 1 ? sizes[1] : sizes[0]), static_cast<int>(sizes[0])};
}

Error NoPictures(const OnnxValue& input, const std::string& wanted) {
  return BadInput("has the input " + input.name + " of shape " + ShapeText(input.dims) + "; " + wanted);
}

/// Whether the one input may be a picture, of whatever size.
Status CheckInputs(const OnnxModel& model) {
  if (model.inputs.size() != 1)
    return BadInput("has " + std::to_string(model.inputs.size()) + " inputs, a detector has one: the picture");
  const OnnxValue& value = model.inputs.front();
  if (value.dims.size() != 4) return NoPictures(value, "(1, 3, height, width) is expected");
  const bool is_of_floats = value.type == kOnnxFloat || value.type == kOnnxFloat16 || value.type == kOnnxDouble;
  if (is_of_floats || value.type == kOnnxUint8) return Status::Ok();
  return NoPictures(value, "it is neither of floats nor of bytes (uint8); export it with floats for input");
}

Result<EngineInput> InputOf(const OnnxModel& model, const cv::Size& size) {
  if (const Status fine = CheckInputs(model); !fine) return fine.error();
  const OnnxValue& value = model.inputs.front();
  std::vector<int64_t> dims = value.dims;
  const bool is_channels_last = dims[3] == 3 && dims[1] != 3 && dims[1] != 1;
  if (is_channels_last) std::rotate(dims.begin() + 1, dims.begin() + 3, dims.end());
  const int64_t channels = dims[1] < 0 ? 3 : dims[1];
  if (channels != 3 && channels != 1)
    return NoPictures(value, "(1, 3, height, width) is expected: red, green, blue before height and width");
  // Another size than the file's is tried: networks of convolutions alone do not mind, others fail when they are set
  // up.
  const cv::Size open = size.empty() ? SizeOfMetadata(model) : size;
  const auto sized = [&](int64_t fixed, int wanted) {
    return static_cast<int>(std::min<int64_t>(fixed < 0 || !size.empty() ? wanted : fixed, INT32_MAX));
  };
  EngineInput input;
  input.batch = static_cast<int>(std::clamp<int64_t>(value.dims[0], 1, 64));
  input.channels = static_cast<int>(channels);
  input.are_bytes = value.type == kOnnxUint8, input.is_channels_last = is_channels_last;
  input.height = sized(dims[2], open.height);
  input.width = sized(dims[3], open.width);
  const bool is_bearable = input.width <= kLargestSize && input.height <= kLargestSize;
  if (!is_bearable || input.width % kCellSize != 0 || input.height % kCellSize != 0 ||
      input.batch != std::max<int64_t>(value.dims[0], 1))
    return NoPictures(value, "sizes that are multiples of " + std::to_string(kCellSize) + " up to " +
                                 std::to_string(kLargestSize) + " are expected, not " + std::to_string(input.width) +
                                 "x" + std::to_string(input.height));
  return input;
}

struct Names {
  std::vector<std::string> names;
  std::string source, file;
};

/// The lines of a list of names beside the network: FILE.names, with FILE's ending or without.
Result<Names> NamesBeside(const std::string& path) {
  for (const std::string& file : {path + ".names", std::filesystem::path(path).replace_extension(".names").string()}) {
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored)) continue;
    auto names = ReadClassList(file);
    if (!names) return names.error();
    return Names{*std::move(names), file, file};
  }
  return Names{};
}

Result<Names> NamesOf(const OnnxModel& model, const std::string& path) {
  const std::string text = Metadata(model, "names");
  const auto names = ParseClassNames(text);
  if (names) return Names{*names, "its metadata", ""};
  auto beside = NamesBeside(path);
  const bool has_none = Trim(text).empty() || text == "{}" || text == "[]";
  if (!beside || has_none || !beside->names.empty()) return beside;
  return BadInput(path + " carries class names that are no list such as {0: 'person', 1: 'chair'}: '" +
                  text.substr(0, 60) + "'; write them, a line each, into " + path + ".names");
}

Result<std::vector<float>> AnchorsOf(const OnnxModel& model) {
  const std::vector<double> numbers = NumbersIn(Metadata(model, "anchors"));
  const bool is_usable = numbers.size() % 6 == 0 && std::all_of(numbers.begin(), numbers.end(),
                                                                [](double size) { return size > 0 && size < 1e5; });
  if (!is_usable) return BadInput("carries anchors that are not three pairs of sizes in pixels a map");
  return std::vector<float>(numbers.begin(), numbers.end());
}

/// Pose networks write how many points of how many numbers they give: kpt_shape [17, 3].
int KeypointValues(const OnnxModel& model) {
  const std::vector<double> shape = NumbersIn(Metadata(model, "kpt_shape"));
  if (shape.size() != 2 || shape[0] < 1 || shape[0] > 1000 || shape[1] < 1 || shape[1] > 3) return 0;
  return static_cast<int>(shape[0] * shape[1]);
}

/// A map of people is the last output, `people`, and named in the metadata.
bool HasPeople(const OnnxModel& model) {
  return model.outputs.size() > 1 && model.outputs.back().name == "people" && !Metadata(model, "people").empty();
}

/// `stills`: one or more numbers of pixels; anything else says nothing.
std::vector<int> StillsSides(const OnnxModel& model) {
  const std::vector<double> sides = NumbersIn(Metadata(model, "stills"));
  const bool is_usable = sides.size() <= kMostLooks && std::all_of(sides.begin(), sides.end(), [](double side) {
                           return side >= kCellSize && side <= kLargestSize;
                         });
  return is_usable ? std::vector<int>(sides.begin(), sides.end()) : std::vector<int>();
}

/// The producers of values, by the values' names.
const OnnxNode* MakerOf(const OnnxModel& model, const std::string& value) {
  for (const OnnxNode& node : model.nodes) {
    if (std::find(node.outputs.begin(), node.outputs.end(), value) != node.outputs.end()) return &node;
  }
  return nullptr;
}

}  // namespace

std::string LastOperator(const OnnxModel& model, const std::string& output) {
  const OnnxNode* node = MakerOf(model, output);
  while (node != nullptr && !node->inputs.empty() &&
         (node->op == "Reshape" || node->op == "Transpose" || node->op == "Identity" || node->op == "Cast")) {
    node = MakerOf(model, node->inputs.front());
  }
  return node != nullptr ? node->op : "";
}

Result<Network> OpenNetwork(const std::string& path, const cv::Size& size) {
  auto model = ReadOnnxFile(path);
  if (!model) return model.error();
  const auto named = [&](const Error& error) { return BadInput(path + " " + error.message); };
  Network network;
  const auto input = InputOf(*model, size);
  if (!input) return named(input.error());
  network.input = *input;
  network.input.path = path;
  auto names = NamesOf(*model, path);
  if (!names) return names.error();
  network.names = std::move(names->names);
  network.names_source = std::move(names->source);
  network.names_file = std::move(names->file);
  auto anchors = AnchorsOf(*model);
  if (!anchors) return named(anchors.error());
  network.anchors = *std::move(anchors);
  network.stills_px = StillsSides(*model);
  network.task = Metadata(*model, "task").substr(0, 20);
  network.num_keypoint_values = KeypointValues(*model);
  network.has_people = HasPeople(*model);
  network.model = *std::move(model);
  network.model.inputs.front().type = kOnnxFloat;  // as all engines are handed it
  LeaveOutOwnSuppression(network);
  return network;
}

}  // namespace yorb
