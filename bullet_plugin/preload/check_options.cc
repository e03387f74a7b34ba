// Checks the options of DGD_BULLET_OPTIONS for dgd-bullet-run, before the program starts: 0 if they are right, else one
// sentence on the error stream, and 2.
#include <cstdio>
#include <cstdlib>
#include <exception>

#include "dgd_bullet/register.h"
#include "environment.h"
#include "option_text.h"

int main() {
  const char* text = std::getenv(dgd_preload::kOptions);
  if (text == nullptr) return 0;
  try {
    dgd_bullet::MakeNarrowphase(dgd_preload::ParseOptions(text));
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "dgd-bullet-run: %s\n", error.what());
    return 2;
  }
}
