package nephele.editor.start;

import java.nio.file.Path;
import java.util.function.BiConsumer;
import nephele.editor.action.Desk;
import nephele.editor.session.EditorSession;
import nephele.editor.settings.EditorFiles;
import nephele.editor.window.EditorPanel;
import nephele.editor.window.dialog.DialogFrame;
import nephele.editor.window.dialog.Dialogues;
import nephele.editor.window.dialog.EditorDialogs;
import nephele.editor.window.page.PageText;
import nephele.editor.window.page.SettingsPage;
import nephele.engine.userfile.UserFolders;

/** Registers the dialogues and pages of an editor. */
public final class EditorPages {
    private EditorPages() {}

    /**
     * Registers the dialogues and pages, and where they open.
     *
     * @param parts receives the name of each part and what opens it
     */
    public static void register(
            EditorSession session, Desk desk, EditorPanel panel, Dialogues frame, BiConsumer<String, Runnable> parts) {
        new EditorDialogs(session, desk, panel, frame).register(parts);
        parts.accept("settings", () -> show(session, panel, frame, SettingsPage.Tab.GENERAL));
        parts.accept("keys", () -> show(session, panel, frame, SettingsPage.Tab.KEYS));
    }

    private static void show(EditorSession session, EditorPanel panel, Dialogues frame, SettingsPage.Tab tab) {
        Path file = EditorFiles.in(UserFolders.ofThisUser()).settings();
        frame.open(PageText.SETTINGS.in(session.language()), close -> {
            SettingsPage page = new SettingsPage(session, panel.commands().all(), file, close).at(tab);
            return new DialogFrame.Content(page, page.tabs(), null);
        });
    }
}
