package nephele.workshop.prove.editor;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import javax.swing.JTabbedPane;
import nephele.editor.panel.GuideStep;
import nephele.editor.panel.PalettePanel;
import nephele.editor.panel.ProblemsPanel;
import nephele.editor.problem.ProblemSearch;
import nephele.editor.session.EditorSession;
import nephele.editor.session.Tools;
import nephele.editor.tool.ToolEntry;
import nephele.engine.math.Vec3;

/** The whole window: with each tool in use, each tab, each kind of view, and each step of the guide. */
final class WindowScenes {
    private static final Vec3 FLOOR = new Vec3(1, 0, 2);
    private static final Vec3 WALL = new Vec3(-1.5, 2, -5);
    private static final Vec3 BLOCK_TOP = new Vec3(0.5, 1, -1.5);

    /** What is selected while a tool is shown. */
    private static final Map<String, String> SELECTED = Map.of(
            "move", "lights/lamp",
            "rotate", "solids/block",
            "scale", "solids/block",
            "clip", "solids/block",
            "vertex", "solids/block",
            "extrude", "solids/block",
            "select", "portals/left",
            "sun", "environment.sun");

    private WindowScenes() {}

    static List<EditorScene> all() {
        List<EditorScene> scenes = new ArrayList<>();
        Tools.ALL.forEach(tool -> scenes.add(EditorScene.whole("tool-" + tool.id(), editor -> use(editor, tool))));
        scenes.add(EditorScene.whole("palette", editor -> {
            selectTool(editor);
            tab(editor, PalettePanel.class);
        }));
        scenes.add(EditorScene.whole("several-selected", editor -> {
            tab(editor, nephele.editor.panel.OutlinerPanel.class);
            editor.run("select ids=lights/lamp,lights/spot", "one-pane", "lit");
        }));
        scenes.add(EditorScene.whole("problems", WindowScenes::problems));
        scenes.add(EditorScene.whole("history", editor -> {
            editor.run("select ids=cameras/flight", "collision");
            tab(editor, nephele.editor.panel.HistoryPanel.class);
        }));
        scenes.add(EditorScene.whole("wireframe", editor -> editor.run("select ids=models/teapot", "wireframe")));
        scenes.add(EditorScene.whole("portalable", editor -> {
            tab(editor, ProblemsPanel.class);
            editor.run("select ids=environment.clouds/cloud", "portalable");
        }));
        scenes.addAll(guide());
        return scenes;
    }

    private static void selectTool(PicturedEditor editor) throws Exception {
        editor.run("tool-select");
    }

    private static void tab(PicturedEditor editor, Class<? extends java.awt.Component> part) {
        java.awt.Component shown = PaintedPanel.all(editor.panel(), part).get(0);
        ((JTabbedPane) shown.getParent()).setSelectedComponent(shown);
    }

    private static void use(PicturedEditor editor, ToolEntry tool) throws Exception {
        String selected = SELECTED.get(tool.id());
        editor.run(selected == null ? "select-none" : "select ids=" + selected);
        editor.session().options().entity("bodies", "box");
        editor.run("tool-" + tool.id());
        OffscreenHand hand = editor.hand();
        switch (tool.id()) {
            case "brush" -> hand.hold(OffscreenHand.TOP, new Vec3(2, 0, 0), new Vec3(4, 0, 3));
            case "clip" -> hand.hold(OffscreenHand.TOP, new Vec3(-1.5, 0, -3), new Vec3(1.5, 0, -1));
            case "measure" -> hand.hold(OffscreenHand.PERSPECTIVE, FLOOR, BLOCK_TOP);
            case "select" -> hand.hold(OffscreenHand.TOP, new Vec3(-3, 0, 1), new Vec3(-4.5, 0, 4));
            case "portal", "paint", "portalable" -> hand.hover(OffscreenHand.PERSPECTIVE, WALL);
            case "extrude", "vertex" -> hand.hover(OffscreenHand.PERSPECTIVE, BLOCK_TOP);
            default -> hand.hover(OffscreenHand.PERSPECTIVE, FLOOR);
        }
    }

    private static void problems(PicturedEditor editor) throws Exception {
        ProblemsPanel problems = editor.the(ProblemsPanel.class);
        EditorSession session = editor.session();
        problems.show(session.background()
                .get(() -> ProblemSearch.of(session.document().level(), session.assets())));
        editor.run("select ids=materials/" + editor.session().options().material(), "four-panes", "unlit");
    }

    private static List<EditorScene> guide() {
        List<EditorScene> scenes = new ArrayList<>();
        int last = GuideStep.values().length;
        scenes.add(EditorScene.whole("guide-" + last, editor -> {
            editor.run("select-none", "lit");
            editor.ui().show("guide");
        }));
        for (int step = last - 1; step > 0; step--) {
            scenes.add(EditorScene.whole("guide-" + step, editor -> editor.click("guide-back")));
        }
        scenes.add(EditorScene.whole("guide-end", editor -> {
            editor.click("guide-skip");
            editor.click("guide-skip");
        }));
        return scenes;
    }
}
