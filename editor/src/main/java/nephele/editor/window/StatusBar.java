package nephele.editor.window;

import com.formdev.flatlaf.FlatClientProperties;
import com.formdev.flatlaf.util.UIScale;
import java.util.Locale;
import java.util.Optional;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JSeparator;
import javax.swing.SwingConstants;
import nephele.editor.session.EditorSession;
import nephele.engine.level.Language;
import nephele.engine.math.Vec3;
import net.miginfocom.swing.MigLayout;

/** The line below the editor: the last message, or what the tool would do; the bake of light; the grid; the place under the pointer. */
final class StatusBar extends JPanel {
    private static final long serialVersionUID = 1;

    private final transient EditorSession session;
    private final JLabel message = new JLabel(" ");
    private final JLabel hint = new JLabel(" ");
    private final JLabel bake = new JLabel("");
    private final JLabel grid = new JLabel(" ");
    private final JLabel place = new JLabel(" ", SwingConstants.TRAILING);

    StatusBar(EditorSession session) {
        super(new MigLayout(
                "insets 3 8 3 8, fillx, gapx 8, hidemode 3", "[0:pref:][0:pref:,grow,left][][][][][]", "[]"));
        this.session = session;
        message.setName("message");
        hint.setName("hint");
        bake.setName("bake");
        grid.setName("grid");
        place.setName("place");
        message.putClientProperty(FlatClientProperties.STYLE, "font: bold");
        add(message, "wmin 0");
        add(hint, "wmin 0, growx");
        add(bake, "wmin pref");
        add(new JSeparator(SwingConstants.VERTICAL), "growy");
        add(grid, "wmin pref");
        add(new JSeparator(SwingConstants.VERTICAL), "growy");
        // The message and the hint give way, the numbers do not.
        add(place, "width 130lp::, growx");
        refresh();
    }

    /** Half a hint helps nobody: beside a message it is whole or not there, and the progress of a bake gives way to it. */
    @Override
    public void doLayout() {
        int numbers = grid.getPreferredSize().width
                + Math.max(UIScale.scale(130), place.getPreferredSize().width)
                + UIScale.scale(60);
        int texts = message.getPreferredSize().width + hint.getPreferredSize().width;
        boolean isVisible = message.getText().isBlank() || texts + numbers <= getWidth();
        boolean hasRoom = texts + numbers + bake.getPreferredSize().width <= getWidth();
        boolean isBakeVisible = !bake.getText().isEmpty() && hasRoom;
        if (bake.isVisible() != isBakeVisible) {
            bake.setVisible(isBakeVisible);
        }
        if (hint.isVisible() != isVisible) {
            hint.setVisible(isVisible);
        }
        super.doLayout();
    }

    /** Shows the session's texts in its language. */
    void refresh() {
        Language language = session.language();
        getAccessibleContext().setAccessibleName(WindowText.STATUS.in(language));
        show(message, session.status().in(language));
        showHint();
        bake.setText(session.bake().in(language));
        String step = number(session.grid().stepMetres(), "%.3f").replaceAll("\\.?0+$", "");
        grid.setText(WindowText.GRID.with(step).in(language));
    }

    private void showHint() {
        show(hint, session.tool().hint().in(session.language()));
    }

    /** A narrow bar cuts texts; their tooltips have the whole. */
    private static void show(JLabel label, String text) {
        if (!text.equals(label.getText())) {
            label.setText(text);
            label.setToolTipText(text.isEmpty() ? null : text);
        }
    }

    /** Shows the place under the pointer; none if it is outside. */
    void pointed(Optional<Vec3> at) {
        place.setText(at.map(p -> number(p.x(), "%.2f") + "  " + number(p.y(), "%.2f") + "  " + number(p.z(), "%.2f"))
                .orElse(" "));
        showHint();
    }

    private static String number(double value, String format) {
        return String.format(Locale.ROOT, format, value + 0.0);
    }
}
