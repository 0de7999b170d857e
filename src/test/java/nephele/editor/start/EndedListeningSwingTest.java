package nephele.editor.start;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.lang.reflect.Field;
import java.util.ArrayList;
import java.util.List;
import nephele.editor.action.ScriptInterface;
import nephele.editor.document.Registration;
import nephele.editor.save.DocumentFile;
import nephele.editor.session.EditorSession;
import nephele.editor.session.EditorSettings;
import nephele.editor.session.SessionChange;
import nephele.editor.text.Words;
import nephele.editor.window.WindowLook;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** A closed window leaves nothing that follows its session. */
@Execution(ExecutionMode.SAME_THREAD)
class EndedListeningSwingTest {
    private final EditorSession session = session();

    private static EditorSession session() {
        DocumentFile.Opened opened = DocumentFile.untitled();
        return new EditorSession(opened.file(), opened.level(), opened.assets(), EditorSettings.DEFAULT);
    }

    /** Returns the simple names of the classes whose lambdas listen. */
    private List<String> listeners() throws ReflectiveOperationException {
        Field field = EditorSession.class.getDeclaredField("listeners");
        field.setAccessible(true);
        return ((List<?>) field.get(session))
                .stream()
                        .map(listener -> listener.getClass().getSimpleName().replaceFirst("\\$.*", ""))
                        .sorted()
                        .toList();
    }

    @Test
    void aClosedPanelAndItsPartsHearNothingMore() throws ReflectiveOperationException {
        WindowLook.apply(session.settings());
        List<String> before = listeners();
        var panel = EditorParts.panel(session, new ScriptInterface(() -> null), (part, opener) -> {});
        List<String> open = new ArrayList<>(listeners());
        before.forEach(open::remove);
        assertEquals(
                List.of(
                        "ComparisonPart",
                        "EditorPanel",
                        "EditorParts",
                        "GuideBar",
                        "HistoryPanel",
                        "InspectorPanel",
                        "OutlinerPanel",
                        "PalettePanel",
                        "ProblemsPanel",
                        "ViewportPanel"),
                open);
        panel.close();
        assertEquals(before, listeners());
        panel.close();
    }

    @Test
    void aClosedRegistrationIsSilent() {
        List<SessionChange> heard = new ArrayList<>();
        Registration registration = session.listen(heard::add);
        session.status(Words.same("a"));
        registration.close();
        registration.close();
        session.status(Words.same("b"));
        assertEquals(List.of(SessionChange.STATUS), heard);
    }
}
