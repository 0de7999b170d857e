package nephele.editor.start;

import java.nio.file.Path;
import java.util.function.BiConsumer;
import nephele.editor.session.EditorFiles;
import nephele.editor.session.EditorSession;
import nephele.editor.window.EditorPanel;
import nephele.editor.window.dialog.DialogFrame;
import nephele.editor.window.dialog.DialogOpener;
import nephele.editor.window.dialog.EditorDialogs;
import nephele.editor.window.page.PageText;
import nephele.editor.window.page.SettingsPage;
import nephele.host.userfile.UserFolders;

/** Registers the dialogues and pages of a window. */
final class EditorPages {
    private EditorPages() {}

    /** Registers each part by its name with what opens it. */
    static void register(EditorSession session, EditorPanel panel, EditorSurroundings around) {
        DialogOpener dialogues = around.dialogues().apply(panel);
        BiConsumer<String, Runnable> parts = around.parts();
        new EditorDialogs(session, around.desk(), panel, dialogues).register(parts);
        parts.accept("settings", () -> show(session, panel, dialogues, SettingsPage.Tab.GENERAL));
        parts.accept("keys", () -> show(session, panel, dialogues, SettingsPage.Tab.KEYS));
    }

    private static void show(EditorSession session, EditorPanel panel, DialogOpener dialogues, SettingsPage.Tab tab) {
        Path file = EditorFiles.in(UserFolders.ofThisUser()).settings();
        dialogues.open(PageText.SETTINGS.in(session.language()), close -> {
            SettingsPage page = new SettingsPage(session, panel.commands().all(), file, close).at(tab);
            return new DialogFrame.Content(page, page.tabs(), null);
        });
    }
}
