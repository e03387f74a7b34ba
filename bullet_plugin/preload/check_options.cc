// Checks the options of DGD_BULLET_OPTIONS for dgd-bullet-run, before the program starts: 0 if they are right, else one
// sentence on the error stream, and 2.
#include <cstdio>
#include <cstdlib>
#include <exception>

#include "dgd_bullet/option_text.h"
#include "dgd_bullet/register.h"
#include "environment.h"

int main() {
  const char* text = std::getenv(dgd_preload::kOptions);
  if (text == nullptr) return 0;
  try {
    dgd_bullet::MakeNarrowphase(dgd_bullet::ParseOptions(text));
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "dgd-bullet-run: %s\n", error.what());
    return 2;
  }
}
