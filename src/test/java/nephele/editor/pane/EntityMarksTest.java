package nephele.editor.pane;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.function.Predicate;
import nephele.engine.level.Body;
import nephele.engine.level.Camera;
import nephele.engine.level.Cloud;
import nephele.engine.level.EditorNotes;
import nephele.engine.level.Environment;
import nephele.engine.level.Exit;
import nephele.engine.level.Exposure;
import nephele.engine.level.Level;
import nephele.engine.level.Light;
import nephele.engine.level.PlayerStart;
import nephele.engine.level.PortalShape;
import nephele.engine.level.PortalSpec;
import nephele.engine.level.ToneCurve;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

@Execution(ExecutionMode.CONCURRENT)
class EntityMarksTest {
    private static final Vec3 UP = new Vec3(0, 1, 0);

    private static Level level(EditorNotes notes) {
        Cloud cloud = new Cloud(
                "puff",
                new Cloud.Extent.Volume(new Vec3(50, 20, 0), new Vec3(4, 2, 6)),
                null,
                new Cloud.Density.Ellipsoid(),
                0.05,
                1,
                0);
        Light spot =
                new Light.Spot("spot", new Vec3(100, 5, 0), new Vec3(0, -1, 0), new Vec3(9, 9, 9), 4, 20, 30, true);
        PortalSpec in = new PortalSpec(
                "in", "out", new Vec3(0, 1, -50), new Vec3(0, 0, 1), UP, 1.2, 2.1, PortalShape.RECTANGLE);
        PortalSpec out = new PortalSpec(
                "out", "in", new Vec3(9, 1, -50), new Vec3(0, 0, 1), UP, 1.2, 2.1, PortalShape.RECTANGLE);
        Environment environment =
                new Environment(null, null, null, Exposure.NEUTRAL, ToneCurve.CLIP, null, List.of(cloud));
        return Level.of(
                        "",
                        "",
                        environment,
                        List.of(new Camera(
                                "c", new Vec3(150, 0, 0), new Vec3(150, 0, -5), UP, 90, 0, 0.1, 100, List.of())))
                .with(List.of(), List.of(), List.of(new Body.Sphere("ball", new Vec3(200, 1, 0), 0.5, 1, null, 0.6, 0)))
                .with(new PlayerStart(new Vec3(0, 0, 0), 90, 0), null)
                .with(environment, List.of(spot))
                .withPortals(List.of(in, out))
                .withExits(List.of(new Exit("exit", new Vec3(-50, 0, 0), 1.5, 3)))
                .with(notes);
    }

    private static List<Mark> marks(String... selected) {
        return EntityMarks.of(level(EditorNotes.NONE), StaticShapes.of(List.of()), Set.of(selected));
    }

    /** Returns the bounds of the lines with an end that fulfils a condition. */
    private static Aabb bounds(List<Mark> marks, MarkColour colour, Predicate<Vec3> isMeant) {
        List<Vec3> points = new ArrayList<>();
        for (Mark mark : marks) {
            if (mark instanceof Mark.Line line && line.colour() == colour && isMeant.test(line.from())) {
                points.add(line.from());
                points.add(line.to());
            }
        }
        return Aabb.of(points);
    }

    @Test
    void theStartIsAsLargeAsThePlayerAndPointsWhereItLooks() {
        Aabb start = bounds(marks(), MarkColour.ENTITY, at -> at.length() < 5);
        assertEquals(0, start.minY(), 1e-9);
        assertEquals(1.8, start.maxY(), 1e-9);
        assertEquals(0.3, start.maxX(), 1e-9);
        assertEquals(-0.9, start.minX(), 1e-9, "yaw 90 looks along −x");
    }

    @Test
    void anExitIsItsCylinderAndACloudItsBoxWithItsName() {
        assertEquals(new Aabb(-51.5, 0, -1.5, -48.5, 3, 1.5), bounds(marks(), MarkColour.ENTITY, at -> at.x() < -40));
        Aabb cloud = bounds(marks(), MarkColour.ENTITY, at -> Math.abs(at.x() - 50) < 5);
        assertEquals(new Aabb(48, 19, -3, 52, 21, 3), cloud);
        assertTrue(marks().stream()
                .anyMatch(
                        mark -> mark instanceof Mark.Label label && label.text().equals("puff")));
    }

    @Test
    void aSelectedSpotShowsItsConesAndABodyItsBounds() {
        Aabb lamp = bounds(marks(), MarkColour.ENTITY, at -> Math.abs(at.x() - 100) < 5);
        assertTrue(lamp.minY() > 4, lamp.toString());
        Aabb reach = bounds(marks("lights/spot"), MarkColour.SELECTED, at -> true);
        assertEquals(5 - 4 * Math.cos(Math.toRadians(20)), reach.minY(), 1e-9);
        assertEquals(102, reach.maxX(), 1e-9);
        assertTrue(bounds(marks(), MarkColour.ENTITY, at -> at.x() > 190).isEmpty());
        assertEquals(
                new Aabb(199.5, 0.5, -0.5, 200.5, 1.5, 0.5),
                bounds(marks("bodies/ball"), MarkColour.SELECTED, at -> true));
    }

    @Test
    void linkedPortalsHaveOneLineBetweenThem() {
        List<Mark> links = marks().stream()
                .filter(mark -> mark.colour() == MarkColour.GUIDE)
                .toList();
        assertEquals(1, links.size());
        Mark.Line link = (Mark.Line) links.get(0);
        assertEquals(9, link.from().minus(link.to()).length(), 1e-9);
    }

    @Test
    void hiddenEntitiesHaveNoSymbol() {
        List<String> all = List.of(
                "player",
                "exits/exit",
                "environment.clouds/puff",
                "lights/spot",
                "portals/in",
                "portals/out",
                "cameras/c");
        Level level = level(new EditorNotes(List.of(), all, List.of(), List.of()));
        assertEquals(List.of(), EntityMarks.of(level, StaticShapes.of(List.of()), Set.copyOf(all)));
    }
}
