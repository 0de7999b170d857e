package nephele.workshop.prove.editor;

import java.util.List;
import nephele.editor.action.ScriptRunner;
import nephele.editor.pane.PaneCamera;
import nephele.editor.pane.PaneKind;
import nephele.editor.pane.PaneLayout;
import nephele.editor.pane.PaneView;
import nephele.editor.pane.PerspectiveCamera;
import nephele.editor.pane.PlanCamera;
import nephele.editor.text.EditorRefusal;
import nephele.engine.math.Vec3;

/** A small level with something of each kind, made by the action table. */
final class FurnishedRoom {
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

    private FurnishedRoom() {}

    /** Returns panes that look at the room. */
    static PaneLayout seen(PaneLayout panes) {
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
    static void make(ScriptRunner script, StageDesk ui) throws EditorRefusal {
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
