package nephele.app.settings;

import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import java.util.IdentityHashMap;
import java.util.Map;
import java.util.function.Consumer;

/**
 * The values of all settings; immutable. Entries that are unknown or broken count as absent and stay in the file.
 */
public final class GameSettings {
    public static final GameSettings DEFAULT = new GameSettings(new JsonObject());

    private final JsonObject entries;
    private final Map<GameSetting<?>, Object> values = new IdentityHashMap<>();

    private GameSettings(JsonObject entries) {
        this.entries = entries;
        Settings.ALL.forEach(setting -> values.put(setting, read(setting)));
    }

    private <T> T read(GameSetting<T> setting) {
        JsonElement entry = entries.get(setting.key());
        return entry == null ? setting.absent() : setting.values().read(entry).orElse(setting.absent());
    }

    /**
     * Returns the settings of a file's entries.
     *
     * @param report receives a line for each broken or unknown entry: its key and what is expected
     */
    public static GameSettings of(JsonObject entries, Consumer<String> report) {
        entries.entrySet().forEach(entry -> Settings.ALL.stream()
                .filter(setting -> setting.key().equals(entry.getKey()))
                .findFirst()
                .ifPresentOrElse(
                        setting -> {
                            if (setting.values().read(entry.getValue()).isEmpty()) {
                                report.accept(entry.getKey() + ": must be "
                                        + setting.values().expected() + "; it is left as it is");
                            }
                        },
                        () -> report.accept(
                                entry.getKey() + ": is not a setting of this version; it is left as it is")));
        return new GameSettings(entries.deepCopy());
    }

    /** Returns the value of a setting of {@link Settings#ALL}. Allocates nothing: frames ask for it. */
    @SuppressWarnings("unchecked") // read() has put a T there
    public <T> T get(GameSetting<T> setting) {
        return (T) values.get(setting);
    }

    /** Returns these settings with another value, which replaces a broken entry. */
    public <T> GameSettings with(GameSetting<T> setting, T value) {
        JsonObject changed = entries.deepCopy();
        changed.add(setting.key(), setting.values().write(value));
        return new GameSettings(changed);
    }

    /** Returns these settings after a step of one of them in the menu. */
    public <T> GameSettings stepped(GameSetting<T> setting, int step) {
        return with(setting, setting.values().stepped(get(setting), step));
    }

    /** Returns the entries of the file. */
    public JsonObject entries() {
        return entries.deepCopy();
    }
}
