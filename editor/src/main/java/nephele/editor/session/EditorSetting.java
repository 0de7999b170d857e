package nephele.editor.session;

import com.google.gson.JsonElement;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import nephele.engine.level.Language;

/** A setting of the editor: its key in the file, its values, and the one of a missing or broken entry. */
public final class EditorSetting<T> {
    /** The colours of the window. */
    public enum Theme {
        LIGHT,
        DARK
    }

    /** The most files that {@link #RECENT_FILES} holds. */
    public static final int MOST_RECENT_FILES = 20;

    /** The most keys that an action has. */
    public static final int MOST_KEYS = 4;

    public static final EditorSetting<Theme> THEME = of("theme", EntryKind.word(Theme.class), Theme.DARK);
    public static final EditorSetting<Integer> SCALE_PERCENT = of("scalePercent", EntryKind.whole(100, 200), 100);
    public static final EditorSetting<Language> LANGUAGE = of("language", EntryKind.word(Language.class), Language.EN);

    /** The name of an arrangement of panes; what names there are is the window's affair. */
    public static final EditorSetting<String> PANE_ARRANGEMENT = of("paneArrangement", EntryKind.text(), "");

    /** Places of splitters by name, as fractions of their length. */
    public static final EditorSetting<Map<String, Double>> SPLITTERS =
            of("splitters", EntryKind.map(EntryKind.fraction()), Map.of());

    /** Panels by name that are visible or hidden otherwise than at the first start. */
    public static final EditorSetting<Map<String, Boolean>> PANELS =
            of("panels", EntryKind.map(EntryKind.flag()), Map.of());

    /** Paths, the newest first. */
    public static final EditorSetting<List<String>> RECENT_FILES =
            of("recentFiles", EntryKind.list(EntryKind.text(), MOST_RECENT_FILES), List.of());

    /** Keys by action id, for actions whose keys the user has changed; an empty list takes them away. */
    public static final EditorSetting<Map<String, List<String>>> KEYS =
            of("keys", EntryKind.map(EntryKind.list(EntryKind.text(), MOST_KEYS)), Map.of());

    /** Whether perspective panes show the grid of the ground, and lit ones the edges of brushes. */
    public static final EditorSetting<Boolean> GUIDE_LINES = of("guideLines", EntryKind.flag(), true);

    public static final EditorSetting<Boolean> GUIDE_FINISHED = of("guideFinished", EntryKind.flag(), false);

    /** All settings, in the order of the file. */
    public static final List<EditorSetting<?>> ALL = List.of(
            THEME,
            SCALE_PERCENT,
            LANGUAGE,
            PANE_ARRANGEMENT,
            SPLITTERS,
            PANELS,
            RECENT_FILES,
            KEYS,
            GUIDE_LINES,
            GUIDE_FINISHED);

    /** Keys of settings of earlier versions that mean nothing any more. */
    static final List<String> FORMER = List.of("viewport");

    private final String key;
    private final EntryKind<T> kind;
    private final T absent;

    private EditorSetting(String key, EntryKind<T> kind, T absent) {
        this.key = key;
        this.kind = kind;
        this.absent = absent;
    }

    private static <T> EditorSetting<T> of(String key, EntryKind<T> kind, T absent) {
        return new EditorSetting<>(key, kind, absent);
    }

    /** Returns the setting's name in the file. */
    public String key() {
        return key;
    }

    /** Returns the value of a missing or broken entry. */
    public T absent() {
        return absent;
    }

    /** Returns the values in words, for messages. */
    String expected() {
        return kind.expected();
    }

    Optional<T> read(JsonElement entry) {
        return kind.read().apply(entry);
    }

    JsonElement written(T value) {
        return kind.write().apply(value);
    }
}
