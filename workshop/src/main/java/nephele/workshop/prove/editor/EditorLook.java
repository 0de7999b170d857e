package nephele.workshop.prove.editor;

import java.awt.Dimension;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import nephele.editor.session.EditorSetting.Theme;
import nephele.editor.session.EditorSettings;
import nephele.engine.level.Language;

/** Theme, scale and language of the editor; the screen grows with the scale, as screens do. */
record EditorLook(Theme theme, int percent, Language language) {
    private static final Dimension SMALL = new Dimension(1280, 800);
    private static final Dimension LARGE = new Dimension(1920, 1200);

    /** All looks; each three that follow each other have all languages and both themes and scales. */
    static final List<EditorLook> ALL = all();

    private static List<EditorLook> all() {
        List<EditorLook> looks = new ArrayList<>();
        int pairs = Theme.values().length * Language.values().length;
        for (int i = 0; i < 2 * pairs; i++) {
            Theme theme = Theme.values()[i % Theme.values().length];
            int percent = (i + i / pairs) % 2 == 0 ? 100 : 200;
            looks.add(new EditorLook(theme, percent, Language.values()[i % Language.values().length]));
        }
        return List.copyOf(looks);
    }

    EditorSettings settings() {
        return PaintedPanel.settings(theme, percent, language);
    }

    /** Returns the size of the whole window, pixels. */
    Dimension screen() {
        return percent > 100 ? LARGE : SMALL;
    }

    /** Returns the name that files of its pictures begin with. */
    String title() {
        return (theme + "-" + percent + "-" + language).toLowerCase(Locale.ROOT);
    }
}
