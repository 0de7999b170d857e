package nephele.editor.session;

import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;

/** The values of all settings of the editor; immutable. Entries that are unknown or broken stay in the file. */
public final class EditorSettings {
    /** The settings at the first start. */
    public static final EditorSettings DEFAULT = new EditorSettings(new JsonObject());

    private final JsonObject entries;

    private EditorSettings(JsonObject entries) {
        this.entries = entries;
    }

    /**
     * Returns the settings of a file's entries.
     *
     * @param report receives a line for each broken or unknown entry: its key and what is expected
     */
    static EditorSettings of(JsonObject entries, Consumer<String> report) {
        JsonObject kept = entries.deepCopy();
        EditorSetting.FORMER.forEach(kept::remove);
        for (Map.Entry<String, JsonElement> entry : kept.entrySet()) {
            Optional<EditorSetting<?>> setting = EditorSetting.ALL.stream()
                    .filter(each -> each.key().equals(entry.getKey()))
                    .findFirst();
            if (setting.isEmpty()) {
                report.accept(entry.getKey() + ": is not a setting of this version; it is left as it is");
            } else if (setting.get().read(entry.getValue()).isEmpty()) {
                report.accept(entry.getKey() + ": must be " + setting.get().expected() + "; it is left as it is");
            }
        }
        return new EditorSettings(kept);
    }

    /** Returns the value of a setting. */
    public <T> T get(EditorSetting<T> setting) {
        return Optional.ofNullable(entries.get(setting.key()))
                .flatMap(setting::read)
                .orElse(setting.absent());
    }

    /**
     * Returns these settings with another value, which replaces a broken entry.
     *
     * @throws IllegalArgumentException if the setting does not have that value
     */
    public <T> EditorSettings with(EditorSetting<T> setting, T value) {
        JsonElement written = setting.written(value);
        if (setting.read(written).isEmpty()) {
            throw new IllegalArgumentException(setting.key() + ": " + value + " is not " + setting.expected());
        }
        JsonObject changed = entries.deepCopy();
        changed.add(setting.key(), written);
        return new EditorSettings(changed);
    }

    /** Returns these settings with a file as the most recent one; the oldest of more than 20 is dropped. */
    public EditorSettings withRecent(Path file) {
        String path = file.toAbsolutePath().normalize().toString();
        List<String> recent = new ArrayList<>(get(EditorSetting.RECENT_FILES));
        recent.remove(path);
        recent.add(0, path);
        return with(
                EditorSetting.RECENT_FILES,
                List.copyOf(recent.subList(0, Math.min(recent.size(), EditorSetting.MOST_RECENT_FILES))));
    }

    JsonObject entries() {
        return entries.deepCopy();
    }
}
