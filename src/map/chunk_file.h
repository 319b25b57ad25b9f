// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "core/file_draft.h"
#include "core/result.h"

namespace yorb {

// A file of chunks, each with a checksum, so that large files are read and written piece by piece and no byte is
// believed before it was checked. All numbers are little-endian:
//
//   magic (8 bytes), version (4)
//   chunks: name (4 letters), length (8), content (length), CRC-32 of these three (4)
//   the last chunk, "END ": CRC-32 of all bytes before it (4), number of chunks before it (8)

/// What tells a kind of file from others.
struct ChunkFileKind {
  const char* magic;  ///< eight bytes
  uint32_t version;
  const char* what;  ///< "map", for messages
};

class ChunkFileWriter {
 public:
  static Result<ChunkFileWriter> Open(const std::string& path, const ChunkFileKind& kind);

  Status Add(const char* name, const std::string& content);

  /// The end, and the file in its place (see FileDraft).
  Status Commit();

 private:
  explicit ChunkFileWriter(FileDraft draft) : draft_(std::move(draft)) {}
  Status Append(const std::string& bytes);

  FileDraft draft_;
  uint32_t crc_ = 0;
  uint64_t num_chunks_ = 0;
};

/// One chunk, its checksum found right.
struct Chunk {
  std::string name;
  std::string content;
};

class ChunkFileReader {
 public:
  /// Bad input where the file is missing, no file, of another kind or version; the message names it.
  static Result<ChunkFileReader> Open(const std::string& path, const ChunkFileKind& kind);

  /// The next chunk; nothing after the last one, when the whole file was found right. Bad input where it was not.
  Result<std::optional<Chunk>> Next();

  uint64_t num_bytes() const;

  /// "FILE is damaged: WHY", with the remedy.
  Error Damaged(const std::string& why) const;

 private:
  struct Handle;
  explicit ChunkFileReader(std::shared_ptr<Handle> handle) : handle_(std::move(handle)) {}
  bool Read(std::string& bytes, uint64_t count);
  Result<std::optional<Chunk>> CheckEnd(const std::string& content, uint32_t crc_before) const;

  std::shared_ptr<Handle> handle_;
};

}  // namespace yorb
