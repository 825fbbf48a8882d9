#include "cli/cost/svg_inline.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace sir::cli {
namespace {

constexpr std::array<std::string_view, 12> kElements{"svg",  "g",    "defs",    "path",
                                                     "rect", "line", "circle",  "polyline",
                                                     "text", "use",  "polygon", "tspan"};
constexpr std::array<std::string_view, 30> kAttributes{"d",
                                                       "x",
                                                       "y",
                                                       "dx",
                                                       "dy",
                                                       "x1",
                                                       "y1",
                                                       "x2",
                                                       "y2",
                                                       "cx",
                                                       "cy",
                                                       "r",
                                                       "rx",
                                                       "ry",
                                                       "width",
                                                       "height",
                                                       "points",
                                                       "transform",
                                                       "fill",
                                                       "stroke",
                                                       "color",
                                                       "opacity",
                                                       "font-size",
                                                       "fill-opacity",
                                                       "stroke-opacity",
                                                       "text-anchor",
                                                       "stroke-width",
                                                       "font-weight",
                                                       "stroke-linecap",
                                                       "stroke-linejoin"};

template <typename List>
bool has(const List& list, std::string_view name) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

struct Tag {
  std::string_view name;
  std::vector<std::pair<std::string_view, std::string_view>> attributes;
  bool closing = false, empty = false;
};

constexpr std::string_view kSpace = " \t\r\n";

// What stands between < and >; none where it is not well formed.
std::optional<Tag> parse_tag(std::string_view text) {
  Tag tag;
  if (text.starts_with('/')) {
    tag.closing = true;
    text.remove_prefix(1);
  } else if (text.ends_with('/')) {
    tag.empty = true;
    text.remove_suffix(1);
  }
  const auto end = std::min(text.find_first_of(kSpace), text.size());
  tag.name = text.substr(0, end);
  text.remove_prefix(end);
  while (true) {
    const auto from = text.find_first_not_of(kSpace);
    if (from == std::string_view::npos) return tag;
    const auto equals = text.find('=', from);
    if (equals == std::string_view::npos || equals + 1 >= text.size()) return std::nullopt;
    const char quote = text[equals + 1];
    const auto close = text.find(quote, equals + 2);
    if ((quote != '"' && quote != '\'') || close == std::string_view::npos) return std::nullopt;
    tag.attributes.emplace_back(text.substr(from, equals - from),
                                text.substr(equals + 2, close - equals - 2));
    text.remove_prefix(close + 1);
  }
}

class Copy {
 public:
  Copy(std::string_view svg, const std::string& prefix, const std::string& label)
      : svg_(svg), prefix_(prefix), label_(label) {}

  std::string operator()() {
    while (!svg_.empty()) {
      const auto open = std::min(svg_.find('<'), svg_.size());
      if (skipped_ == 0 && !groups_.empty()) text(svg_.substr(0, open));
      svg_.remove_prefix(open);
      if (svg_.empty()) break;
      const bool comment = svg_.starts_with("<!--");
      const auto close = comment ? svg_.find("-->") : svg_.find('>');
      if (close == std::string_view::npos) return {};
      const std::string_view inside = svg_.substr(1, close - 1);
      svg_.remove_prefix(close + (comment ? 3 : 1));
      if (inside.starts_with('?') || inside.starts_with('!')) continue;
      const auto tag = parse_tag(inside);
      if (!tag || !take(*tag)) return {};
    }
    return complete_ ? std::move(out_) : std::string();
  }

 private:
  // False where the document cannot be.
  bool take(const Tag& tag) {
    if (complete_ || (groups_.empty() && (tag.closing || tag.name != "svg"))) return false;
    if (tag.closing) return close(tag);
    if (skipped_ > 0 || !has(kElements, tag.name) || (tag.name == "svg" && !groups_.empty())) {
      skipped_ += !tag.empty;
      return true;
    }
    const std::size_t from = out_.size();
    out_ += "<" + std::string(tag.name);
    if (tag.name == "svg")
      out_ += " class=\"plot\" role=\"img\" aria-label=\"" + html_text(label_) + "\"";
    for (const auto& [name, value] : tag.attributes) attribute(tag, name, value);
    out_ += tag.empty ? "/>" : ">";
    if (!tag.empty) groups_.push_back({tag.name, from, out_.size()});
    return true;
  }

  bool close(const Tag& tag) {
    if (skipped_ > 0) {
      --skipped_;
      return true;
    }
    if (groups_.back().name != tag.name) return false;
    const Group group = groups_.back();
    groups_.pop_back();
    const bool nothing = out_.find_first_not_of(kSpace, group.content) == std::string::npos;
    if (group.name == "g" && nothing) out_.resize(group.from);
    else out_ += "</" + std::string(tag.name) + ">";
    complete_ = groups_.empty();
    return true;
  }

  void attribute(const Tag& tag, std::string_view name, std::string_view value) {
    std::string copy(value);
    if (name == "id") {
      copy = prefix_ + copy;
    } else if (name == "href" || name == "xlink:href") {
      if (!value.starts_with('#')) return;
      name = "href";
      copy = "#" + prefix_ + copy.substr(1);
    } else if (name == "viewBox") {
      if (tag.name != "svg") return;
    } else if (!has(kAttributes, name) || (tag.name == "svg" && name != "viewBox")) {
      return;
    }
    if (copy.find("url(") != std::string::npos) return;
    if (copy == "black" || copy == "rgb(  0,   0,   0)") copy = "currentColor";
    out_ += " " + std::string(name) + "=\"";
    for (const char c : copy) out_ += c == '"' ? "&quot;" : c == '<' ? "&lt;" : std::string(1, c);
    out_ += "\"";
  }

  // Only what is within <text> is to be seen; elsewhere it is white space.
  void text(std::string_view text) {
    const std::string_view around = groups_.back().name;
    if (around == "text" || around == "tspan") out_ += text;
  }

  struct Group {
    std::string_view name;
    std::size_t from, content;  // places in out_
  };

  std::string_view svg_;
  const std::string& prefix_;
  const std::string& label_;
  std::string out_;
  std::vector<Group> groups_;
  int skipped_ = 0;  // depth within what is left out
  bool complete_ = false;
};

}  // namespace

std::string inline_svg(std::string_view svg, const std::string& prefix, const std::string& label) {
  return Copy(svg, prefix, label)();
}

std::string html_text(std::string_view text) {
  std::string html;
  for (const char c : text) switch (c) {
      case '&': html += "&amp;"; break;
      case '<': html += "&lt;"; break;
      case '>': html += "&gt;"; break;
      case '"': html += "&quot;"; break;
      default: html += c;
    }
  return html;
}

}  // namespace sir::cli
