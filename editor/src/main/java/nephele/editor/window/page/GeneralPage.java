package nephele.editor.window.page;

import java.awt.Desktop;
import java.awt.GraphicsEnvironment;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.function.Function;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JLabel;
import javax.swing.JPanel;
import nephele.editor.session.EditorSession;
import nephele.editor.session.EditorSetting;
import nephele.editor.session.EditorSetting.Theme;
import nephele.editor.widget.WordCell;
import nephele.engine.level.Language;
import net.miginfocom.swing.MigLayout;

/** Language, theme, scale and files. Changes hold at once. */
final class GeneralPage extends JPanel {
    private static final long serialVersionUID = 1;
    private static final List<Integer> SCALES = List.of(100, 125, 150, 175, 200);

    private final transient EditorSession session;
    private final transient Runnable changed;
    private final JLabel folder = new JLabel(" ");

    /**
     * @param settingsFile {@code null} if there is none
     * @param changed called after each change
     */
    GeneralPage(EditorSession session, Path settingsFile, Runnable changed) {
        super(new MigLayout("insets 14, gap 10 10, wrap 2", "[]16[grow]", ""));
        this.session = session;
        this.changed = changed;
        Language language = session.language();
        choice(PageText.LANGUAGE, EditorSetting.LANGUAGE, Arrays.asList(Language.values()), Language::title);
        choice(PageText.THEME, EditorSetting.THEME, Arrays.asList(Theme.values()), theme -> (theme == Theme.LIGHT
                        ? PageText.LIGHT
                        : PageText.DARK)
                .in(language));
        choice(PageText.SCALE, EditorSetting.SCALE_PERCENT, SCALES, percent -> percent + " %");
        if (settingsFile != null) {
            JButton open = new JButton(PageText.OPEN_FOLDER.in(language));
            open.addActionListener(event -> open(settingsFile.toAbsolutePath().getParent()));
            add(open, "skip 1");
            add(folder, "skip 1, wmin 0");
        }
    }

    private <T> void choice(PageText name, EditorSetting<T> setting, List<T> values, Function<T, String> text) {
        JComboBox<Object> combo = new JComboBox<>(values.toArray());
        T now = session.settings().get(setting);
        if (!values.contains(now)) {
            combo.addItem(now);
        }
        combo.setSelectedItem(now);
        combo.setRenderer(new WordCell<>(text));
        combo.setName(setting.key());
        combo.addActionListener(event -> set(setting, combo));
        JLabel label = new JLabel(name.in(session.language()));
        label.setLabelFor(combo);
        combo.getAccessibleContext().setAccessibleName(label.getText());
        add(label);
        add(combo, "wmin 220lp");
    }

    @SuppressWarnings("unchecked") // only values of this setting are in the list
    private <T> void set(EditorSetting<T> setting, JComboBox<Object> combo) {
        T value = (T) combo.getSelectedItem();
        if (value != null && !value.equals(session.settings().get(setting))) {
            session.settings(session.settings().with(setting, value));
            changed.run();
        }
    }

    /** Opens the folder in the user's file manager, or at least tells where it is. */
    private void open(Path place) {
        folder.setText(PageText.FOLDER_IS.with(place).in(session.language()));
        folder.setToolTipText(place.toString());
        boolean canOpen = !GraphicsEnvironment.isHeadless()
                && Desktop.isDesktopSupported()
                && Desktop.getDesktop().isSupported(Desktop.Action.OPEN);
        if (canOpen) {
            try {
                Files.createDirectories(place);
                Desktop.getDesktop().open(place.toFile());
            } catch (IOException problem) {
                folder.setText(problem.getMessage());
            }
        }
    }
}
