package nephele.editor.session;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertSame;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import java.util.stream.Stream;
import nephele.editor.action.Actions;
import nephele.editor.action.EditorCommands;
import nephele.editor.action.ScriptInterface;
import nephele.editor.document.Selection;
import nephele.editor.document.Snapshot;
import nephele.editor.record.EntityRef;
import nephele.editor.save.DocumentFile;
import nephele.editor.terrain.PaintedLevel;
import nephele.editor.text.Words;
import nephele.editor.tool.ToolEntry;
import nephele.editor.tool.ToolScene;
import nephele.engine.level.Level;
import nephele.engine.level.json.LevelJson;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** Escape, another tool and another file in the middle of any tool's drag leave the level exactly as before it. */
@Execution(ExecutionMode.CONCURRENT)
class EndedDragOfEachToolTest {
    private static final Vec3 CORNER = new Vec3(1, 2, 1);
    private static final Vec3 TOP = new Vec3(0, 2, 0);
    private static final Vec3 GROUND = new Vec3(4, 0, 3);

    /** These change nothing before Enter, or never; their drag shows marks only. */
    private static final Set<String> CHANGE_NOTHING = Set.of("clip", "measure");

    private static final String WALL =
            "{\"id\": \"cube\", \"kind\": \"box\", \"portalable\": true, \"centre\": [0, 4, -1], \"size\": [12, 8, 2]}";
    private static final String PORTALS =
            """
            , "portals": [
            {"id": "a", "linkedTo": "b", "centre": [-2, 3, 0], "normal": [0, 0, 1], "widthMetres": 1, "heightMetres": 2},
            {"id": "b", "linkedTo": "a", "centre": [3, 3, 0], "normal": [0, 0, 1], "widthMetres": 1, "heightMetres": 2}]
            """;

    /** Strokes on terrains make files beside the level. */
    @TempDir
    static Path folder;

    private static Stream<ToolEntry> tools() {
        return Tools.ALL.stream();
    }

    /** A drag that changes what is shown. */
    private record Drag(ToolScene scene, Vec3 from, Vec3 to) {
        static Drag with(ToolEntry tool) {
            ToolScene scene = scene(tool);
            scene.session().options().material("red");
            scene.using(tool);
            return switch (tool.id()) {
                case "select" -> new Drag(scene, TOP, new Vec3(3, 2, 0));
                case "move" -> new Drag(scene, atPixels(scene, 60), new Vec3(4, 1, 0));
                case "rotate" -> new Drag(scene, atPixels(scene, 80), new Vec3(0, 1, 3));
                case "scale" -> new Drag(scene, new Vec3(1, 1, 0), new Vec3(3, 1, 0));
                case "extrude" -> new Drag(scene, TOP, new Vec3(0, 3, 0));
                case "vertex" -> new Drag(scene, CORNER, new Vec3(2, 2, 2));
                case "portal" -> portal(scene);
                case "paint", "portalable" -> new Drag(scene, TOP, new Vec3(0, 1, 1));
                case "brush", "clip", "place", "sun", "measure", "terrain" ->
                    new Drag(scene, GROUND, new Vec3(2, 0, 4));
                default -> throw new AssertionError("say here how one drags with " + tool.id());
            };
        }

        private static ToolScene scene(ToolEntry tool) {
            return switch (tool.id()) {
                case "portal" -> ToolScene.of(WALL, PORTALS);
                case "terrain" -> terrain();
                default -> ToolScene.withCube().selecting("cube");
            };
        }

        private static ToolScene terrain() {
            try {
                Path own = Files.createTempDirectory(folder, "level");
                ToolScene scene = ToolScene.over(PaintedLevel.in(own).open());
                scene.document().select(Selection.of(new EntityRef("terrains", "hills")));
                return scene;
            } catch (IOException problem) {
                throw new UncheckedIOException(problem);
            }
        }

        private static Drag portal(ToolScene scene) {
            scene.document().select(Selection.of(new EntityRef("portals", "a")));
            return new Drag(scene, new Vec3(-2, 3, 0), new Vec3(-1, 3.5, 0));
        }

        /** Returns a place on the x axis of the gizmo, whose arrows and rings are as long in every picture. */
        private static Vec3 atPixels(ToolScene scene, double pixels) {
            Vec3 centre = new Vec3(0, 1, 0);
            return centre.plus(new Vec3(pixels * scene.metresPerPixel(centre), 0, 0));
        }

        void begin() {
            scene.move(from);
            scene.press(from);
            scene.drag(from.lerp(to, 0.5));
            scene.drag(to);
        }
    }

