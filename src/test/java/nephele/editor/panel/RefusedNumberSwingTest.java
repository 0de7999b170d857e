package nephele.editor.panel;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.Container;
import java.util.ArrayList;
import java.util.List;
import javax.swing.JTextArea;
import javax.swing.SwingUtilities;
import nephele.editor.action.ScriptedSession;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A text that is no number is quoted in the message, which does not widen the panel. */
@Execution(ExecutionMode.SAME_THREAD)
class RefusedNumberSwingTest {
    private static <T extends Component> List<T> all(Container parent, Class<T> kind) {
        List<T> found = new ArrayList<>();
        for (Component child : parent.getComponents()) {
            if (kind.isInstance(child)) {
                found.add(kind.cast(child));
            }
            if (child instanceof Container container) {
                found.addAll(all(container, kind));
            }
        }
        return found;
    }

    @ParameterizedTest
    @ValueSource(strings = {"?", "12 metres", "a very long text that is no number at all, however one reads it"})
    void aTextThatIsNoNumberIsQuoted(String text) throws Exception {
        ScriptedSession session = ScriptedSession.empty().run("brush box min=0,0,0 max=1,1,1 id=block");
        String before = session.json();
        SwingUtilities.invokeAndWait(() -> {
            try (InspectorPanel panel = new InspectorPanel(session.session(), null)) {
                int width = panel.getMinimumSize().width;
                NumberInput input = all(panel, NumberInput.class).get(0);
                input.setText(text);
                input.postActionEvent();
                String start = text.substring(0, Math.min(20, text.length()));
                assertTrue(
                        all(panel, JTextArea.class).stream()
                                .anyMatch(label -> label.isVisible()
                                        && String.valueOf(label.getText()).contains("\"" + start)),
                        "the message quotes the text");
                assertEquals(width, panel.getMinimumSize().width);
            }
        });
        assertEquals(before, session.json());
    }
}
