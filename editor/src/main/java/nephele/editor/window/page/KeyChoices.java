package nephele.editor.window.page;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import nephele.editor.action.EditorCommand;
import nephele.editor.action.EditorKeys;
import nephele.editor.action.KeyText;
import nephele.editor.session.EditorSetting;
import nephele.editor.session.EditorSettings;

/** The keys that a user has chosen instead of the defaults, as the settings keep them. */
public final class KeyChoices {
    private final List<EditorCommand> commands;
    private final EditorSettings settings;

    public KeyChoices(List<EditorCommand> commands, EditorSettings settings) {
        this.commands = List.copyOf(commands);
        this.settings = settings;
    }

    /** Returns the keys in use. */
    public EditorKeys keys() {
        return new EditorKeys(commands, settings.get(EditorSetting.KEYS));
    }

    /** Returns the settings with exactly these keys of a command; its defaults leave no entry. */
    public EditorSettings with(EditorCommand command, List<KeyText> keys) {
        Map<String, List<String>> chosen = new LinkedHashMap<>(settings.get(EditorSetting.KEYS));
        List<KeyText> defaults = command.keys().stream()
                .flatMap(text -> KeyText.parse(text).stream())
                .toList();
        if (keys.equals(defaults)) {
            chosen.remove(command.id());
        } else {
            chosen.put(command.id(), keys.stream().map(KeyText::text).toList());
        }
        return settings.with(EditorSetting.KEYS, chosen);
    }

    /** Returns the settings with one more key of a command; the oldest goes if there are too many. */
    public EditorSettings withAdded(EditorCommand command, KeyText key) {
        List<KeyText> all = Stream.concat(keys().of(command.id()).stream(), Stream.of(key))
                .distinct()
                .toList();
        return with(command, all.subList(Math.max(0, all.size() - EditorSetting.MOST_KEYS), all.size()));
    }

    /** Returns the settings with the default keys of a command. */
    public EditorSettings reset(EditorCommand command) {
        Map<String, List<String>> chosen = new LinkedHashMap<>(settings.get(EditorSetting.KEYS));
        chosen.remove(command.id());
        return settings.with(EditorSetting.KEYS, chosen);
    }

    /** Returns the settings with the default keys of all commands. */
    public EditorSettings resetAll() {
        return settings.with(EditorSetting.KEYS, Map.of());
    }
}
