package nephele.editor.start;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.lang.reflect.Field;
import java.util.ArrayList;
import java.util.List;
import nephele.editor.action.ScriptDesk;
import nephele.editor.document.Registration;
import nephele.editor.save.DocumentFile;
import nephele.editor.session.EditorSession;
import nephele.editor.session.NewDocument;
import nephele.editor.session.SessionListener.Change;
import nephele.editor.settings.EditorSettings;
import nephele.editor.surface.SurfaceMode;
import nephele.editor.text.Words;
import nephele.editor.window.WindowLook;
import org.junit.jupiter.api.Test;

/** A closed window leaves nothing that follows its session. */
class EndedListeningSwingTest {
    private final EditorSession session = session();

    private static EditorSession session() {
        DocumentFile.Opened opened = NewDocument.opened();
        return new EditorSession(opened.file(), opened.level(), opened.assets(), EditorSettings.DEFAULT);
    }

    private int listeners() throws ReflectiveOperationException {
        Field field = EditorSession.class.getDeclaredField("listeners");
        field.setAccessible(true);
        return ((List<?>) field.get(session)).size();
    }

    @Test
    void aClosedPanelAndItsPartsHearNothingMore() throws ReflectiveOperationException {
        WindowLook.apply(session.settings());
        int before = listeners();
        var panel = EditorParts.panel(session, new ScriptDesk(() -> null), SurfaceMode.OFFSCREEN, (part, opener) -> {});
        assertTrue(listeners() >= before + 7, "the parts follow the session");
        panel.close();
        assertEquals(before, listeners());
        panel.close();
    }

    @Test
    void aClosedRegistrationIsSilent() {
        List<Change> heard = new ArrayList<>();
        Registration registration = session.listen(heard::add);
        session.status(Words.same("a"));
        registration.close();
        registration.close();
        session.status(Words.same("b"));
        assertEquals(List.of(Change.STATUS), heard);
    }
}
