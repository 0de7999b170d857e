package nephele.workshop.prove.editor;

import java.awt.Dimension;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Map;
import javax.swing.SwingUtilities;
import nephele.editor.document.Selection;
import nephele.editor.pane.PaneLayout;
import nephele.editor.pane.PaneView;
import nephele.editor.pane.ViewMode;
import nephele.editor.proving.ProvingThreads;
import nephele.editor.save.DocumentFile;
import nephele.editor.session.EditorFiles;
import nephele.editor.session.EditorSession;
import nephele.editor.session.EditorSetting;
import nephele.editor.session.EditorSettings;
import nephele.editor.session.FileServices;
import nephele.editor.session.SessionChange;
import nephele.editor.session.Tools;
import nephele.editor.window.EditorPanel;
import nephele.editor.window.WaitingLoop;
import nephele.editor.window.WindowLook;
import nephele.editor.window.viewport.ViewportSurface;
import nephele.engine.level.Level;
import nephele.engine.level.json.LevelFormatException;
import nephele.engine.level.json.LevelJson;
import nephele.engine.render.gl.GlKind;

/** The real editor in an offscreen surface, as it is under random events. Used on the event dispatch thread. */
final class EditorUnderEvents implements AutoCloseable {
    private static final Dimension SIZE = new Dimension(960, 640);

    private final EditorSession session;
    private final EditorPanel panel;
    private final DocumentFile.Opened base;
    private final DialogStage dialogues;
    private EditorSettings look = EditorSettings.DEFAULT;

    /**
     * @param base the level at the beginning, to which {@link #liveObjects} returns
     * @param folder for backups
     */
    EditorUnderEvents(DocumentFile.Opened base, Path folder, StageDesk ui, DialogStage dialogues) {
        this.base = base;
        this.dialogues = dialogues;
        WindowLook.apply(look);
        session = new EditorSession(base.file(), base.level(), base.assets(), look);
        session.fileServices(FileServices.of(EditorFiles.of(null, folder)));
        panel = ui.panel(session);
        panel.closeToo(session.listen(this::follow));
        session.proving().runOn(new ProvingThreads(new WaitingLoop(() -> {}), SwingUtilities::invokeLater));
        resize(SIZE);
    }

    /** Changes the look as the window does. */
    private void follow(SessionChange change) {
        EditorSettings now = session.settings();
        boolean isSame = now.get(EditorSetting.THEME) == look.get(EditorSetting.THEME)
                && now.get(EditorSetting.SCALE_PERCENT).equals(look.get(EditorSetting.SCALE_PERCENT));
        look = now;
        if (change == SessionChange.SETTINGS && !isSame) {
            WindowLook.apply(now);
            SwingUtilities.updateComponentTreeUI(panel);
        }
    }

    DialogStage dialogues() {
        return dialogues;
    }

    EditorSession session() {
        return session;
    }

    EditorPanel panel() {
        return panel;
    }

    void resize(Dimension size) {
        panel.layOut(size);
    }

    /** Paints the whole editor, its viewport included. */
    void paint() {
        panel.picture();
        surface().failure().ifPresent(failure -> {
            throw new IllegalStateException("the viewport cannot be drawn: " + failure, failure);
        });
    }

    private ViewportSurface surface() {
        return panel.viewport().surface();
    }

    /** Returns the number of objects of OpenGL in the state of the beginning, after all kinds of pictures were drawn. */
    Map<GlKind, Integer> liveObjects() {
        session.proving().close();
        session.proving().dismiss();
        session.use(Tools.ALL.get(0));
        session.open(base.file(), base.level(), base.assets());
        session.document().select(Selection.NONE);
        session.settings(EditorSettings.DEFAULT);
        resize(SIZE);
        session.panes(before -> PaneLayout.initial());
        for (ViewMode mode : ViewMode.values()) {
            PaneView view = session.panes().views().get(0);
            session.panes(panes -> panes.with(0, view.with(mode)));
            paint();
        }
        session.proving().corner().show(true, 1);
        paint();
        session.proving().close();
        paint();
        return surface().liveObjects();
    }

    /** Throws if the level is not the same after it was written and read. */
    void requireWritable() throws LevelFormatException {
        Level level = session.document().level();
        String written = LevelJson.write(level);
        Level read = LevelJson.read("events", written.getBytes(StandardCharsets.UTF_8));
        if (!read.equals(level)) {
            throw new IllegalStateException("the level differs after it was written and read");
        }
        if (!LevelJson.write(read).equals(written)) {
            throw new IllegalStateException("the level's text differs after it was read and written");
        }
    }

    @Override
    public void close() {
        panel.close();
        if (surface().liveObjects().values().stream().anyMatch(count -> count != 0)) {
            throw new IllegalStateException(
                    "the closed editor leaves objects of OpenGL: " + surface().liveObjects());
        }
    }
}
