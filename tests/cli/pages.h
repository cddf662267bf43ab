#pragma once
// The project's documents, taken apart: Markdown pages, their code, links and headings.

#include <filesystem>
#include <string>
#include <vector>

namespace airlight::test {

struct CodeBlock {
  std::string language;  // what stands behind the opening ```
  std::string text;
};

struct Document {
  std::filesystem::path file;  // relative to the folder that was searched
  std::vector<CodeBlock> code;
  std::vector<std::string> links;     // [text](link) outside code
  std::vector<std::string> headings;  // as a link's part behind # names them
};

// All pages below a folder, by name. Hidden folders and those of builds (build, out) directly below it are left out.
std::vector<Document> pages_below(const std::filesystem::path& folder);

// The links of the pages that lead to no file, or to no heading of a page, each as PAGE: LINK.
std::vector<std::string> dead_links(const std::filesystem::path& folder);

}  // namespace airlight::test
