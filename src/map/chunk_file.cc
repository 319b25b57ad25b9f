// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "map/chunk_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

#include "map/bytes.h"

namespace yorb {
namespace {

constexpr size_t kMagicBytes = 8, kNameBytes = 4, kCrcBytes = 4;
constexpr size_t kHeadBytes = kNameBytes + sizeof(uint64_t);
constexpr const char* kEnd = "END ";

uint32_t Crc(uint32_t before, std::string_view bytes) {
  return static_cast<uint32_t>(crc32_z(before, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()));
}

std::string HeadOf(const char* name, uint64_t length) {
  ByteWriter head;
  head.PutRow(name, kNameBytes);
  head.Put(length);
  return head.bytes();
}

std::string BytesOf(uint32_t number) {
  ByteWriter bytes;
  bytes.Put(number);
  return bytes.bytes();
}

Error CannotRead(const std::string& path, int reason) {
  if (reason == ENOENT) return BadInput(path + " does not exist");
  return BadInput(path + " cannot be read: " + std::generic_category().message(reason));
}

}  // namespace

Result<ChunkFileWriter> ChunkFileWriter::Open(const std::string& path, const ChunkFileKind& kind) {
  auto draft = FileDraft::Open(path);
  if (!draft) return draft.error();
  ChunkFileWriter writer(*std::move(draft));
  const Status status = writer.Append(std::string(kind.magic, kMagicBytes) + BytesOf(kind.version));
  if (!status) return status.error();
  return writer;
}

Status ChunkFileWriter::Append(const std::string& bytes) {
  crc_ = Crc(crc_, bytes);
  return draft_.Append(bytes.data(), bytes.size());
}

Status ChunkFileWriter::Add(const char* name, const std::string& content) {
  const std::string head = HeadOf(name, content.size());
  const uint32_t crc = Crc(Crc(0, head), content);
  ++num_chunks_;
  for (const std::string& part : {head, content, BytesOf(crc)}) {
    Status status = Append(part);
    if (!status) return status;
  }
  return Status::Ok();
}

Status ChunkFileWriter::Commit() {
  ByteWriter end;
  end.Put(crc_);
  end.Put(num_chunks_);
  Status status = Add(kEnd, end.bytes());
  return status ? draft_.Commit() : status;
}

/// The open file and how far it was read.
struct ChunkFileReader::Handle {
  std::string path;
  const char* what = "";
  int file = -1;
  uint64_t size = 0, left = 0;
  uint32_t crc = 0;
  uint64_t num_chunks = 0;
  bool is_at_end = false;

  ~Handle() {
    if (file >= 0) ::close(file);
  }
};

Result<ChunkFileReader> ChunkFileReader::Open(const std::string& path, const ChunkFileKind& kind) {
  auto handle = std::make_shared<Handle>();
  handle->path = path;
  handle->what = kind.what;
  handle->file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
  if (handle->file < 0) return CannotRead(path, errno);
  struct stat about {};
  if (::fstat(handle->file, &about) != 0) return CannotRead(path, errno);
  const std::string expected = std::string(", a ") + kind.what + " file is expected";
  if (S_ISDIR(about.st_mode)) return BadInput(path + " is a folder" + expected);
  if (!S_ISREG(about.st_mode)) return BadInput(path + " is no regular file" + expected);
  if (about.st_size == 0) return BadInput(path + " is empty" + expected);
  handle->size = handle->left = static_cast<uint64_t>(about.st_size);

  ChunkFileReader reader(handle);
  std::string head;
  if (!reader.Read(head, kMagicBytes) || head != std::string(kind.magic, kMagicBytes)) {
    return BadInput(path + " is no " + kind.what + " file of this program");
  }
  if (!reader.Read(head, sizeof(uint32_t))) return reader.Damaged("it is cut off");
  const auto version = ByteReader(head).Get<uint32_t>();
  if (version == kind.version) return reader;
  return BadInput(path + " is a " + kind.what + " file of version " + std::to_string(version) +
                  "; this program reads version " + std::to_string(kind.version));
}

bool ChunkFileReader::Read(std::string& bytes, uint64_t count) {
  bytes.clear();
  if (count > handle_->left) return false;
  bytes.resize(count);
  for (size_t done = 0; done < count;) {
    const ssize_t got = ::read(handle_->file, bytes.data() + done, count - done);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return false;
    done += static_cast<size_t>(got);
  }
  handle_->left -= count;
  handle_->crc = Crc(handle_->crc, bytes);
  return true;
}

Result<std::optional<Chunk>> ChunkFileReader::Next() {
  if (handle_->is_at_end) return std::optional<Chunk>();
  const uint32_t crc_before = handle_->crc;
  std::string head, crc;
  if (!Read(head, kHeadBytes)) return Damaged("it is cut off");
  ByteReader numbers(std::string_view(head).substr(kNameBytes));
  const auto length = numbers.Get<uint64_t>();
  Chunk chunk{head.substr(0, kNameBytes), {}};
  if (!Read(chunk.content, length) || !Read(crc, kCrcBytes)) return Damaged("it is cut off, or its bytes have changed");
  if (ByteReader(crc).Get<uint32_t>() != Crc(Crc(0, head), chunk.content)) return Damaged("a checksum does not fit");
  if (chunk.name == kEnd) return CheckEnd(chunk.content, crc_before);
  ++handle_->num_chunks;
  return std::optional<Chunk>(std::move(chunk));
}

Result<std::optional<Chunk>> ChunkFileReader::CheckEnd(const std::string& content, uint32_t crc_before) const {
  ByteReader end(content);
  const bool is_right = end.Get<uint32_t>() == crc_before && end.Get<uint64_t>() == handle_->num_chunks;
  if (!is_right || !end.IsReadWhole()) return Damaged("parts of it are missing or stand in a wrong order");
  if (handle_->left > 0) return Damaged("more bytes follow after its end");
  handle_->is_at_end = true;
  return std::optional<Chunk>();
}

uint64_t ChunkFileReader::num_bytes() const { return handle_->size; }

Error ChunkFileReader::Damaged(const std::string& why) const {
  return BadInput(handle_->path + " is damaged: " + why + "; take a copy of it or make the " + handle_->what + " anew");
}

}  // namespace yorb
