// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "synthetic/sequence.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "core/check.h"
#include "core/random.h"

namespace yorb {
namespace {

constexpr int64_t kFirstSecond = 1600000000;  // stamps look like those of a recorder

RoomOptions RoomOf(const SequenceOptions& options) {
  RoomOptions room = options.room;
  room.seed = options.seed;
  return room;
}

// Most walk round the desk that the hand-held camera looks at; in a loop every other one walks round the room.
PersonPlan PlanOf(int index, const SequenceOptions& options, const Stage& stage, Random& random) {
  PersonPlan plan;
  const bool is_loop = options.path == PathKind::kLoop;
  plan.route = (index + (is_loop ? 1 : 0)) % 2 == 1 && (is_loop || options.num_people > 3) ? 1 : 0;
  const int num_on_route = (options.num_people + 1) / 2;
  const double share = (is_loop || options.num_people > 3) ? static_cast<double>(index / 2) / num_on_route
                                                           : static_cast<double>(index) / options.num_people;
  plan.start = stage.routes[plan.route].length() * (share + 0.35 + 0.04 * random.Uniform());
  plan.speed = 0.95;
  plan.height = random.Uniform(1.6, 1.88);
  return plan;
}

std::vector<Mannequin> MakePeople(const SequenceOptions& options, Room& room) {
  Random random(options.seed, 0x9e091e);
  std::vector<Mannequin> people;
  for (int i = 0; i < options.num_people; ++i) {
    const PersonPlan plan = PlanOf(i, options, room.stage, random);
    people.emplace_back(plan, room.stage.routes[plan.route], i + 1, options.seed, room.scene);
  }
  return people;
}

std::vector<PersonBox> FindBoxes(const cv::Mat& mask, int num_people) {
  std::vector<PersonBox> boxes;
  for (int person = 1; person <= num_people; ++person) boxes.push_back({person, mask.cols, mask.rows, 0, 0, 0});
  for (int y = 0; y < mask.rows; ++y) {
    for (int x = 0; x < mask.cols; ++x) {
      const int person = mask.at<uchar>(y, x);
      if (person == 0) continue;
      PersonBox& box = boxes[static_cast<size_t>(person) - 1];
      box = {person,
             std::min(box.left, x),
             std::min(box.top, y),
             std::max(box.right, x + 1),
             std::max(box.bottom, y + 1),
             box.num_visible_px + 1};
    }
  }
  boxes.erase(std::remove_if(boxes.begin(), boxes.end(),
                             [](const PersonBox& box) { return box.num_visible_px < kMinVisiblePx; }),
              boxes.end());
  return boxes;
}

// Whether every pixel on the border has a ray, and the ray leads back to the pixel.
bool IsLensGood(const Pinhole& camera) {
  if (!camera.HasDistortion()) return true;
  std::vector<Eigen::Vector2f> border;
  constexpr int kSteps = 32;
  for (int i = 0; i <= kSteps; ++i) {
    const float x = static_cast<float>((camera.width - 1) * i) / kSteps,
                y = static_cast<float>((camera.height - 1) * i) / kSteps;
    for (const Eigen::Vector2f& at : {Eigen::Vector2f(x, 0), Eigen::Vector2f(x, camera.height - 1.f),
                                      Eigen::Vector2f(0, y), Eigen::Vector2f(camera.width - 1.f, y)}) {
      border.push_back(at);
    }
  }
  const std::vector<Eigen::Vector2f> ideal = camera.Undistort(border);
  for (size_t i = 0; i < border.size(); ++i) {
    if (!((camera.Distort(ideal[i].cast<double>()) - border[i].cast<double>()).norm() < 0.05)) return false;
  }
  return true;
}

}  // namespace

Rig SyntheticRig(int width, int height) {
  Rig rig;
  const double scale_x = width / 640.0, scale_y = height / 480.0;
  rig.camera.width = width;
  rig.camera.height = height;
  rig.camera.fx = 535.4 * scale_x;
  rig.camera.fy = 539.2 * scale_y;
  rig.camera.cx = (320.1 + 0.5) * scale_x - 0.5;  // pixel 0 is a pixel's centre, not its edge
  rig.camera.cy = (247.6 + 0.5) * scale_y - 0.5;
  rig.baseline_px = 40 * scale_x;
  rig.name = "synthetic";
  return rig;
}

Status CheckOptions(const SequenceOptions& options) {
  constexpr int kMinSide = 64, kMaxSide = 4096, kMaxFrames = 1000000;
  constexpr double kMaxNoise = 20;
  const Pinhole& camera = options.rig.camera;
  if (options.num_frames < 1 || options.num_frames > kMaxFrames)
    return BadInput("the number of frames must be 1 to 1000000");
  if (options.num_people < 0 || options.num_people > kMaxPeople)
    return BadInput("the number of people must be 0 to " + std::to_string(kMaxPeople));
  if (!(options.noise >= 0 && options.noise <= kMaxNoise))
    return BadInput("noise must be 0 (none) to 20; 1 is a usual sensor's");
  if (std::min(camera.width, camera.height) < kMinSide || std::max(camera.width, camera.height) > kMaxSide) {
    return BadInput("pictures must be 64 to 4096 pixels wide and high");
  }
  if (!(options.rig.fps > 0) || !(options.rig.depth_factor > 0))
    return BadInput("the camera must state fps and depth_factor above 0");
  if (!IsLensGood(camera))
    return BadInput("this distortion cannot be undone all over the picture; give smaller numbers");
  return Status::Ok();
}

SyntheticSequence::SyntheticSequence(const SequenceOptions& options)
    : options_(options),
      room_(MakeRoom(RoomOf(options))),
      path_(options.path, room_.stage, options.num_frames / options.rig.fps, options.seed),
      people_(MakePeople(options, room_)),
      renderer_(options.rig.camera) {
  YORB_CHECK(CheckOptions(options).ok(), "options that have passed CheckOptions");
}

Timestamp SyntheticSequence::TimeOf(int frame) const {
  return {(kFirstSecond * 1000000 + std::llround(frame * 1e6 / options_.rig.fps)) * 1000};  // whole microseconds
}

double SyntheticSequence::SecondsOf(int frame) const { return SecondsBetween(TimeOf(0), TimeOf(frame)); }

Rigid3 SyntheticSequence::WorldFromCamera(int frame) const { return path_.WorldFromCamera(SecondsOf(frame)); }

Trajectory SyntheticSequence::Truth() const {
  Trajectory truth;
  for (int frame = 0; frame < num_frames(); ++frame) truth.push_back({TimeOf(frame), WorldFromCamera(frame)});
  return truth;
}

RenderedFrame SyntheticSequence::Render(int frame) const {
  RenderedFrame rendered;
  rendered.world_from_cam = WorldFromCamera(frame);
  MovingThings moving;
  for (const Mannequin& person : people_) person.AddTo(moving, room_.scene, SecondsOf(frame));
  RenderedView view = renderer_.Render(room_.scene, moving, rendered.world_from_cam);

  const SensorOptions sensor{options_.noise, options_.seed};
  AddColourNoise(sensor, static_cast<uint64_t>(frame), view.colour);
  rendered.images.timestamp = TimeOf(frame);
  rendered.images.colour = view.colour;
  cv::cvtColor(view.colour, rendered.images.grey, cv::COLOR_BGR2GRAY);
  rendered.images.depth = {MeasureDepth(sensor, static_cast<uint64_t>(frame), options_.rig, view.depth),
                           1 / options_.rig.depth_factor};
  rendered.boxes = FindBoxes(view.mask, num_people());
  rendered.exact_depth = view.depth;
  rendered.mask = view.mask;
  return rendered;
}

}  // namespace yorb
