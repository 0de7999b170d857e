package nephele.editor.window;

import com.formdev.flatlaf.FlatDarkLaf;
import com.formdev.flatlaf.FlatLightLaf;
import nephele.editor.session.EditorSetting;
import nephele.editor.session.EditorSetting.Theme;
import nephele.editor.session.EditorSettings;

/** Theme and scale of all windows. */
public final class WindowLook {
    private WindowLook() {}

    /** Sets the look and feel that the settings ask for; components that exist have to be updated after it. */
    public static void apply(EditorSettings settings) {
        // The scale is read while the look and feel is set.
        System.setProperty("flatlaf.uiScale", settings.get(EditorSetting.SCALE_PERCENT) + "%");
        if (settings.get(EditorSetting.THEME) == Theme.DARK) {
            FlatDarkLaf.setup();
        } else {
            FlatLightLaf.setup();
        }
    }

    /** Returns true if two settings need another look and feel. */
    static boolean differs(EditorSettings before, EditorSettings after) {
        return before.get(EditorSetting.THEME) != after.get(EditorSetting.THEME)
                || !before.get(EditorSetting.SCALE_PERCENT).equals(after.get(EditorSetting.SCALE_PERCENT));
    }
}
