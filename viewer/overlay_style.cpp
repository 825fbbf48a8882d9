#include "viewer/overlay_style.h"

#include <algorithm>
#include <string_view>

#include "viewer/font.h"
#include "viewer/viewer.h"

namespace sir::viewer {
namespace {

// A line of the key sheet; a heading has no keys.
struct SheetLine {
  std::string keys;
  std::string_view name;
};

std::string keys_text(const CommandInfo& info) {
  std::string text;
  for (const std::string_view key : info.keys) text.append(text.empty() ? "" : ", ").append(key);
  return text;
}

// The groups one after the other, planes 1 to 8 as one line.
std::vector<SheetLine> sheet_lines() {
  std::vector<std::string_view> groups;
  for (const CommandInfo& info : commands())
    if (std::find(groups.begin(), groups.end(), info.group) == groups.end())
      groups.push_back(info.group);
  std::vector<SheetLine> lines;
  for (const std::string_view group : groups) {
    lines.push_back({"", group});
    for (const CommandInfo& info : commands()) {
      if (info.group != group) continue;
      if (info.command == Command::plane_1) lines.push_back({"1 ... 8", "A plane on or off"});
      else if (info.command < Command::plane_1 || info.command > Command::plane_8)
        lines.push_back({keys_text(info), info.name});
    }
  }
  lines.push_back({"", "Mouse"});
  lines.push_back({"wheel", "Zoom about the place that is pointed at"});
  lines.push_back({"drag", "Move the picture, or the line of a duel"});
  lines.push_back({"click", "Keep the inspector at a pixel; again: let it go"});
  lines.push_back({"right held", "Reference"});
  lines.push_back({"drop a file", "Open it"});
  return lines;
}

}  // namespace

int block_width(const std::vector<std::string>& lines, int scale) {
  int width = 0;
  for (const std::string& line : lines) width = std::max(width, text_width(line, scale));
  return width + 2 * kMargin;
}

int block_height(std::size_t lines, int scale) {
  return static_cast<int>(lines) * kLinePitch * scale + 2 * kMargin;
}

void draw_block(Canvas& canvas, Place corner, const std::vector<std::string>& lines, int scale) {
  canvas.fill({corner.x, corner.y, block_width(lines, scale), block_height(lines.size(), scale)},
              kPanel);
  int y = corner.y + kMargin;
  for (const std::string& line : lines) {
    canvas.text(corner.x + kMargin, y, line, line.starts_with(' ') ? kInk : kAccent, scale);
    y += kLinePitch * scale;
  }
}

int strip_height(const Viewer& viewer, int scale) {
  return viewer.message().empty() ? 0 : kLinePitch * scale + 2 * kMargin;
}

void draw_key_sheet(Canvas& canvas, int scale) {
  const std::vector<SheetLine> lines = sheet_lines();
  int keys_width = 0, names_width = 0;
  for (const SheetLine& line : lines) {
    keys_width = std::max(keys_width, text_width(line.keys, scale));
    names_width = std::max(names_width, text_width(line.name, scale));
  }
  const int gap = 2 * kLetterWidth * scale;
  const int column = keys_width + gap + names_width + gap;
  // As many columns as the lines need, at most two; letters shrink where even that is too much.
  const int room = std::max(1, (canvas.size().height - 4 * kMargin) / (kLinePitch * scale));
  const int columns = static_cast<int>(lines.size()) > room ? 2 : 1;
  const int width = columns * column + 2 * kMargin;
  const int rows = (static_cast<int>(lines.size()) + columns - 1) / columns;
  if (scale > 1 && (width > canvas.size().width || rows > room))
    return draw_key_sheet(canvas, scale - 1);
  const int height = rows * kLinePitch * scale + 2 * kMargin;
  const Rectangle sheet{std::max(0, (canvas.size().width - width) / 2),
                        std::max(0, (canvas.size().height - height) / 2), width, height};
  canvas.fill(sheet, kPanel);
  canvas.frame(sheet, kFaint);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const int index = static_cast<int>(i);
    const int x = sheet.x + kMargin + index / rows * column;
    const int y = sheet.y + kMargin + index % rows * kLinePitch * scale;
    if (lines[i].keys.empty()) canvas.text(x, y, lines[i].name, kAccent, scale);
    canvas.text(x, y, lines[i].keys, kFaint, scale);
    if (!lines[i].keys.empty()) canvas.text(x + keys_width + gap, y, lines[i].name, kInk, scale);
  }
}

void draw_prompt(Canvas& canvas, const Prompt& prompt, int scale) {
  const std::string_view question =
      prompt.kind() == Prompt::Kind::pixel ? "column, row: " : "command: ";
  const int pitch = kLinePitch * scale + 2;
  const int width = std::min(60 * kLetterWidth * scale + 2 * kMargin, canvas.size().width);
  const int room = std::max(1, (canvas.size().height / 2) / pitch);
  const int shown = std::min(static_cast<int>(prompt.found().size()), room);
  // The list follows what is chosen.
  const int first = std::max(0, static_cast<int>(prompt.chosen()) - shown + 1);
  const int left = (canvas.size().width - width) / 2, top = 8;
  const Rectangle panel{left, top, width, (shown + 1) * pitch + 2 * kMargin};
  canvas.fill(panel, kPanel);
  canvas.frame(panel, kFaint);
  int y = top + kMargin;
  const int end = canvas.text(left + kMargin, y, question, kFaint, scale);
  const int cursor = canvas.text(end, y, prompt.text(), kInk, scale);
  canvas.fill({cursor, y, scale, kLetterHeight * scale}, kAccent);
  for (int i = first; i < first + shown; ++i) {
    y += pitch;
    const CommandInfo& info = *prompt.found()[static_cast<std::size_t>(i)];
    if (static_cast<std::size_t>(i) == prompt.chosen())
      canvas.fill({left + 1, y - 1, width - 2, pitch}, kChosen);
    canvas.text(left + kMargin, y, info.name, kInk, scale);
    const std::string keys = keys_text(info);
    canvas.text(left + width - kMargin - text_width(keys, scale), y, keys, kFaint, scale);
  }
}

}  // namespace sir::viewer
