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
import nephele.editor.pane.PaneCamera;
import nephele.editor.pane.PaneCamera.PaneSize;
import nephele.editor.pane.PaneKind;
import nephele.editor.pane.PaneLayout;
import nephele.editor.pane.PaneView;
import nephele.editor.pane.PerspectiveCamera;
import nephele.editor.pane.PlanCamera;
import nephele.editor.save.DocumentFile;
import nephele.editor.session.EditorSession;
import nephele.editor.text.EditorRefusal;
import nephele.editor.window.EditorPanel;
import nephele.editor.window.WindowLook;
import nephele.editor.window.dialog.DialogFrame;
import nephele.engine.math.Vec3;

/** The real editor over a furnished room, in one look, without a display. Used on the event dispatch thread. */
final class PicturedEditor implements AutoCloseable {
    /** A camera that flies along a path, as the clipboard has it. */
    private static final String FLIGHT =
            """
            {"format": "nephele-level", "version": 1, "cameras": [{"id": "flight", "position": [-3, 2, 3],
            "target": [0, 1, -2], "path": [{"position": [-3, 2, 3], "target": [0, 1, -2]},
            {"position": [-2, 2.5, 1], "target": [0, 1, -2]}, {"position": [-1, 2.8, 0.5], "target": [0, 1, -2]},
            {"position": [1, 2.8, 1.5], "target": [0, 1, -2]}]}]}
            """;

    private static final List<String> LINES = List.of(
            "brush shape=room min=-5.5,-0.5,-5.5 max=5.5,4.5,5.5 wall=0.5",
            "brush shape=box min=-1,0,-3 max=1,1,-1 id=block",
            "brush shape=stairs min=2,0,-4.5 max=4.5,1.5,-3 id=stairs steps=4",
            "add kind=lights.point at=0,3.6,-1 id=lamp",
            "add kind=lights.spot at=-3,3.6,2 id=spot",
            "add kind=portals at=-5,1.05,0 id=left",
            "set value=normal to=1,0,0",
            "add kind=portals at=1,1.05,-5 id=right",
            "set value=linkedTo to=left",
            "select ids=portals/left",
            "set value=linkedTo to=right",
            "add kind=bodies.box at=2,0.25,0 id=cube",
            "add kind=bodies.sphere at=0,1.25,-2 id=ball",
            "add kind=environment.clouds at=0,9,0 id=cloud",
            "add kind=environment.sun at=0,9,0",
            "add kind=exits at=-3,0,-3 id=exit",
            "add kind=player at=0,0,3",
            "add kind=models at=-3,0.5,0 id=teapot",
            "paste",
            "select ids=solids/block,lights/lamp",
            "group",
            "select-none");

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
        panel = ui.panel(session);
        script = new ScriptRunner(session, ui);
        furnish(script, ui);
        session.panes(PicturedEditor::turnedToRoom);
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
        panel.layOut(look.screen());
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
        return CutTexts.in(part, session);
    }

    /** Returns the texts of the whole editor that are cut off. */
    List<String> cut() {
        layOut();
        return cut(panel);
    }

    /** Paints the whole editor, its viewport included. */
    BufferedImage picture() {
        BufferedImage picture = panel.picture();
        panel.viewport().surface().failure().ifPresent(failure -> {
            throw new IllegalStateException("the viewport cannot be drawn: " + failure, failure);
        });
        return picture;
    }

    @Override
    public void close() {
        panel.close();
    }

    /** Returns panes that look at the room. */
    private static PaneLayout turnedToRoom(PaneLayout panes) {
        PaneLayout turned = panes;
        for (int i = 0; i < panes.views().size(); i++) {
            PaneView view = panes.views().get(i);
            PaneCamera camera = view.kind() == PaneKind.PERSPECTIVE
                    ? new PerspectiveCamera(new Vec3(3, 2.6, 4.4), 24, -18, 75)
                    : new PlanCamera(view.kind(), new Vec3(0, 2, 0), 0.035);
            turned = turned.with(i, view.with(camera));
        }
        return turned.withActive(0);
    }

    /** Makes the room in the session of a script. */
    private static void furnish(ScriptRunner script, StageDesk ui) throws EditorRefusal {
        ui.copy(FLIGHT);
        for (String line : LINES) {
            try {
                script.run(line);
            } catch (EditorRefusal failure) {
                throw new IllegalStateException(line + ": " + failure.getMessage(), failure);
            }
        }
    }
}
