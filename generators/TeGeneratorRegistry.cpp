#include "generators/TeGeneratorRegistry.h"

#include "generators/TeBuiltInGenerators.h"
#include "generators/TeFilterChain.h"
#include "generators/TeSpecification.h"
#include "generators/base/TeText.h"

#include <algorithm>

namespace {

bool isName(const std::string& name) {
  return !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-';
  });
}

TeStatus setAll(const TeParameters& parameters, const TeSpecification& specification) {
  for (const auto& [name, value] : specification.parameters)
    if (TeStatus ok = teSetParameter(parameters, specification.name, name, value); !ok)
      return ok;
  return {};
}

std::string parametersHelp(const TeParameters& parameters) {
  std::string text;
  for (const TeParameter& p : parameters)
    text += "      " + p.name + "=" + teParameterText(p) + "  (" + teParameterRange(p) + ") " + p.help + "\n";
  return text;
}

} // namespace

TeGeneratorRegistry& TeGeneratorRegistry::instance() {
  static TeGeneratorRegistry registry;
  static const bool filled = (teAddBuiltInGenerators(registry), true);
  (void)filled;
  return registry;
}

TeStatus TeGeneratorRegistry::add(Entry entry) {
  if (!isName(entry.name))
    return TeError{"generator name " + teQuoted(entry.name) +
                   ": must be made of lower-case letters, digits and '-'"};
  if (!entry.generator && !entry.filter)
    return TeError{"generator name " + teQuoted(entry.name) + ": no factory"};
  const std::lock_guard<std::mutex> lock(m_mutex);
  for (const Entry& other : m_entries)
    if (other.name == entry.name)
      return TeError{"generator name " + teQuoted(entry.name) + ": is taken"};
  m_entries.push_back(std::move(entry));
  return {};
}

std::vector<TeGeneratorRegistry::Entry> TeGeneratorRegistry::entries() const {
  const std::lock_guard<std::mutex> lock(m_mutex);
  return m_entries;
}

TeStatus TeGeneratorRegistry::addGenerator(const std::string& name, const std::string& help,
                                           GeneratorFactory factory) {
  return add({name, help, std::move(factory), nullptr});
}

TeStatus TeGeneratorRegistry::addFilter(const std::string& name, const std::string& help,
                                        FilterFactory factory) {
  return add({name, help, nullptr, std::move(factory)});
}

std::vector<std::string> TeGeneratorRegistry::generatorNames() const {
  std::vector<std::string> names;
  for (const Entry& entry : entries())
    if (entry.generator)
      names.push_back(entry.name);
  return names;
}

std::vector<std::string> TeGeneratorRegistry::filterNames() const {
  std::vector<std::string> names;
  for (const Entry& entry : entries())
    if (entry.filter)
      names.push_back(entry.name);
  return names;
}

std::string TeGeneratorRegistry::help(std::string_view name) const {
  for (const Entry& entry : entries())
    if (entry.name == name)
      return entry.help;
  return {};
}

std::string TeGeneratorRegistry::helpText() const {
  std::string generators = "Generators (name:parameter=value,...):\n";
  std::string filters = "Filters (name:parameter=value,...):\n";
  for (const Entry& entry : entries()) {
    std::string& text = entry.generator ? generators : filters;
    text += "  " + entry.name + "  " + entry.help + "\n";
    if (entry.generator) {
      if (const std::unique_ptr<TeGenerator> made = entry.generator())
        text += parametersHelp(made->parameters());
    } else if (const std::unique_ptr<TeFilter> made = entry.filter()) {
      text += parametersHelp(made->parameters());
    }
  }
  return generators + filters;
}

TeResult<std::unique_ptr<TeGenerator>> TeGeneratorRegistry::generator(std::string_view specification) const {
  TeResult<TeSpecification> parsed = TeSpecification::parse(specification);
  if (!parsed)
    return parsed.error();
  for (const Entry& entry : entries()) {
    if (entry.name != parsed->name || !entry.generator)
      continue;
    std::unique_ptr<TeGenerator> made = entry.generator();
    if (!made)
      return TeError{"generator " + teQuoted(parsed->name) + ": its factory made none"};
    if (TeStatus ok = setAll(made->parameters(), *parsed); !ok)
      return ok.error();
    return made;
  }
  return TeError{"unknown generator " + teQuoted(parsed->name) +
                 teKnownNames(parsed->name, generatorNames())};
}

TeResult<std::unique_ptr<TeFilter>> TeGeneratorRegistry::filter(std::string_view specification) const {
  TeResult<TeSpecification> parsed = TeSpecification::parse(specification);
  if (!parsed)
    return parsed.error();
  for (const Entry& entry : entries()) {
    if (entry.name != parsed->name || !entry.filter)
      continue;
    std::unique_ptr<TeFilter> made = entry.filter();
    if (!made)
      return TeError{"filter " + teQuoted(parsed->name) + ": its factory made none"};
    if (TeStatus ok = setAll(made->parameters(), *parsed); !ok)
      return ok.error();
    return made;
  }
  return TeError{"unknown filter " + teQuoted(parsed->name) + teKnownNames(parsed->name, filterNames())};
}

TeResult<std::unique_ptr<TeGenerator>>
TeGeneratorRegistry::chain(std::string_view generatorText,
                           const std::vector<std::string>& filterTexts) const {
  TeResult<std::unique_ptr<TeGenerator>> base = generator(generatorText);
  if (!base || filterTexts.empty())
    return base;
  std::vector<std::unique_ptr<TeFilter>> filters;
  for (const std::string& text : filterTexts) {
    TeResult<std::unique_ptr<TeFilter>> made = filter(text);
    if (!made)
      return made.error();
    filters.push_back(std::move(*made));
  }
  return std::unique_ptr<TeGenerator>(std::make_unique<TeFilterChain>(std::move(*base), std::move(filters)));
}

TeResult<TeHeightSourcePtr> TeGeneratorRegistry::filtered(TeHeightSourcePtr source,
                                                          const std::vector<std::string>& filters) const {
  for (const std::string& specification : filters) {
    const TeResult<std::unique_ptr<TeFilter>> made = filter(specification);
    if (!made)
      return made.error();
    TeResult<TeHeightSourcePtr> over = (*made)->apply(std::move(source));
    if (!over)
      return over.error();
    source = std::move(*over);
  }
  return source;
}

TeResult<TeHeightSourcePtr> TeGeneratorRegistry::source(std::string_view generatorText,
                                                        const std::vector<std::string>& filterTexts) const {
  TeResult<std::unique_ptr<TeGenerator>> made = chain(generatorText, filterTexts);
  if (!made)
    return made.error();
  if (TeStatus ok = (*made)->updateParams(); !ok)
    return ok.error();
  return (*made)->source();
}

std::string teSpecification(std::string_view name, const TeParameters& parameters) {
  TeSpecification specification;
  specification.name = name;
  for (const TeParameter& parameter : parameters)
    specification.parameters.emplace_back(parameter.name, teParameterText(parameter));
  return specification.text();
}
