// A file that numpy.load() opens: records of named columns, added as a simulation goes.
//
// NumPy's format is .npy and not .npz: the latter is an archive whose table comes last, so that a program that dies
// leaves nothing that can be opened. Here each Flush() updates the head, which has the number of records; NumPy ignores
// bytes beyond them. Columns have names, as in a CSV, and values are exact.
#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <initializer_list>
#include <string>
#include <vector>

#include "checkpoint/continued_file.h"
#include "report/flush_timer.h"

namespace dgd_demos {

class NpyFile {
 public:
  struct Column {
    const char* name;
    bool is_integer = false;  ///< 64 bits; otherwise double.
    int size = 1;             ///< Numbers of an entry: 3 of a vector.
  };

  /// @param rows_of_a_record  0: the file is a list of rows; otherwise a table, each record of which has so many rows.
  /// @throws std::runtime_error with the reason if it cannot be written.
  NpyFile(const std::filesystem::path& file, std::vector<Column> columns, std::size_t rows_of_a_record,
          OpenMode mode = OpenMode::kCreate);
  ~NpyFile();
  NpyFile(const NpyFile&) = delete;
  NpyFile& operator=(const NpyFile&) = delete;

  /// Names and types of a row's numbers, as the head has them: "[('time', '<f8'), ('position', '<f8', (3,)), ]".
  static std::string Description(const std::vector<Column>& columns);

  /// Adds the next numbers of the row, column by column.
  void Add(double number);
  void AddInteger(std::int64_t number);
  void Add(std::initializer_list<double> numbers);

  /// Hands what was added to the operating system, so that it survives a crash of this program.
  /// @pre the last record is complete.
  /// @throws std::runtime_error if that fails, as on a full disk.
  void Flush();
  /// Flush() now and then; see FlushTimer.
  void FlushIfDue() {
    if (timer_.IsDue()) Flush();
  }

  void Serialize(StateArchive& archive);

 private:
  std::string Head() const;
  [[noreturn]] void Fail(const char* action = "written") const;

  std::filesystem::path file_;
  std::vector<Column> columns_;
  std::size_t row_size_ = 0;  // Bytes.
  std::size_t rows_of_a_record_;
  std::size_t written_ = 0;  // Bytes, after the head.
  std::vector<char> buffer_;
  std::FILE* stream_;
  FlushTimer timer_;
};

}  // namespace dgd_demos
