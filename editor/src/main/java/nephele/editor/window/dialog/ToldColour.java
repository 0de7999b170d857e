package nephele.editor.window.dialog;

import com.formdev.flatlaf.FlatLaf;
import java.awt.Color;

/** The colour of texts that tell what is wrong, legible in the theme in use. */
public final class ToldColour {
    private static final Color ON_DARK = new Color(0xff8a80);
    private static final Color ON_LIGHT = new Color(0xb3261e);

    private ToldColour() {}

    /** Returns the colour for the theme in use. */
    public static Color error() {
        return FlatLaf.isLafDark() ? ON_DARK : ON_LIGHT;
    }
}
