// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <set>
#include <utility>

#include "core/text.h"
#include "detection/onnx_model.h"
#include "detection/onnx_tensor.h"
#include "detection/proto_reader.h"

namespace yorb {
namespace {

using Field = ProtoField;

Result<OnnxAttribute> ParseAttribute(std::string_view message, const std::string& folder) {
  OnnxAttribute attribute;
  ProtoReader reader(message);
  while (const auto field = reader.Next()) {
    switch (field->id) {
      case 1:
        attribute.name = std::string(field->bytes);
        break;
      case 2:
        attribute.number = field->AsFloat();
        break;
      case 3:
        attribute.integer = field->AsInteger();
        break;
      case 4:
        attribute.text = std::string(field->bytes);
        break;
      case 5: {
        auto read = ParseOnnxTensor(field->bytes, folder);
        if (!read) return read.error();
        attribute.tensor = *std::move(read);
        break;
      }
      case 7: {
        const auto floats = ProtoFloats(*field);
        if (!floats) return DamagedProto();
        attribute.floats.insert(attribute.floats.end(), floats->begin(), floats->end());
        break;
      }
      case 8: {
        const auto ints = ProtoIntegers(*field);
        if (!ints) return DamagedProto();
        attribute.ints.insert(attribute.ints.end(), ints->begin(), ints->end());
        break;
      }
      case 20:
        attribute.type = static_cast<int>(field->AsInteger());
        break;
      default:
        break;
    }
  }
  if (reader.is_damaged()) return DamagedProto();
  return attribute;
}

Result<OnnxNode> ParseNode(std::string_view message, const std::string& folder) {
  OnnxNode node;
  ProtoReader reader(message);
  while (const auto field = reader.Next()) {
    if (field->id == 1) node.inputs.emplace_back(field->bytes);
    if (field->id == 2) node.outputs.emplace_back(field->bytes);
    if (field->id == 3) node.name = std::string(field->bytes);
    if (field->id == 4) node.op = std::string(field->bytes);
    if (field->id == 7) node.domain = std::string(field->bytes);
    if (field->id != 5) continue;
    auto attribute = ParseAttribute(field->bytes, folder);
    if (!attribute) return attribute.error();
    node.attributes.push_back(*std::move(attribute));
  }
  if (reader.is_damaged()) return DamagedProto();
  return node;
}

/// The message in field `id`, the last one where there are several; empty where there is none.
std::string_view Inner(std::string_view message, uint32_t id) {
  std::string_view inner;
  ProtoReader reader(message);
  while (const auto field = reader.Next()) {
    if (field->id == id && field->kind == Field::Kind::kBytes) inner = field->bytes;
  }
  return inner;
}

int64_t DimOf(std::string_view message) {
  int64_t size = -1;
  ProtoReader reader(message);
  while (const auto field = reader.Next()) {
    if (field->id == 1 && field->kind == Field::Kind::kVarint) size = field->AsInteger();
  }
  return size > 0 ? size : -1;
}

OnnxValue ParseValue(std::string_view message) {
  OnnxValue value;
  ProtoReader reader(message);
  while (const auto field = reader.Next()) {
    if (field->id == 1) value.name = std::string(field->bytes);
    if (field->id != 2) continue;
    ProtoReader tensor(Inner(field->bytes, 1));
    while (const auto part = tensor.Next()) {
      if (part->id == 1) value.type = static_cast<int>(part->AsInteger());
      if (part->id != 2) continue;
      value.has_shape = true;
      ProtoReader shape(part->bytes);
      while (const auto dim = shape.Next()) {
        if (dim->id == 1) value.dims.push_back(DimOf(dim->bytes));
      }
    }
  }
  return value;
}

Status ParseGraph(std::string_view message, const std::string& folder, OnnxModel& model) {
  ProtoReader reader(message);
  while (const auto field = reader.Next()) {
    if (field->id == 1) {
      auto node = ParseNode(field->bytes, folder);
      if (!node) return node.error();
      model.nodes.push_back(*std::move(node));
    } else if (field->id == 5) {
      auto read = ParseOnnxTensor(field->bytes, folder);
      if (!read) return read.error();
      model.constants.push_back(*std::move(read));
    } else if (field->id == 11) {
      model.inputs.push_back(ParseValue(field->bytes));
    } else if (field->id == 12) {
      model.outputs.push_back(ParseValue(field->bytes));
    } else if (field->id == 15) {
      return BadInput("holds sparse weights, which are not read; export without them");
    }
  }
  return reader.is_damaged() ? Status(DamagedProto()) : Status::Ok();
}

std::pair<std::string, std::string> ParseEntry(std::string_view message) {
  return {std::string(Inner(message, 1)), std::string(Inner(message, 2))};
}

int64_t ParseOpset(std::string_view message) {
  int64_t version = 0;
  bool is_standard = true;
  ProtoReader reader(message);
  while (const auto field = reader.Next()) {
    if (field->id == 1) is_standard = field->bytes.empty() || field->bytes == "ai.onnx";
    if (field->id == 2) version = field->AsInteger();
  }
  return is_standard ? version : 0;
}

/// Older files list their constants among the inputs.
void RemoveConstantInputs(OnnxModel& model) {
  std::set<std::string> constants;
  for (const OnnxTensor& tensor : model.constants) constants.insert(tensor.name);
  std::vector<OnnxValue> inputs;
  for (OnnxValue& input : model.inputs) {
    if (constants.count(input.name) == 0) inputs.push_back(std::move(input));
  }
  model.inputs = std::move(inputs);
}

/// Every name that is read was made before: what engines take for granted, and crash on where it is not so.
Status CheckNames(const OnnxModel& model) {
  std::set<std::string> known;
  for (const OnnxTensor& tensor : model.constants) known.insert(tensor.name);
  for (const OnnxValue& input : model.inputs) known.insert(input.name);
  for (const OnnxNode& node : model.nodes) {
    for (const std::string& name : node.inputs) {
      if (!name.empty() && known.count(name) == 0)
        return BadInput("is damaged: its node " + node.op + " reads '" + name + "', which nothing makes");
    }
    known.insert(node.outputs.begin(), node.outputs.end());
  }
  for (const OnnxValue& output : model.outputs) {
    if (known.count(output.name) == 0) return BadInput("is damaged: nothing makes its output '" + output.name + "'");
  }
  return Status::Ok();
}

/// What people take for an ONNX file, by its first bytes, and what may be done.
std::string OtherKind(const std::string& bytes) {
  struct Kind {
    size_t place;
    std::string_view mark;
    const char* is;
  };
  static const std::vector<Kind> kinds{
      {0, "version https://git-lfs.", "is a Git LFS pointer, the network itself was not fetched; git lfs pull does it"},
      {0, "PK\x03\x04", "is an archive such as PyTorch's weights, no ONNX file; export it to ONNX"},
      {0, "\x80\x02", "is a pickle such as PyTorch's older weights, no ONNX file; export it to ONNX"},
      {0, "ftrt", "is an engine of TensorRT, no ONNX file; take the ONNX file that it was made of"},
      {4, "{\"", "is an engine of TensorRT, no ONNX file; take the ONNX file that it was made of"},
      {4, "ORTM", "is in ONNX Runtime's own format, no ONNX file; take the ONNX file that it was made of"},
      {4, "TFL3", "is a network of TensorFlow Lite, no ONNX file; export it to ONNX"},
      {0, "\x89HDF", "is a file of HDF5 such as Keras's weights, no ONNX file; export it to ONNX"},
      {0, "7767517", "is a network of ncnn, no ONNX file; export it to ONNX"},
      {0, "[net]", "is a network of Darknet, no ONNX file; export it to ONNX"},
      {0, "\x1f\x8b", "is packed by gzip, no ONNX file; unpack it"}};
  constexpr size_t kStart = 100;  // bytes by which text is told
  if (bytes.empty()) return "is empty (0 bytes); download or export it again";
  for (const Kind& kind : kinds) {
    if (std::string_view(bytes).substr(std::min(kind.place, bytes.size())).starts_with(kind.mark)) return kind.is;
  }
  const std::string_view start = std::string_view(bytes).substr(0, kStart);
  const bool has_mark = start.starts_with("\xef\xbb\xbf");
  const std::string text(Trim(has_mark ? start.substr(3) : start));
  if (text.starts_with("<")) return "is a web page or XML, no ONNX file; download or export it again";
  const auto is_letter = [](char letter) { return static_cast<unsigned char>(letter) >= 0x20 || std::isspace(letter); };
  if (!text.empty() && std::all_of(text.begin(), text.end(), is_letter))
    return "is no ONNX file but a text, '" + std::string(SplitAt(text, '\n').front()).substr(0, 40) +
           "'; download or export it again";
  return "is no ONNX file, or is cut short; download or export it again";
}

Result<OnnxModel> Parse(const std::string& bytes, const std::string& folder) {
  OnnxModel model;
  bool has_graph = false;
  ProtoReader reader(bytes);
  while (const auto field = reader.Next()) {
    if (field->id == 1) model.ir_version = field->AsInteger();
    if (field->id == 2) model.producer = std::string(field->bytes);
    if (field->id == 8) model.opset = std::max(model.opset, ParseOpset(field->bytes));
    if (field->id == 14) model.metadata.insert(ParseEntry(field->bytes));
    if (field->id != 7 || field->kind != Field::Kind::kBytes) continue;
    has_graph = true;
    if (Status status = ParseGraph(field->bytes, folder, model); !status) return status.error();
  }
  if (reader.is_damaged() || !has_graph || model.ir_version <= 0 || model.nodes.empty())
    return BadInput(OtherKind(bytes));
  RemoveConstantInputs(model);
  if (model.inputs.empty() || model.outputs.empty()) return BadInput("has no input or no output");
  if (Status status = CheckNames(model); !status) return status.error();
  return model;
}

}  // namespace

Result<OnnxModel> ReadOnnxBytes(const std::string& bytes, const std::string& path) {
  auto model = Parse(bytes, std::filesystem::path(path).parent_path().string());
  if (!model) return BadInput(path + " " + model.error().message);
  return model;
}

Result<OnnxModel> ReadOnnxFile(const std::string& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) return BadInput(path + " is a folder, an ONNX file is expected");
  if (std::filesystem::exists(path, ignored) && !std::filesystem::is_regular_file(path, ignored))
    return BadInput(path + " is no regular file, an ONNX file is expected");  // a named pipe would never open
  std::ifstream stream(path, std::ios::binary | std::ios::ate);
  if (!stream) {
    const bool is_there = std::filesystem::exists(path, ignored);
    return BadInput(path + (is_there ? " cannot be read" : " does not exist"));
  }
  std::string bytes(static_cast<size_t>(std::max<std::streamoff>(stream.tellg(), 0)), '\0');
  stream.seekg(0);
  if (!bytes.empty() && !stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size())))
    return BadInput(path + " cannot be read");
  return ReadOnnxBytes(bytes, path);
}

}  // namespace yorb
