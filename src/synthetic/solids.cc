// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "synthetic/solids.h"

#include <cmath>
#include <numbers>

#include "core/check.h"

namespace yorb {
namespace {

struct Vertex {
  Eigen::Vector3f x_in_world, normal;
  Eigen::Vector2f uv;
  float light = 1;
};

// A face's lower left corner and its ways to the right and upwards, as seen from outside.
struct Frame {
  Eigen::Vector3f corner, right, up;
};

Frame FaceFrame(const Eigen::Vector3f& size, Face face) {
  const float w = size.x() / 2, d = size.y() / 2, h = size.z();
  const Eigen::Vector3f x(size.x(), 0, 0), y(0, size.y(), 0), z(0, 0, h);
  switch (face) {
    case Face::kFront:
      return {{-w, -d, 0}, x, z};
    case Face::kBack:
      return {{w, d, 0}, -x, z};
    case Face::kLeft:
      return {{-w, d, 0}, -y, z};
    case Face::kRight:
      return {{w, -d, 0}, y, z};
    case Face::kTop:
      return {{-w, -d, h}, x, y};
    case Face::kBottom:
      break;
  }
  return {{-w, d, 0}, x, -y};
}

Patch Triangle(const Vertex& a, const Vertex& b, const Vertex& c, const TurnedLook& look) {
  Patch patch;
  patch.corner = a.x_in_world;
  patch.edge_s = b.x_in_world - a.x_in_world;
  patch.edge_t = c.x_in_world - a.x_in_world;
  patch.uv = a.uv;
  patch.uv_s = b.uv - a.uv;
  patch.uv_t = c.uv - a.uv;
  patch.light = a.light;
  patch.light_s = b.light - a.light;
  patch.light_t = c.light - a.light;
  patch.texture = look.texture;
  patch.person = look.person;
  patch.is_triangle = true;
  return patch;
}

}  // namespace

Patch BoxFace(const Eigen::Isometry3f& world_from_box, const Eigen::Vector3f& size, Face face, const Look& look) {
  const Frame frame = FaceFrame(size, face);
  Patch patch;
  patch.corner = world_from_box * frame.corner;
  patch.edge_s = world_from_box.linear() * frame.right;
  patch.edge_t = world_from_box.linear() * frame.up;
  patch.texture = look.texture;
  patch.is_glowing = look.is_glowing;
  if (look.tile > 0) {
    const float right = frame.right.norm() / look.tile, up = frame.up.norm() / look.tile;
    patch.uv = look.offset;
    patch.uv_s = look.is_turned ? Eigen::Vector2f(0, right) : Eigen::Vector2f(right, 0);
    patch.uv_t = look.is_turned ? Eigen::Vector2f(up, 0) : Eigen::Vector2f(0, -up);
  } else {
    patch.uv = {look.part[0], look.part[1] + look.part[3]};
    patch.uv_s = {look.part[2], 0};
    patch.uv_t = {0, -look.part[3]};
  }
  return patch;
}

void AppendTurned(const Eigen::Isometry3f& world_from_shape, const std::vector<Slice>& slices, const TurnedLook& look,
                  const LightFunction& light, std::vector<Patch>& patches) {
  YORB_CHECK(slices.size() >= 2 && look.num_sectors >= 3, "a turned shape needs slices and sectors");
  const int num_columns = look.num_sectors + 1;
  std::vector<Vertex> vertices;
  const float low = slices.front().height, high = slices.back().height;
  for (size_t i = 0; i < slices.size(); ++i) {
    const Slice& slice = slices[i];
    const Slice &below = slices[i > 0 ? i - 1 : i], &above = slices[i + 1 < slices.size() ? i + 1 : i];
    for (int j = 0; j < num_columns; ++j) {
      const float round = static_cast<float>(j) / static_cast<float>(look.num_sectors),
                  angle = 2 * std::numbers::pi_v<float> * round + std::numbers::pi_v<float> / 2;
      const float c = std::cos(angle), s = std::sin(angle);
      const Eigen::Vector3f along(c * (above.half_x - below.half_x), s * (above.half_y - below.half_y),
                                  above.height - below.height);
      const Eigen::Vector3f around(-s * std::max(slice.half_x, 1e-3f), c * std::max(slice.half_y, 1e-3f), 0);
      Vertex vertex;
      vertex.x_in_world = world_from_shape * Eigen::Vector3f(c * slice.half_x, s * slice.half_y, slice.height);
      vertex.normal = world_from_shape.linear() * around.cross(along).normalized();
      vertex.uv = {look.repeat_u * round, look.repeat_v * (1 - (slice.height - low) / (high - low))};
      vertex.light = light(vertex.x_in_world, vertex.normal);
      vertices.push_back(vertex);
    }
  }
  for (size_t i = 0; i + 1 < slices.size(); ++i) {
    for (int j = 0; j + 1 < num_columns; ++j) {
      const Vertex* lower = vertices.data() + i * num_columns + j;
      const Vertex* upper = lower + num_columns;
      if (slices[i].half_x > 1e-4f) patches.push_back(Triangle(lower[0], lower[1], upper[0], look));
      if (slices[i + 1].half_x > 1e-4f) patches.push_back(Triangle(upper[1], upper[0], lower[1], look));
    }
  }
}

std::vector<Slice> EllipsoidSlices(float height, float half_x, float half_y, int num_slices) {
  std::vector<Slice> slices;
  for (int i = 0; i < num_slices; ++i) {
    const float angle = std::numbers::pi_v<float> * static_cast<float>(i) / static_cast<float>(num_slices - 1);
    const float radius = i == 0 || i == num_slices - 1 ? 0.f : std::sin(angle);
    slices.push_back({height / 2 * (1 - std::cos(angle)), half_x * radius, half_y * radius});
  }
  return slices;
}

}  // namespace yorb
