package nephele.editor.action;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import nephele.editor.action.EditorAction.Menu;
import nephele.editor.text.Words;
import nephele.engine.level.Language;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Texts of keys, and which command a pressed key starts. */
class EditorKeysTest {
    /** Stands for what has the focus; it is never shown. */
    private static final class Focus extends Component {
        private static final long serialVersionUID = 1;
    }

    private static EditorCommand command(String id, String title, String... keys) {
        Words words = Words.same(title);
        return new EditorCommand(id, words, Menu.EDIT, List.of(keys), () -> true, () -> false, () -> {});
    }

    private static KeyEvent pressed(int modifiers, int code, char character) {
        return new KeyEvent(new Focus(), KeyEvent.KEY_PRESSED, 0, modifiers, code, character);
    }

    @ParameterizedTest
    @CsvSource({
        "Ctrl+Shift+D, Ctrl+Shift+D",
        "shift + ctrl + d, Ctrl+Shift+D",
        "ctrl++, Ctrl++",
        "+, +",
        "[, [",
        "pageup, PageUp",
        "alt+f5, Alt+F5",
        "Ctrl+Minus, Ctrl+-",
        "OpenBracket, [",
        "escape, Esc",
        "7, 7"
    })
    void aTextIsReadAndPrinted(String text, String printed) {
        assertEquals(printed, KeyText.parse(text).orElseThrow().text());
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "Ctrl", "Ctrl+", "Hyper+D", "Ctrl+Banana", "Shift+Ctrl"})
    void whatIsNoKeyIsRefused(String text) {
        assertEquals(Optional.empty(), KeyText.parse(text));
    }

    @Test
    void modifiersTellKeysApart() {
        EditorKeys keys = new EditorKeys(
                List.of(
                        command("move", "m", "D"),
                        command("copy", "c", "Ctrl+D"),
                        command("clone", "k", "Ctrl+Shift+D")),
                Map.of());
        int control = InputEvent.CTRL_DOWN_MASK;
        assertEquals(Optional.of("move"), keys.find(pressed(0, KeyEvent.VK_D, 'd')));
        assertEquals(Optional.of("copy"), keys.find(pressed(control, KeyEvent.VK_D, '\u0004')));
        assertEquals(
                Optional.of("clone"),
                keys.find(pressed(control | InputEvent.SHIFT_DOWN_MASK, KeyEvent.VK_D, '\u0004')));
        assertEquals(Optional.empty(), keys.find(pressed(InputEvent.ALT_DOWN_MASK, KeyEvent.VK_D, 'd')));
    }

    @Test
    void aSignIsFoundWhateverKeyWritesIt() {
        EditorKeys keys = new EditorKeys(List.of(command("finer", "f", "["), command("larger", "l", "+")), Map.of());
        int altGr = InputEvent.ALT_DOWN_MASK | InputEvent.ALT_GRAPH_DOWN_MASK;
        assertEquals(Optional.of("finer"), keys.find(pressed(altGr, KeyEvent.VK_8, '[')));
        assertEquals(Optional.of("larger"), keys.find(pressed(InputEvent.SHIFT_DOWN_MASK, KeyEvent.VK_EQUALS, '+')));
    }

    /** Modifiers tell signs apart as they do letters, whether or not the layout needs Shift to write one. */
    @Test
    void modifiersTellSignsApart() {
        List<EditorCommand> all = new EditorCommands(
                        ScriptedSession.empty().session(), new ScriptInterface(() -> null), Actions.ALL)
                .all();
        EditorKeys keys = new EditorKeys(all, Map.of());
        int alt = InputEvent.ALT_DOWN_MASK;
        int altShift = alt | InputEvent.SHIFT_DOWN_MASK;
        assertEquals(Optional.of("grid-finer"), keys.find(pressed(0, KeyEvent.VK_OPEN_BRACKET, '[')));
        assertEquals(Optional.of("grid-coarser"), keys.find(pressed(0, KeyEvent.VK_CLOSE_BRACKET, ']')));
        assertEquals(Optional.of("terrain-smaller"), keys.find(pressed(alt, KeyEvent.VK_OPEN_BRACKET, '[')));
        assertEquals(Optional.of("terrain-larger"), keys.find(pressed(alt, KeyEvent.VK_CLOSE_BRACKET, ']')));
        assertEquals(Optional.of("terrain-weaker"), keys.find(pressed(altShift, KeyEvent.VK_OPEN_BRACKET, '{')));
        assertEquals(Optional.of("terrain-stronger"), keys.find(pressed(altShift, KeyEvent.VK_CLOSE_BRACKET, '}')));
        KeyEvent captured = pressed(alt, KeyEvent.VK_OPEN_BRACKET, '[');
        assertEquals("Alt+[", KeyText.pressed(captured).orElseThrow().text());
    }

    /** What the table of keys says is what each key does. */
    @Test
    void everyDefaultKeyStartsItsCommand() {
        List<EditorCommand> all = new EditorCommands(
                        ScriptedSession.empty().session(), new ScriptInterface(() -> null), Actions.ALL)
                .all();
        EditorKeys keys = new EditorKeys(all, Map.of());
        for (EditorCommand command : all) {
            for (KeyText key : keys.of(command.id())) {
                char sign = key.key().length() == 1 ? key.key().charAt(0) : KeyEvent.CHAR_UNDEFINED;
                KeyEvent event = pressed(
                        key.stroke().getModifiers() & ~0x3f, key.stroke().getKeyCode(), sign);
                assertEquals(Optional.of(command.id()), keys.find(event), key.text());
            }
        }
    }

    @Test
    void aLayoutWithoutTheSignHasItAtTheSamePlace() {
        EditorKeys keys = new EditorKeys(List.of(command("finer", "f", "["), command("sign", "s", "´")), Map.of());
        assertEquals(Optional.of("sign"), keys.find(pressed(0, KeyEvent.VK_OPEN_BRACKET, '´')), "character first");
        assertEquals(Optional.of("finer"), keys.find(pressed(0, KeyEvent.VK_OPEN_BRACKET, 'х')));
    }

    @Test
    void theUserTakesKeysAwayAndMakesConflicts() {
        List<EditorCommand> commands =
                List.of(command("a", "a", "F1"), command("b", "b", "F2"), command("c", "c", "F3"));
        EditorKeys keys = new EditorKeys(commands, Map.of("a", List.of(), "b", List.of("F3", "nonsense")));
        assertEquals(Optional.empty(), keys.find(pressed(0, KeyEvent.VK_F1, KeyEvent.CHAR_UNDEFINED)));
        assertEquals(Optional.of("b"), keys.find(pressed(0, KeyEvent.VK_F3, KeyEvent.CHAR_UNDEFINED)));
        KeyText key = KeyText.parse("F3").orElseThrow();
        assertEquals(Map.of(key, List.of("b", "c")), keys.conflicts());
        assertEquals(Map.of(), new EditorKeys(commands, Map.of()).conflicts());
    }

    @Test
    void searchKnowsWordsWithoutAccentsAndPutsBeginningsFirst() {
        EditorCommand hide = command("hide", "Ocultar seleção");
        EditorCommand select = command("all", "Seleção inteira");
        List<EditorCommand> found = EditorCommands.find(List.of(hide, select), "selecao", Language.PT_BR);
        assertEquals(List.of(select, hide), found);
        assertEquals(List.of(hide), EditorCommands.find(List.of(hide, select), "sel ocu", Language.PT_BR));
        assertTrue(
                EditorCommands.find(List.of(hide, select), "zzz", Language.EN).isEmpty());
    }
}
