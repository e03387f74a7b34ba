// What a shared library of the solver exports.
#pragma once

/// Marks what templates in headers call; a shared library hides everything else.
#define DGD_EXPORT [[gnu::visibility("default")]]