    private static void endedBy(ToolEntry tool, Consumer<EditorSession> end) {
        Drag drag = Drag.with(tool);
        ToolScene scene = drag.scene();
        Snapshot before = scene.document().now();
        String text = LevelJson.write(before.level());
        drag.begin();
        if (CHANGE_NOTHING.contains(tool.id())) {
            assertFalse(scene.tool().marks().isEmpty());
        } else {
            assertNotSame(before.level(), scene.level(), "the drag shows nothing");
        }
        end.accept(scene.session());
        assertUntouched(before, text, scene);
        scene.drag(drag.from());
        scene.release(drag.from());
        assertUntouched(before, text, scene);
    }

    private static void assertUntouched(Snapshot before, String text, ToolScene scene) {
        assertSame(before.level(), scene.level());
        assertEquals(text, LevelJson.write(scene.level()));
        assertEquals(before.selection(), scene.document().selection());
        assertFalse(scene.document().isDragging());
        assertFalse(scene.document().history().canUndo(), "a step was made");
    }

    @ParameterizedTest
    @MethodSource("tools")
    void escape(ToolEntry tool) {
        endedBy(tool, session -> session.tool().cancel());
    }

    @ParameterizedTest
    @MethodSource("tools")
    void undo(ToolEntry tool) {
        endedBy(tool, session -> command(session, "undo"));
    }

    /** Returns each tool with each of some commands that change the document. */
    private static Stream<Arguments> toolsAndCommands() {
        return tools().flatMap(
                        tool -> Stream.of("redo", "delete", "duplicate", "paste", "select-all", "hide", "select-invert")
                                .map(command -> Arguments.of(tool, command)));
    }

    /** The command does the same as without the drag, and the rest of the movement nothing. */
    @ParameterizedTest
    @MethodSource("toolsAndCommands")
    void commandInTheMiddle(ToolEntry tool, String command) {
        Drag undisturbed = withRedo(tool);
        command(undisturbed.scene().session(), command);
        Drag drag = withRedo(tool);
        drag.begin();
        command(drag.scene().session(), command);
        Snapshot after = drag.scene().document().now();
        assertEquals(undisturbed.scene().document().now(), after);
        drag.scene().drag(drag.from());
        drag.scene().drag(drag.to());
        drag.scene().release(drag.to());
        assertSame(after.level(), drag.scene().level());
        assertEquals(after.selection(), drag.scene().document().selection());
        assertFalse(drag.scene().document().isDragging());
    }

    private static Drag withRedo(ToolEntry tool) {
        Drag drag = Drag.with(tool);
        drag.scene().document().edit(Words.same("step"), level -> level.with(List.of(), List.of()));
        drag.scene().document().undo();
        return drag;
    }

    /** A level that was read again, a field of the inspector and every other change from elsewhere. */
    @ParameterizedTest
    @MethodSource("tools")
    void changeFromElsewhere(ToolEntry tool) {
        Drag drag = Drag.with(tool);
        ToolScene scene = drag.scene();
        drag.begin();
        Level other = DocumentFile.untitled().level();
        scene.document().edit(Words.same("reload"), mine -> other);
        scene.drag(drag.from());
        scene.release(drag.from());
        assertSame(other, scene.level());
        assertFalse(scene.document().isDragging());
        scene.document().undo();
        assertFalse(scene.document().history().canUndo(), "another step was made");
    }

    private static void command(EditorSession session, String id) {
        new EditorCommands(session, new ScriptInterface(() -> null), Actions.ALL)
                .named(id)
                .orElseThrow()
                .run();
    }

    @ParameterizedTest
    @MethodSource("tools")
    void anotherTool(ToolEntry tool) {
        ToolEntry other = Tools.ALL.get((Tools.ALL.indexOf(tool) + 1) % Tools.ALL.size());
        Drag drag = Drag.with(tool);
        ToolScene scene = drag.scene();
        Snapshot before = scene.document().now();
        drag.begin();
        scene.session().use(other);
        assertUntouched(before, LevelJson.write(before.level()), scene);
    }

    @ParameterizedTest
    @MethodSource("tools")
    void anotherFileAndBack(ToolEntry tool) {
        Drag drag = Drag.with(tool);
        ToolScene scene = drag.scene();
        Level before = scene.level();
        String text = LevelJson.write(before);
        drag.begin();
        EditorSession session = scene.session();
        Level other = DocumentFile.untitled().level();
        session.open(session.file(), other, session.assets());
        Snapshot opened = scene.document().now();
        assertSame(other, opened.level());
        scene.drag(drag.from());
        scene.release(drag.from());
        assertUntouched(opened, LevelJson.write(other), scene);
        assertEquals(text, LevelJson.write(before), "the level of the drag itself");
        assertFalse(scene.tool().confirm(), "points of the other file");
    }
}
