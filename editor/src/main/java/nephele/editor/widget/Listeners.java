package nephele.editor.widget;

import java.awt.event.ActionEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import javax.swing.AbstractAction;
import javax.swing.JComponent;
import javax.swing.JList;
import javax.swing.KeyStroke;
import javax.swing.event.DocumentEvent;
import javax.swing.event.DocumentListener;
import javax.swing.text.JTextComponent;

/** Attaches effects to the keys, the text and the rows of Swing components. */
public final class Listeners {
    private Listeners() {}

    /** Runs an effect when a key such as {@code ESCAPE} is pressed while the focus is in a component. */
    public static void onKey(JComponent part, String key, Runnable effect) {
        part.getInputMap(JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT).put(KeyStroke.getKeyStroke(key), key);
        part.getActionMap().put(key, new AbstractAction() {
            private static final long serialVersionUID = 1;

            @Override
            public void actionPerformed(ActionEvent event) {
                effect.run();
            }
        });
    }

    /** Runs an effect after each change of a text. */
    public static void onText(JTextComponent text, Runnable effect) {
        text.getDocument().addDocumentListener(new DocumentListener() {
            @Override
            public void insertUpdate(DocumentEvent event) {
                effect.run();
            }

            @Override
            public void removeUpdate(DocumentEvent event) {
                effect.run();
            }

            @Override
            public void changedUpdate(DocumentEvent event) {
                effect.run();
            }
        });
    }

    /** Runs an effect when a row of a list is clicked twice. */
    public static void onDoubleClick(JList<?> list, Runnable effect) {
        list.addMouseListener(new MouseAdapter() {
            @Override
            public void mouseClicked(MouseEvent event) {
                int row = list.locationToIndex(event.getPoint());
                if (event.getClickCount() == 2
                        && row >= 0
                        && list.getCellBounds(row, row).contains(event.getPoint())) {
                    effect.run();
                }
            }
        });
    }
}
