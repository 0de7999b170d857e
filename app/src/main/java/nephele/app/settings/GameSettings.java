package nephele.app.settings;

import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import nephele.app.settings.Settings.Switch;
import nephele.engine.level.appearance.FlashStyle;
import nephele.engine.sim.state.Assist;
import nephele.engine.sim.state.SimSettings;
import nephele.host.draw.QualityChoice;
import nephele.host.playthrough.PictureMotion;

/**
 * The values of all settings, and what they mean for the parts of the game; immutable. Entries that are unknown or broken count as absent and stay in the file.
 */
public final class GameSettings {
    public static final GameSettings DEFAULT = new GameSettings(new JsonObject());

    /** The width of pictures for which the horizontal field of view is stated, relative to their height. */
    private static final double ASPECT = 16.0 / 9;

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

    /** Returns the vertical field of view, the same for every window. */
    public double verticalFovDegrees() {
        double half = Math.toRadians(get(Settings.FIELD_OF_VIEW)) / 2;
        return 2 * Math.toDegrees(Math.atan(Math.tan(half) / ASPECT));
    }

    /** Returns the quality of pictures. */
    public QualityChoice quality() {
        Map<String, String> more = get(Settings.ANTIALIASING) == Switch.OFF ? Map.of("antialiasing", "none") : Map.of();
        return new QualityChoice(GameSetting.word(get(Settings.QUALITY)), more);
    }

    /** Returns the settings of the simulation. */
    public SimSettings simulation() {
        return new SimSettings(SimSettings.DEFAULT.ticksPerSecond(), assists(), uprightRate());
    }

    private List<Assist> assists() {
        return switch (get(Settings.ASSISTS)) {
            case NONE -> List.of();
            case USUAL -> Assist.USUAL;
            case ALL -> List.of(Assist.values());
        };
    }

    private int uprightRate() {
        if (get(Settings.REDUCED_MOTION) == Switch.ON) {
            return SimSettings.INSTANT_UPRIGHT_DEGREES_PER_SECOND;
        }
        return switch (get(Settings.UPRIGHT)) {
            case SLOW -> SimSettings.DEFAULT_UPRIGHT_DEGREES_PER_SECOND / 2;
            case NORMAL -> SimSettings.DEFAULT_UPRIGHT_DEGREES_PER_SECOND;
            case FAST -> 2 * SimSettings.DEFAULT_UPRIGHT_DEGREES_PER_SECOND;
            case INSTANT -> SimSettings.INSTANT_UPRIGHT_DEGREES_PER_SECOND;
        };
    }

    /** Returns how much the picture moves by itself. */
    public PictureMotion motion() {
        return get(Settings.REDUCED_MOTION) == Switch.ON ? PictureMotion.REDUCED : PictureMotion.FULL;
    }

    /** Returns how flashes of lightning come and go. */
    public FlashStyle flashStyle() {
        return get(Settings.REDUCED_FLASHES) == Switch.ON ? FlashStyle.SOFTENED : FlashStyle.NATURAL;
    }
}
