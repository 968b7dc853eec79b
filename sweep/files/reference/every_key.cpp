#include "sweep/files/reference/every_key.h"

#include "sweep/study/start/row_filler.h"
#include "sweep/study/start/starting_joint.h"

#include <algorithm>
#include <set>

namespace stickslip {
namespace {

std::string without_row(std::string path)
{
    for (std::size_t at = 0; (at = path.find(".0.", at)) != std::string::npos;) path.replace(at, 3, "[].");
    return path;
}

/// Friction on one of several bodies, or under a time lag, has the keys of [friction].
bool repeats_friction(std::string_view path)
{
    for (const std::string_view table : {"friction.motor.", "friction.transmission.", "friction.link."})
        if (path.starts_with(table)) return true;
    return path.starts_with("friction.curve.") && path != "friction.curve.law";
}

using Paths = std::set<std::string>;

class Collection {
  public:
    /// A joint of a model with a law, and the same with every other word of each of its choices.
    void add(Joint joint, const std::string& model, const std::string& law)
    {
        RowFiller filler{RowFiller::Lists::all};
        Joint::fields(joint, filler);
        const auto base = keys(joint);
        Paths any = note(base);
        for (const auto& choice : base) {
            const bool own = choice.path == "joint.model" || choice.path == "friction.law";
            if (choice.kind != KeyKind::choice || own || repeats_friction(choice.path)) continue;
            std::map<std::string, Paths> by_word;
            for (const auto& word : choice.words) {
                Joint other = joint;
                if (word == choice.value || choose(other, choice.path, word)) by_word[word] = note(keys(other));
            }
            for (const auto& [word, paths] : by_word) any.insert(paths.begin(), paths.end());
            note_where_they_differ(choice, by_word);
        }
        by_model_[model].insert(any.begin(), any.end());
        if (model == name_of_model(Model::single_mass)) by_law_[law] = any;
    }

    std::vector<ListedKey> listed() const
    {
        std::vector<ListedKey> list;
        for (const auto& key : order_) {
            ListedKey entry{key, {}};
            if (const auto choices = only_with_.find(key.path); choices != only_with_.end())
                entry.only_with = choices->second;
            // single-mass has the keys of [friction], other models have them on each body
            if (!key.path.starts_with("friction."))
                add_condition(entry, "joint.model", model_names(), by_model_);
            else
                add_condition(entry, "friction.law", law_names(), by_law_);
            list.push_back(std::move(entry));
        }
        return list;
    }

  private:
    static std::string name_of_model(Model model)
    {
        for (const auto& m : models)
            if (m.value == model) return std::string(m.name);
        return "";
    }
    static std::vector<std::string> model_names()
    {
        std::vector<std::string> names;
        for (const auto& m : models) names.emplace_back(m.name);
        return names;
    }
    static std::vector<std::string> law_names()
    {
        std::vector<std::string> names;
        for (const auto& law : laws()) names.emplace_back(law.name);
        return names;
    }

    static void add_condition(ListedKey& entry, const std::string& choice, const std::vector<std::string>& words,
                              const std::map<std::string, Paths>& by_word)
    {
        std::vector<std::string> with;
        for (const auto& word : words)
            if (const auto paths = by_word.find(word); paths != by_word.end() && paths->second.contains(entry.key.path))
                with.push_back(word);
        if (with.size() < words.size()) entry.only_with[choice] = with;
    }

    /// A key that some words of a choice bring and others do not depends on it.
    void note_where_they_differ(const Key& choice, const std::map<std::string, Paths>& by_word)
    {
        Paths any;
        for (const auto& [word, paths] : by_word) any.insert(paths.begin(), paths.end());
        for (const auto& path : any) {
            std::vector<std::string> with;
            for (const auto& word : choice.words)
                if (const auto paths = by_word.find(word); paths != by_word.end() && paths->second.contains(path))
                    with.push_back(word);
            if (with.size() < by_word.size()) only_with_[path][choice.path] = with;
        }
    }

    /// Takes the keys that are new, each behind the one before it in its file. Returns the paths of all keys found.
    Paths note(const std::vector<Key>& found)
    {
        Paths paths;
        std::size_t behind = 0;
        for (auto key : found) {
            if (repeats_friction(key.path)) continue;
            key.path = without_row(key.path);
            paths.insert(key.path);
            const auto known =
                std::find_if(order_.begin(), order_.end(), [&](const Key& k) { return k.path == key.path; });
            if (known == order_.end())
                order_.insert(order_.begin() + static_cast<std::ptrdiff_t>(behind++), key);
            else
                behind = static_cast<std::size_t>(known - order_.begin()) + 1;
        }
        return paths;
    }

    std::vector<Key> order_;
    std::map<std::string, Paths> by_model_, by_law_;
    std::map<std::string, std::map<std::string, std::vector<std::string>>> only_with_;  ///< by key, then choice
};

}  // namespace

std::vector<ListedKey> every_joint_key()
{
    Collection collection;
    for (const auto& model : models) {
        const auto add = [&](std::string_view law) {
            const std::string name(law);
            collection.add(starting_joint(model.value, name, Motion::prismatic), std::string(model.name), name);
        };
        if (model.value != Model::single_mass)
            add("stribeck");
        else
            for (const auto& law : laws()) add(law.name);
    }
    return collection.listed();
}

}  // namespace stickslip
