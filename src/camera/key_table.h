// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

#include "core/result.h"

namespace yorb {

/// One key of a settings file with its whole path ("Camera.fx", "cam0.intrinsics") and its values as text.
struct KeyEntry {
  std::string key;
  int line = 0;                     ///< from 1
  std::vector<std::string> values;  ///< one for a scalar; nested lists are laid out row by row
  bool is_contradicted = false;     ///< the key stands there twice with different values
};

/// A settings file as a flat list of keys, whatever its nesting.
struct KeyTable {
  std::string path;
  std::vector<KeyEntry> entries;

  /// Adds a key; one that is there already with the same values is passed over, else marked as contradicted.
  void Add(KeyEntry entry);

  const KeyEntry* Find(const std::string& key) const;
  bool Has(const std::string& key) const { return Find(key) != nullptr; }
  bool HasPrefix(const std::string& prefix) const;

  /// The first of these keys that is there, else the first of them.
  std::string FirstOf(std::initializer_list<std::string> keys) const;
};

/// Reads values out of a KeyTable; the first complaint wins and is kept, so that a reader of twenty keys is twenty
/// lines. A complaint names the file, the line and the key.
class KeyReader {
 public:
  explicit KeyReader(const KeyTable& table) : table_(table) {}

  const KeyTable& table() const { return table_; }

  /// The one of these keys that is there, else the first of them; refused where two of them disagree.
  std::string Either(std::initializer_list<std::string> keys);

  /// A finite number that must be there; 0 where it is not.
  double Number(const std::string& key);
  double Number(const std::string& key, double otherwise);

  /// The same, greater than zero.
  double Positive(const std::string& key);
  double Positive(const std::string& key, double otherwise);

  /// A whole number of pixels > 0; 0 where the key is absent.
  int Pixels(const std::string& key);

  /// A list of finite numbers, empty where the key is absent.
  std::vector<double> Numbers(const std::string& key);

  std::string Word(const std::string& key, const std::string& otherwise);

  /// Complains about a key: "FILE, line N: KEY REASON".
  void Refuse(const std::string& key, const std::string& reason);

  /// Complains about the whole file.
  void RefuseFile(const std::string& reason);

  const std::optional<Error>& error() const { return error_; }

 private:
  const KeyEntry* Look(const std::string& key, bool is_required);
  double Read(const KeyEntry& entry, const std::string& value);

  const KeyTable& table_;
  std::optional<Error> error_;
};

}  // namespace yorb
