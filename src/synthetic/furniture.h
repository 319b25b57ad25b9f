// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "synthetic/room_builder.h"

namespace yorb {

// Things to put into a room. Each adds itself to the builder at a place; sizes are metres. The builder's random numbers
// decide on the details, so that no two are alike.

void AddTable(RoomBuilder& room, const Place& place, const Eigen::Vector3f& size, const std::string& wood);
void AddBookcase(RoomBuilder& room, const Place& place, const Eigen::Vector3f& size, int num_shelves);
void AddCabinet(RoomBuilder& room, const Place& place, const Eigen::Vector3f& size, int columns, int rows);
void AddSofa(RoomBuilder& room, const Place& place, float width);
void AddChair(RoomBuilder& room, const Place& place);
void AddFloorLamp(RoomBuilder& room, const Place& place);
void AddPlant(RoomBuilder& room, const Place& place, float height);
void AddDoor(RoomBuilder& room, const Place& place);

/// A framed picture or window that hangs with its foot at the place, its back to the wall.
void AddPicture(RoomBuilder& room, const Place& place, float width, float height, int texture, bool is_glowing = false);

// furniture_things.cc: what stands on furniture.
void AddBooks(RoomBuilder& room, const Place& place, float width, float max_height);  ///< upright, side by side
void AddBookPile(RoomBuilder& room, const Place& place, int num_books);
void AddMonitor(RoomBuilder& room, const Place& place, int number);
void AddKeyboard(RoomBuilder& room, const Place& place);
void AddPaper(RoomBuilder& room, const Place& place);
void AddMug(RoomBuilder& room, const Place& place);
void AddGlobe(RoomBuilder& room, const Place& place);
void AddPackage(RoomBuilder& room, const Place& place, const Eigen::Vector3f& size);
void AddDeskLamp(RoomBuilder& room, const Place& place);

/// One of the posters, landscapes, maps and abstract pictures; the same number gives the same one within a room.
int PictureTexture(RoomBuilder& room, int number);

}  // namespace yorb
