package nephele.editor.window;

import java.awt.Component;
import javax.swing.JOptionPane;
import nephele.engine.level.Language;

/** Questions in dialogues, with buttons in the user's language. */
final class SwingQuestions implements CloseQuestion {
    private final Component owner;

    SwingQuestions(Component owner) {
        this.owner = owner;
    }

    @Override
    public Choice ask(String level, Language language) {
        int chosen = chosen(
                WindowText.ASK_CLOSE.with(level).in(language),
                language,
                WindowText.SAVE,
                WindowText.DISCARD,
                WindowText.CANCEL);
        return chosen == 0 ? Choice.SAVE : chosen == 1 ? Choice.DISCARD : Choice.CANCEL;
    }

    boolean isAgreed(String question, Language language) {
        return chosen(question, language, WindowText.YES, WindowText.NO) == 0;
    }

    private int chosen(String question, Language language, WindowText... answers) {
        Object[] buttons = new Object[answers.length];
        for (int i = 0; i < answers.length; i++) {
            buttons[i] = answers[i].in(language);
        }
        return JOptionPane.showOptionDialog(
                owner,
                question,
                WindowText.TITLE.in(language),
                JOptionPane.DEFAULT_OPTION,
                JOptionPane.QUESTION_MESSAGE,
                null,
                buttons,
                buttons[0]);
    }
}
