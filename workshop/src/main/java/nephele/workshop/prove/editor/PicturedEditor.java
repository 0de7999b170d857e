package nephele.workshop.prove.editor;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Optional;
import javax.swing.AbstractButton;
import nephele.editor.action.ScriptRunner;
import nephele.editor.pane.PaneCamera.PaneSize;
import nephele.editor.pane.PaneLayout;
import nephele.editor.save.DocumentFile;
import nephele.editor.session.EditorSession;
import nephele.editor.start.EditorParts;
import nephele.editor.text.EditorRefusal;
import nephele.editor.window.EditorPanel;
import nephele.editor.window.PanelPicture;
import nephele.editor.window.WindowLook;
import nephele.editor.window.dialog.DialogFrame;

/** The real editor over a furnished room, in one look, without a display. Used on the event dispatch thread. */
final class PicturedEditor implements AutoCloseable {
    private final EditorLook look;
    private final StageDesk ui = new StageDesk((title, making) -> opened = making.apply(() -> {}), Optional::empty);
    private final EditorSession session;
    private final EditorPanel panel;
    private final ScriptRunner script;
    private DialogFrame.Content opened;

    PicturedEditor(EditorLook look) throws EditorRefusal {
        this.look = look;
        WindowLook.apply(look.settings());
        DocumentFile.Opened empty = DocumentFile.untitled();
        session = new EditorSession(empty.file(), empty.level(), empty.assets(), look.settings());
        panel = EditorParts.panel(session, ui.surroundings());
        script = new ScriptRunner(session, ui);
        FurnishedRoom.make(script, ui);
        session.panes(FurnishedRoom::seen);
        layOut();
    }

    EditorLook look() {
        return look;
    }

    EditorSession session() {
        return session;
    }

    EditorPanel panel() {
        return panel;
    }

    StageDesk ui() {
        return ui;
    }

    /** Shows a part; returns what its dialogue holds, if it is one that can be used now. */
    Optional<DialogFrame.Content> dialogue(String part) {
        opened = null;
        ui.show(part);
        return Optional.ofNullable(opened);
    }

    /** Runs a line of the action table. */
    void run(String... lines) throws EditorRefusal {
        for (String line : lines) {
            script.run(line);
        }
    }

    /** Returns a hand in the viewport. */
    OffscreenHand hand() {
        layOut();
        int gap = Math.round(PaneLayout.GAP_PIXELS * UIScale.getUserScaleFactor());
        return new OffscreenHand(session, viewport(), gap);
    }

    /** Ends what the hand holds, as Esc does. */
    void escape() {
        panel.key(new KeyEvent(panel, KeyEvent.KEY_PRESSED, 0, 0, KeyEvent.VK_ESCAPE, (char) KeyEvent.VK_ESCAPE));
    }

    private Component viewport() {
        return panel.viewport().surface().component();
    }

    private void layOut() {
        PanelPicture.layOut(panel, look.screen());
        Dimension size = viewport().getSize();
        session.viewport(new PaneSize(size.width, size.height));
    }

    /** Presses the button of a name. */
    void click(String name) {
        PaintedPanel.all(panel, AbstractButton.class).stream()
                .filter(button -> name.equals(button.getName()))
                .findFirst()
                .orElseThrow()
                .doClick();
    }

    /** Returns the one component of a type. */
    <T extends Component> T the(Class<T> type) {
        return PaintedPanel.all(panel, type).get(0);
    }

    /** Returns the texts of a container that are cut off. */
    List<String> cut(Container part) {
        return CutTexts.in(part, UserTexts.of(session));
    }

    /** Returns the texts of the whole editor that are cut off. */
    List<String> cut() {
        layOut();
        return cut(panel);
    }

    /** Paints the whole editor, its viewport included. */
    BufferedImage picture() {
        BufferedImage picture = PanelPicture.of(panel);
        panel.viewport().surface().failure().ifPresent(failure -> {
            throw new IllegalStateException("the viewport cannot be drawn: " + failure, failure);
        });
        return picture;
    }

    @Override
    public void close() {
        panel.close();
    }
}
