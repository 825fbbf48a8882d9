#include "cli/completion_script.h"

#include <map>
#include <vector>

#include <fmt/format.h>

#include "cli/command_line.h"
#include "cli/cost/knob.h"
#include "cli/metrics_command.h"
#include "cli/option_text.h"
#include "cli/option_values.h"

namespace sir::cli {
namespace {

// What does the work; the four functions before it hold the tables.
constexpr const char* kWork = R"bash(
# Files whose names end in one of the suffixes, and folders. Where $1 is `base` they are named
# without the suffix, as BASE is.
_sir_files() {
  local form=$1 suffix found name
  shift
  compopt -o filenames 2>/dev/null
  local typed=${cur//\\/}
  mapfile -t found < <(compgen -d -- "$typed")
  COMPREPLY+=("${found[@]}")
  for suffix in "$@"; do
    mapfile -t found < <(compgen -f -X "!*.$suffix" -- "$typed")
    for name in "${found[@]}"; do
      [[ -d $name ]] && continue
      [[ $form == base && $suffix != png ]] && name=${name%.*}
      COMPREPLY+=("$name")
    done
  done
}

# What can stand where a value of the form $1 is wanted.
_sir_value() {
  local found
  case $1 in
    DIR)
      compopt -o filenames 2>/dev/null
      mapfile -t COMPREPLY < <(compgen -d -- "${cur//\\/}")
      ;;
    BASE) _sir_files base CSG csg ;;
    IMAGE) _sir_files base R r CSG csg png ;;
    *.LUT) _sir_files whole LUT ;;
    *.png) _sir_files whole png ;;
    SCRIPT) _sir_files whole model ;;
    FILE)
      compopt -o filenames 2>/dev/null
      mapfile -t COMPREPLY < <(compgen -f -- "${cur//\\/}")
      ;;
    words:*) mapfile -t COMPREPLY < <(compgen -W "${1#words:}" -- "$cur") ;;
    names:*)
      compopt -o nospace 2>/dev/null
      mapfile -t COMPREPLY < <(compgen -W "${1#names:}" -S = -- "$cur")
      ;;
    list:*)
      compopt -o nospace 2>/dev/null
      local before=
      [[ $cur == *,* ]] && before=${cur%,*},
      mapfile -t found < <(compgen -W "${1#list:}" -- "${cur##*,}")
      COMPREPLY=("${found[@]/#/$before}")
      ;;
  esac
}

_sir() {
  local cur=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} command='' i
  local options value='' optional=''
  COMPREPLY=()
  # bash takes --option=value apart at the sign.
  if [[ $cur == = ]]; then
    cur=
  elif [[ $before == = ]]; then
    before=${COMP_WORDS[COMP_CWORD - 2]}
  fi
  for ((i = 1; i < COMP_CWORD; ++i)); do
    [[ ${COMP_WORDS[i]} == -* ]] && continue
    command=${COMP_WORDS[i]}
    break
  done
  if [[ -z $command ]]; then
    _sir_options ''
    if [[ $cur == -* ]]; then
      mapfile -t COMPREPLY < <(compgen -W "$options" -- "$cur")
    else
      mapfile -t COMPREPLY < <(compgen -W "$_sir_commands" -- "$cur")
    fi
    return
  fi
  _sir_form "$command" "$before"
  # A value that is not required comes only after the sign.
  if [[ -n $value && ( -z $optional || ${COMP_WORDS[COMP_CWORD]} == = ||
    ${COMP_WORDS[COMP_CWORD - 1]} == = ) ]]; then
    _sir_value "$value"
  elif [[ $cur == -* ]]; then
    _sir_options "$command"
    mapfile -t COMPREPLY < <(compgen -W "$options" -- "$cur")
  else
    _sir_positional "$command" "$((COMP_CWORD - i - 1))"
  fi
}

complete -F _sir sir
)bash";

std::string joined(const std::string& words, char from, char to) {
  std::string text = words;
  for (char& letter : text)
    if (letter == from) letter = to;
  return text;
}

// Options whose value is made of words that only the program knows.
std::string special(const std::string& name) {
  if (name == "--effects") return "list:auto all " + known_effects();
  if (name == "--only") return "list:" + known_knobs();
  if (name == "--fail-above" || name == "--fail-below")
    return fmt::format("names:{}", fmt::join(metric_names(), " "));
  return "";
}

// What _sir_value is to offer.
std::string form_of(const OptionText& option) {
  if (const std::string form = special(option.names.back()); !form.empty()) return form;
  if (!option.words.empty()) return fmt::format("words:{}", fmt::join(option.words, " "));
  return joined(option.value, ' ', '_');
}

std::string positional_form(const std::string& name) {
  if (name == "REF" || name == "SHOWN") return "IMAGE";
  return name;
}

std::string options_of(const std::vector<OptionText>& texts) {
  std::string names;
  for (const OptionText& text : texts) {
    if (text.positional) continue;
    for (const std::string& name : text.names) names += " " + name;
  }
  return names.substr(1);
}

// _sir_options COMMAND sets `options`: those of the command, or the global ones.
std::string options_function(const CLI::App& app) {
  const std::string global = options_of(option_texts(app));
  std::string text = "\n_sir_options() {\n  case $1 in\n";
  for (const CLI::App* sub : subcommands(app))
    text += fmt::format("    {}) options='{} -q -v' ;;\n", sub->get_name(),
                        options_of(option_texts(*sub)));
  return text + fmt::format("    *) options='{}' ;;\n  esac\n}}\n", global);
}

// _sir_form COMMAND OPTION sets `value` to what the option takes.
std::string form_function(const CLI::App& app) {
  std::string text = "\n_sir_form() {\n  case $1:$2 in\n";
  for (const CLI::App* sub : subcommands(app))
    for (const OptionText& option : option_texts(*sub)) {
      if (option.positional || option.value.empty()) continue;
      for (const std::string& name : option.names)
        text += fmt::format("    {}:{}) value='{}'{} ;;\n", sub->get_name(), name, form_of(option),
                            option.value_optional ? " optional=yes" : "");
    }
  return text + "  esac\n}\n";
}

// _sir_positional COMMAND offers files for what stands without an option.
std::string positional_function(const CLI::App& app) {
  std::string text = "\n_sir_positional() {\n  case $1 in\n";
  for (const CLI::App* sub : subcommands(app))
    for (const OptionText& option : option_texts(*sub)) {
      if (!option.positional) continue;
      text += fmt::format("    {}) _sir_value {} ;;\n", sub->get_name(),
                          positional_form(option.names.front()));
      break;
    }
  return text + "  esac\n}\n";
}

}  // namespace

std::string completion_script(const CLI::App& app) {
  std::vector<std::string> commands;
  for (const CLI::App* sub : subcommands(app)) commands.push_back(sub->get_name());
  return "# Completion of sir for bash. Made from the program's own options when it is built.\n" +
         fmt::format("_sir_commands='{}'\n", fmt::join(commands, " ")) + options_function(app) +
         form_function(app) + positional_function(app) + kWork;
}

}  // namespace sir::cli
