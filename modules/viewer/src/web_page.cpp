#include <hybridfusion/viewer/web_page.hpp>

// The files are put into the library as they are.
#define HF_EMBED(symbol, file)              \
  asm(".section .rodata\n"                  \
      ".global " #symbol "_begin\n" #symbol \
      "_begin:\n"                           \
      ".incbin \"" HF_WEB_DIST "/" file     \
      "\"\n"                                \
      ".global " #symbol "_end\n" #symbol   \
      "_end:\n"                             \
      ".previous\n");                       \
  extern "C" const char symbol##_begin[];   \
  extern "C" const char symbol##_end[];

HF_EMBED(hf_web_index, "index.html")
HF_EMBED(hf_web_script, "viewer.js")
HF_EMBED(hf_web_style, "viewer.css")

namespace hybridfusion {

std::vector<ServedFile> viewer_page() {
  const auto bytes = [](const char* begin, const char* end) {
    return std::string_view(begin, static_cast<std::size_t>(end - begin));
  };
  return {{"/", "text/html; charset=utf-8", bytes(hf_web_index_begin, hf_web_index_end)},
          {"/viewer.js",
           "text/javascript; charset=utf-8",
           bytes(hf_web_script_begin, hf_web_script_end)},
          {"/viewer.css", "text/css; charset=utf-8", bytes(hf_web_style_begin, hf_web_style_end)}};
}

}  // namespace hybridfusion
