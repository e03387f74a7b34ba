// That the README's code is code that is compiled and tested.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <string>
#include <vector>

namespace dgd_test {

/// The lines of a text without the white space around them, empty ones left out.
inline std::vector<std::string> LinesOf(const std::string& file) {
  std::ifstream in(file);
  EXPECT_TRUE(in.is_open()) << file;
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) {
    const auto begin = line.find_first_not_of(" \t");
    if (begin != std::string::npos) lines.push_back(line.substr(begin, line.find_last_not_of(" \t\r") - begin + 1));
  }
  return lines;
}

/// Expects each C++ snippet of a README to be, line for line, in one of the source files; what it includes first may
/// be elsewhere in the file.
/// @return how many there are.
inline int ExpectSnippetsIn(const std::string& readme, const std::vector<std::string>& sources) {
  std::vector<std::vector<std::string>> texts;
  for (const std::string& source : sources) texts.push_back(LinesOf(source));
  bool in_snippet = false;
  int snippets = 0;
  std::vector<std::string> snippet;
  for (const std::string& line : LinesOf(readme)) {
    if (in_snippet && line == "```") {
      in_snippet = false;
      ++snippets;
      const auto code = std::find_if(snippet.begin(), snippet.end(),
                                     [](const std::string& of) { return !of.starts_with("#include"); });
      const bool is_there = std::any_of(texts.begin(), texts.end(), [&](const std::vector<std::string>& text) {
        const auto is_in_text = [&text](const std::string& of) {
          return std::find(text.begin(), text.end(), of) != text.end();
        };
        return std::all_of(snippet.begin(), code, is_in_text) &&
               std::search(text.begin(), text.end(), code, snippet.end()) != text.end();
      });
      EXPECT_TRUE(is_there) << "snippet " << snippets << ": " << snippet[0];
    } else if (in_snippet) {
      snippet.push_back(line);
    } else if (line == "```cpp") {
      in_snippet = true;
      snippet.clear();
    }
  }
  EXPECT_FALSE(in_snippet);
  return snippets;
}

}  // namespace dgd_test
