package nephele.editor.window.page;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.event.KeyListener;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JLabel;
import javax.swing.JTextField;
import nephele.editor.action.Actions;
import nephele.editor.action.EditorCommand;
import nephele.editor.action.EditorCommands;
import nephele.editor.action.EditorKeys;
import nephele.editor.action.ScriptInterface;
import nephele.editor.save.DocumentFile;
import nephele.editor.session.EditorSession;
import nephele.editor.session.EditorSetting;
import nephele.editor.session.EditorSetting.Theme;
import nephele.editor.session.EditorSettings;
import nephele.editor.window.WindowLook;
import nephele.engine.level.Language;
import nephele.workshop.prove.editor.PaintedPanel;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The settings page without a display. */
@Execution(ExecutionMode.SAME_THREAD)
class SettingsPageSwingTest {
    private EditorSession session;
    private SettingsPage page;

    private void open(EditorSettings settings) {
        WindowLook.apply(settings);
        var level = DocumentFile.untitled();
        session = new EditorSession(level.file(), level.level(), level.assets(), settings);
        List<EditorCommand> commands = new EditorCommands(session, new ScriptInterface(() -> null), Actions.ALL).all();
        page = new SettingsPage(session, commands, Path.of("editor.json"), () -> {});
    }

    @ParameterizedTest
    @CsvSource({"DARK, 100, EN", "LIGHT, 100, PT_BR", "DARK, 200, PT_PT", "LIGHT, 200, PT_BR"})
    void nothingIsCutOff(Theme theme, int percent, Language language) throws Exception {
        open(PaintedPanel.settings(theme, percent, language));
        session.settings(session.settings().with(EditorSetting.KEYS, Map.of("copy", List.of("Ctrl+X"))));
        String look = "-" + theme + "-" + percent + "-" + language;
        List<String> cut = new ArrayList<>();
        cut.addAll(new PaintedPanel(page).write("settings" + look).clipped());
        open(session.settings());
        cut.addAll(new PaintedPanel(page.at(SettingsPage.Tab.KEYS))
                .write("keys" + look)
                .clipped());
        assertEquals(List.of(), cut);
    }

    private void choose(String id) {
        KeysPage keys = page.keys();
        PaintedPanel.all(keys, JTextField.class).get(0).setText(id);
        keys.table().setRowSelectionInterval(0, 0);
    }

    private void press(int modifiers, int code, char character) {
        JLabel capture = page.keys().capture();
        KeyEvent event = new KeyEvent(capture, KeyEvent.KEY_PRESSED, 0, modifiers, code, character);
        // Without a window nothing has the focus that keys go to.
        for (KeyListener listener : capture.getKeyListeners()) {
            listener.keyPressed(event);
        }
    }

    private void click(PageText text) {
        PaintedPanel.all(page, JButton.class).stream()
                .filter(button -> text.in(session.language()).equals(button.getText()))
                .findFirst()
                .orElseThrow()
                .doClick();
    }

    private Map<String, List<String>> keys() {
        return session.settings().get(EditorSetting.KEYS);
    }

    @Test
    void aPressedKeyIsBoundAtOnceAndReset() {
        open(EditorSettings.DEFAULT);
        choose("Duplicate");
        click(PageText.REPLACE);
        press(InputEvent.SHIFT_DOWN_MASK, KeyEvent.VK_SHIFT, KeyEvent.CHAR_UNDEFINED);
        assertEquals(Map.of(), keys(), "a modifier alone is no key");
        press(InputEvent.CTRL_DOWN_MASK | InputEvent.SHIFT_DOWN_MASK, KeyEvent.VK_D, '\u0004');
        assertEquals(Map.of("duplicate", List.of("Ctrl+Shift+D")), keys());
        click(PageText.ADD);
        press(0, KeyEvent.VK_F9, KeyEvent.CHAR_UNDEFINED);
        assertEquals(List.of("Ctrl+Shift+D", "F9"), keys().get("duplicate"));
        click(PageText.REPLACE);
        press(0, KeyEvent.VK_ESCAPE, '\u001b');
        assertEquals(List.of("Ctrl+Shift+D", "F9"), keys().get("duplicate"), "Esc gives up");
        click(PageText.RESET);
        assertEquals(Map.of(), keys());
        click(PageText.REMOVE);
        assertEquals(Map.of("duplicate", List.of()), keys());
        click(PageText.RESET_ALL);
        assertEquals(Map.of(), keys());
    }

    @Test
    void aConflictIsNamedInWords() {
        open(EditorSettings.DEFAULT);
        choose("Duplicate");
        click(PageText.REPLACE);
        press(InputEvent.CTRL_DOWN_MASK, KeyEvent.VK_C, '\u0003');
        String conflict = (String) page.keys().table().getValueAt(0, KeyTable.CONFLICT);
        assertEquals("Ctrl+C: also Copy", conflict);
        choose("Cut");
        assertEquals("", page.keys().table().getValueAt(0, KeyTable.CONFLICT));
    }

    @Test
    void theDefaultsHaveNoConflicts() {
        open(EditorSettings.DEFAULT);
        List<EditorCommand> commands = new EditorCommands(session, new ScriptInterface(() -> null), Actions.ALL).all();
        assertEquals(Map.of(), new EditorKeys(commands, Map.of()).conflicts());
    }

    @Test
    void aSettingHoldsAtOnce() {
        open(EditorSettings.DEFAULT);
        List<JComboBox<?>> combos = new ArrayList<>();
        PaintedPanel.all(page, JComboBox.class).forEach(combos::add);
        combos.get(0).setSelectedItem(Language.PT_PT);
        assertEquals(Language.PT_PT, session.language());
        combos.get(1).setSelectedItem(Theme.LIGHT);
        assertEquals(Theme.LIGHT, session.settings().get(EditorSetting.THEME));
        combos.get(2).setSelectedItem(150);
        assertEquals(150, session.settings().get(EditorSetting.SCALE_PERCENT));
        assertFalse(combos.get(2).getAccessibleContext().getAccessibleName().isBlank());
    }
}
