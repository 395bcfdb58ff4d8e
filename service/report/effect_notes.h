// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace slipstitch {

/// What an effect is, when a scene needs it, what it costs, and what is wrong without it. One paragraph for every
/// effect of effect_list(); empty for other names.
std::string_view effect_note(std::string_view effect);

/// The same of handles and loads, which are no effects.
std::string_view handles_note();

/// All of them as a Markdown chapter, in the order of effect_list().
std::string effect_notes_markdown();

}  // namespace slipstitch
