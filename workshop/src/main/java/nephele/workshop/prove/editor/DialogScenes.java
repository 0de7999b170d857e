package nephele.workshop.prove.editor;

import java.awt.Dimension;
import java.util.ArrayList;
import java.util.List;
import javax.swing.JComponent;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import javax.swing.JOptionPane;
import javax.swing.JPopupMenu;
import nephele.editor.action.EditorAction.Menu;
import nephele.editor.file.FileText;
import nephele.editor.text.Words;
import nephele.editor.window.SwingQuestions;
import nephele.editor.window.WindowText;
import nephele.editor.window.dialog.DialogFrame;
import nephele.engine.level.Language;

/** The menus, and what dialogues show. */
final class DialogScenes {
    /** The parts of the window that are dialogues. */
    private static final List<String> PARTS = List.of(
            "palette",
            "add",
            "rename",
            "move",
            "turn-by",
            "scale",
            "set",
            "brush",
            "coordinates",
            "grid",
            "settings",
            "keys");

    private DialogScenes() {}

    static List<EditorScene> all() {
        List<EditorScene> scenes = new ArrayList<>();
        for (Menu menu : Menu.values()) {
            String name = "menu-" + menu.name().toLowerCase(java.util.Locale.ROOT);
            scenes.add(new EditorScene(name, editor -> menu(editor, menu)));
        }
        for (String part : PARTS) {
            scenes.add(new EditorScene("dialogue-" + part, editor -> {
                editor.run("select ids=solids/block");
                DialogFrame.Content content =
                        editor.dialogue(part).orElseThrow(() -> new IllegalStateException("no dialogue " + part));
                return fitting(editor, content.panel());
            }));
        }
        scenes.add(question(
                "close",
                WindowText.ASK_CLOSE.with("a room with a view.json"),
                WindowText.SAVE.words(),
                WindowText.DISCARD.words(),
                WindowText.CANCEL.words()));
        scenes.add(question("loses", FileText.LOSES.words(), WindowText.YES.words(), WindowText.NO.words()));
        scenes.add(question(
                "changed",
                FileText.CHANGED_QUESTION.words().with("room.json"),
                FileText.KEEP_MINE.words(),
                FileText.LOAD_THEIRS.words()));
        return scenes;
    }

    private static EditorScene question(String name, Words question, Words... answers) {
        return new EditorScene("question-" + name, editor -> {
            Language language = editor.look().language();
            Object[] buttons = java.util.Arrays.stream(answers)
                    .map(words -> words.in(language))
                    .toArray();
            return fitting(
                    editor,
                    new JOptionPane(
                            SwingQuestions.text(question.in(language)),
                            JOptionPane.WARNING_MESSAGE,
                            JOptionPane.DEFAULT_OPTION,
                            null,
                            buttons,
                            buttons[0]));
        });
    }

    private static JComponent menu(PicturedEditor editor, Menu menu) {
        JMenuBar bar = editor.the(JMenuBar.class);
        String title = menu.title().in(editor.look().language());
        for (int i = 0; i < bar.getMenuCount(); i++) {
            JMenu shown = bar.getMenu(i);
            if (shown.getText().equals(title)) {
                JPopupMenu popup = shown.getPopupMenu();
                return fitting(editor, popup);
            }
        }
        throw new IllegalStateException("no menu " + title);
    }

    private static JComponent fitting(PicturedEditor editor, JComponent part) {
        Dimension size = part.getPreferredSize();
        Dimension screen = editor.look().screen();
        if (size.width > screen.width || size.height > screen.height) {
            throw new IllegalStateException(size + " does not fit on a screen of " + screen);
        }
        return part;
    }
}
