package nephele.editor.window;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Component;
import java.awt.Dimension;
import javax.swing.JComponent;
import javax.swing.JOptionPane;
import javax.swing.JTextArea;
import javax.swing.UIManager;
import nephele.editor.window.Closing.Choice;
import nephele.engine.level.Language;

/** Questions in dialogues, with buttons in the user's language. */
public final class SwingQuestions {
    private final Component owner;

    /** @param owner over which the dialogues appear */
    public SwingQuestions(Component owner) {
        this.owner = owner;
    }

    /** Asks what happens to the unsaved changes of the level of a name. */
    public Choice ask(String level, Language language) {
        int chosen = chosen(
                WindowText.ASK_CLOSE.with(level).in(language),
                language,
                WindowText.SAVE,
                WindowText.DISCARD,
                WindowText.CANCEL);
        return chosen == 0 ? Choice.SAVE : chosen == 1 ? Choice.DISCARD : Choice.CANCEL;
    }

    /** Asks a question with yes and no. */
    public boolean isAgreed(String question, Language language) {
        return chosen(question, language, WindowText.YES, WindowText.NO) == 0;
    }

    /** Reports something that the user must know. */
    public void warn(String message, Language language) {
        chosen(message, language, JOptionPane.WARNING_MESSAGE, WindowText.OK.in(language));
    }

    /** Returns the index of the chosen answer, of which the first one is the default; -1 if the dialogue is closed. */
    public int choice(String question, Language language, String... answers) {
        return chosen(question, language, JOptionPane.WARNING_MESSAGE, (Object[]) answers);
    }

    private int chosen(String question, Language language, WindowText... answers) {
        Object[] buttons = new Object[answers.length];
        for (int i = 0; i < answers.length; i++) {
            buttons[i] = answers[i].in(language);
        }
        return chosen(question, language, JOptionPane.QUESTION_MESSAGE, buttons);
    }

    private int chosen(String question, Language language, int kind, Object... buttons) {
        return JOptionPane.showOptionDialog(
                owner,
                text(question),
                WindowText.TITLE.in(language),
                JOptionPane.DEFAULT_OPTION,
                kind,
                null,
                buttons,
                buttons[0]);
    }

    /** Returns the text of a question in lines of a comfortable width. */
    public static JComponent text(String question) {
        JTextArea text = new JTextArea(question);
        text.setEditable(false);
        text.setFocusable(false);
        text.setOpaque(false);
        text.setFont(UIManager.getFont("Label.font"));
        text.setLineWrap(true);
        text.setWrapStyleWord(true);
        // Long paths have no place to break at but anywhere; the width of a line is that of a comfortable text.
        text.setSize(new Dimension(UIScale.scale(420), Short.MAX_VALUE));
        text.setPreferredSize(new Dimension(UIScale.scale(420), text.getPreferredSize().height));
        return text;
    }
}
