package nephele.app.settings;

import java.util.Collections;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import nephele.app.settings.GameSetting.Group;
import nephele.app.window.Control;
import nephele.app.window.KeyBindings;
import nephele.app.window.Size;
import nephele.app.window.WindowMode;
import nephele.engine.level.Language;
import nephele.engine.scene.ShotPalette;

/** All settings of the game. */
public final class Settings {
    /** A switch. */
    public enum Switch {
        OFF,
        ON
    }

    /** The effect of the crouch key. */
    public enum Crouch {
        /** Crouched while the key is held. */
        HOLD,
        /** Each press changes the stance. */
        TOGGLE
    }

    /** A quality preset, or its automatic choice. */
    public enum QualityPreset {
        LOW,
        MEDIUM,
        HIGH,
        ULTRA,
        AUTO
    }

    /** The rate at which the view turns upright after a portal. */
    public enum Upright {
        SLOW,
        NORMAL,
        FAST,
        INSTANT
    }

    /** Aids for the player: see {@link nephele.engine.sim.state.Assist}. */
    public enum Assists {
        NONE,
        USUAL,
        ALL
    }

    /** The least number of frames a second that a player can ask for. */
    private static final double LEAST_RATE = 10;

    public static final GameSetting<Language> LANGUAGE = GameSetting.word("language", Language.EN);

    /** The value of {@link #RESOLUTION} that states no size. */
    public static final String AUTO_RESOLUTION = "auto";

    /** The smallest value of {@link #RESOLUTION}. */
    public static final String LEAST_RESOLUTION = "640x360";

    /** The horizontal field of view at an aspect of 16:9; the vertical one is the same in every window. */
    public static final GameSetting<Double> FIELD_OF_VIEW =
            GameSetting.number("horizontalFovDegrees", 60, 110, 5, 90).in(Group.VIEW);

    public static final GameSetting<Double> MOUSE_SPEED =
            GameSetting.number("mouseSpeed", 0.1, 5, 0.1, 1).in(Group.VIEW);
    public static final GameSetting<Switch> INVERT_MOUSE =
            GameSetting.word("invertMouse", Switch.OFF).in(Group.VIEW);
    public static final GameSetting<Crouch> CROUCH =
            GameSetting.word("crouch", Crouch.HOLD).in(Group.AIDS);
    public static final GameSetting<QualityPreset> QUALITY =
            GameSetting.word("quality", QualityPreset.AUTO).in(Group.PICTURE);
    public static final GameSetting<WindowMode> WINDOW_MODE =
            GameSetting.word("windowMode", WindowMode.WINDOWED).in(Group.WINDOW);
    /**
     * The window's size, or the video mode of a full screen. {@code auto} keeps the window's size and the screen's own
     * video mode.
     */
    public static final GameSetting<String> RESOLUTION = GameSetting.choice(
                    "resolution",
                    List.of(
                            AUTO_RESOLUTION,
                            LEAST_RESOLUTION,
                            "960x540",
                            "1280x720",
                            "1600x900",
                            "1920x1080",
                            "1920x1200",
                            "2560x1080",
                            "2560x1440",
                            "3440x1440",
                            "3840x2160"))
            .in(Group.WINDOW);

    public static final GameSetting<Switch> VERTICAL_SYNC =
            GameSetting.word("verticalSync", Switch.ON).in(Group.WINDOW);

    /** Frames a second; 0 for no cap. */
    public static final GameSetting<Double> FRAME_CAP =
            GameSetting.rate("frameCap", LEAST_RATE, 360, 30).in(Group.WINDOW);

    /** Off leaves out the preset's antialiasing, but for its samples. */
    public static final GameSetting<Switch> ANTIALIASING =
            GameSetting.word("antialiasing", Switch.ON).in(Group.PICTURE);

    /** Frames a second that automatic quality holds; 0 for 60 on a graphics card and 30 on a software renderer. */
    public static final GameSetting<Double> AUTO_FRAME_RATE =
            GameSetting.rate("autoFrameRate", LEAST_RATE, 240, 15).in(Group.PICTURE);

    public static final GameSetting<Assists> ASSISTS =
            GameSetting.word("assists", Assists.USUAL).in(Group.AIDS);
    public static final GameSetting<Upright> UPRIGHT =
            GameSetting.word("uprightSpeed", Upright.NORMAL).in(Group.COMFORT);
    public static final GameSetting<ShotPalette> PORTAL_COLOURS =
            GameSetting.word("portalColours", ShotPalette.BLUE_ORANGE).in(Group.COMFORT);
    public static final GameSetting<Switch> REDUCED_MOTION =
            GameSetting.word("reducedMotion", Switch.OFF).in(Group.COMFORT);
    /** Lightning dimmer and slower, see {@link nephele.engine.level.appearance.FlashStyle#SOFTENED}. */
    public static final GameSetting<Switch> REDUCED_FLASHES =
            GameSetting.word("reducedFlashes", Switch.OFF).in(Group.COMFORT);

    /** The keys of each control. */
    public static final Map<Control, GameSetting<List<String>>> KEYS = keys();

    /** The settings of the menu; within a group they stand in this order. */
    public static final List<GameSetting<?>> PAGE = List.of(
            LANGUAGE,
            QUALITY,
            AUTO_FRAME_RATE,
            ANTIALIASING,
            WINDOW_MODE,
            RESOLUTION,
            VERTICAL_SYNC,
            FRAME_CAP,
            FIELD_OF_VIEW,
            MOUSE_SPEED,
            INVERT_MOUSE,
            ASSISTS,
            CROUCH,
            UPRIGHT,
            REDUCED_MOTION,
            REDUCED_FLASHES,
            PORTAL_COLOURS);

    /** All settings of the file. */
    public static final List<GameSetting<?>> ALL =
            Stream.concat(PAGE.stream(), KEYS.values().stream()).toList();

    private Settings() {}

    private static Map<Control, GameSetting<List<String>>> keys() {
        Map<Control, GameSetting<List<String>>> keys = new EnumMap<>(Control.class);
        for (Control control : Control.values()) {
            if (control.canBeChanged()) {
                keys.put(control, GameSetting.keys("keys." + GameSetting.word(control), control.usualKeys()));
            }
        }
        return Collections.unmodifiableMap(keys);
    }

    /** Returns the chosen resolution; {@code null} if it is automatic. */
    public static Size resolution(GameSettings settings) {
        String chosen = settings.get(RESOLUTION);
        return chosen.equals(AUTO_RESOLUTION) ? null : Size.parse(chosen);
    }

    /** Returns the settings of a group, in the order of {@link #PAGE}. */
    public static List<GameSetting<?>> of(Group group) {
        return PAGE.stream().filter(setting -> setting.group() == group).toList();
    }

    /** Returns the keys of all controls. */
    public static KeyBindings bindings(GameSettings settings) {
        Map<Control, List<String>> keys = new EnumMap<>(Control.class);
        for (Control control : Control.values()) {
            keys.put(control, control.canBeChanged() ? settings.get(KEYS.get(control)) : control.usualKeys());
        }
        return KeyBindings.of(keys);
    }
}
