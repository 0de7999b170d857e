package nephele.editor.start;

import java.awt.Component;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.ForkJoinPool;
import java.util.function.BiConsumer;
import java.util.function.Function;
import javax.swing.JTabbedPane;
import nephele.editor.action.Actions;
import nephele.editor.action.EditorCommands;
import nephele.editor.action.ProvingActions;
import nephele.editor.action.UserInterface;
import nephele.editor.document.Registration;
import nephele.editor.document.Selection;
import nephele.editor.paint.MaterialLibrary;
import nephele.editor.panel.GuideBar;
import nephele.editor.panel.HistoryPanel;
import nephele.editor.panel.InspectorPanel;
import nephele.editor.panel.OutlinerPanel;
import nephele.editor.panel.PalettePanel;
import nephele.editor.panel.ProblemsPanel;
import nephele.editor.panel.model.PanelText;
import nephele.editor.record.EntityRef;
import nephele.editor.session.EditorFiles;
import nephele.editor.session.EditorSession;
import nephele.editor.session.SessionChange;
import nephele.editor.text.Words;
import nephele.editor.widget.AssetPictures;
import nephele.editor.window.EditorPanel;
import nephele.editor.window.EditorSlots;
import nephele.editor.window.dialog.AssetDialog;
import nephele.editor.window.dialog.DialogFrame;
import nephele.editor.window.dialog.DialogOpener;
import nephele.editor.window.dialog.EditorDialogs;
import nephele.editor.window.page.PageText;
import nephele.editor.window.page.SettingsPage;
import nephele.host.userfile.UserFolders;

/** Puts the panels around the viewport. */
public final class EditorParts {
    private static final List<String> MAIN_ACTIONS =
            List.of("new", "open", "save", "undo", "redo", "play-here", "check", "heat", "path-trace", "explain");
    private static final Words OUTLINE = Words.of("Level", "Fase", "Nível");
    private static final Words PALETTE = Words.of("Add", "Adicionar", "Adicionar");

    private EditorParts() {}

    /**
     * Returns the whole editor of a session, as its window shows it.
     *
     * @param parts receives the name of each part that can be shown, and what opens it
     */
    public static EditorPanel panel(EditorSession session, UserInterface ui, BiConsumer<String, Runnable> parts) {
        return panel(session, ui, parts, DialogFrame::new);
    }

    /**
     * Returns the whole editor of a session.
     *
     * @param parts receives the name of each part that can be shown, and what opens it
     * @param dialogues returns what shows dialogues over the window of a component
     */
    public static EditorPanel panel(
            EditorSession session,
            UserInterface ui,
            BiConsumer<String, Runnable> parts,
            Function<Component, DialogOpener> dialogues) {
        session.options().material(MaterialLibrary.FIRST);
        EditorCommands commands = new EditorCommands(session, ui, Actions.ALL);
        AssetPictures pictures = new AssetPictures(session::assets, ForkJoinPool.commonPool());
        JTabbedPane left = new JTabbedPane();
        OutlinerPanel outliner = new OutlinerPanel(
                session, ref -> focus(commands, session, ref), refs -> delete(commands, session, refs));
        left.addTab("", outliner);
        left.addTab("", new PalettePanel(session, pictures));
        JTabbedPane bottom = new JTabbedPane();
        bottom.addTab("", new ProblemsPanel(session, problem -> ProvingActions.choose(session, problem)));
        bottom.addTab("", new HistoryPanel(session));
        parts.accept("problems", () -> bottom.setSelectedIndex(0));
        Runnable titles = () -> {
            title(left, session, OUTLINE, PALETTE);
            title(bottom, session, PanelText.PROBLEMS.words(), PanelText.HISTORY.words());
        };
        titles.run();
        Registration translation = session.listen(change -> {
            if (change == SessionChange.SETTINGS) {
                titles.run();
            }
        });
        AssetDialog assets = new AssetDialog(session, dialogues.apply(left), pictures);
        GuideBar guide = new GuideBar(session);
        EditorSlots slots = new EditorSlots(guide, left, new InspectorPanel(session, assets), bottom, MAIN_ACTIONS);
        EditorPanel panel = new EditorPanel(session, commands, slots);
        panel.closeToo(translation);
        DialogOpener opener = dialogues.apply(panel);
        new EditorDialogs(session, ui, panel, opener).register(parts);
        parts.accept("settings", () -> show(session, panel, opener, SettingsPage.Tab.GENERAL));
        parts.accept("keys", () -> show(session, panel, opener, SettingsPage.Tab.KEYS));
        parts.accept("guide", guide::start);
        parts.accept("search", () -> {
            left.setSelectedIndex(0);
            outliner.startSearch();
        });
        return panel;
    }

    private static void title(JTabbedPane tabs, EditorSession session, Words... titles) {
        for (int i = 0; i < titles.length; i++) {
            tabs.setTitleAt(i, titles[i].in(session.language()));
        }
    }

    private static void delete(EditorCommands commands, EditorSession session, List<EntityRef> refs) {
        if (!refs.isEmpty()) {
            session.document().select(Selection.of(refs));
            commands.named("delete").ifPresent(command -> command.run());
        }
    }

    private static void focus(EditorCommands commands, EditorSession session, EntityRef ref) {
        session.document().select(Selection.of(ref));
        commands.named("focus").ifPresent(command -> command.run());
    }

    private static void show(EditorSession session, EditorPanel panel, DialogOpener dialogues, SettingsPage.Tab tab) {
        Path file = EditorFiles.in(UserFolders.ofThisUser()).settings();
        dialogues.open(PageText.SETTINGS.in(session.language()), close -> {
            SettingsPage page = new SettingsPage(session, panel.commands().all(), file, close).at(tab);
            return new DialogFrame.Content(page, page.tabs(), null);
        });
    }
}
