package nephele.editor.brush;

import static nephele.editor.brush.SolidShape.assertAccepted;
import static nephele.editor.brush.SolidShape.bounds;
import static nephele.editor.brush.SolidShape.box;
import static nephele.editor.brush.SolidShape.depth;
import static nephele.editor.brush.SolidShape.volume;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import nephele.engine.level.Brush;
import nephele.engine.level.Solid;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

@Execution(ExecutionMode.CONCURRENT)
class BrushHollowTest {
    private static BrushEdit<List<Solid>> hollowed(Solid solid, double wall) {
        AtomicInteger next = new AtomicInteger();
        return BrushBoolean.hollowed(solid, wall, () -> "wall " + next.incrementAndGet());
    }

    @Test
    void aBoxBecomesSixBoxesWithFloorAndCeilingAcrossTheWalls() {
        Solid room = FaceLooks.withMaterial(box("room", Vec3.ZERO, new Vec3(6, 3, 4)), 3, "tile");
        List<Solid> walls = hollowed(room, 0.25).result().orElseThrow();
        assertEquals(6, walls.size());
        assertEquals("room", walls.get(0).id());
        assertEquals(6, walls.stream().map(Solid::id).distinct().count());
        walls.forEach(wall -> assertInstanceOf(Solid.Box.class, wall));
        assertEquals(new Aabb(0, 2.75, 0, 6, 3, 4), bounds(walls.get(0)));
        assertEquals(new Aabb(0, 0, 0, 6, 0.25, 4), bounds(walls.get(1)));
        assertEquals("tile", SolidShape.towards(walls.get(1), new Vec3(0, 1, 0)).material());
        assertEquals(6 * 3 * 4 - 5.5 * 2.5 * 3.5, volume(walls), 1e-12);
    }

    /** A point belongs to one wall if it is in the solid and nearer to a face than the wall's thickness. */
    @Test
    void theWallsTileTheShellOfAnySolid() {
        RandomSolids solids = new RandomSolids(50);
        double wall = 0.125;
        int hollow = 0;
        for (int i = 0; i < 40; i++) {
            Solid solid = solids.next();
            Brush outside = Brush.of(solid);
            List<Solid> walls = hollowed(solid, wall).result().orElse(List.of());
            hollow += walls.isEmpty() ? 0 : 1;
            List<Brush> parts = walls.stream().map(Brush::of).toList();
            for (int point = 0; point < 60 && !walls.isEmpty(); point++) {
                Vec3 p = SolidShape.pointIn(bounds(solid), solids.random());
                double depth = depth(outside, p);
                boolean isNear = Math.min(Math.abs(depth), Math.abs(depth + wall)) < 1e-7
                        || parts.stream().anyMatch(part -> Math.abs(depth(part, p)) < 1e-7);
                if (!isNear) {
                    assertEquals(
                            depth < 0 && depth > -wall ? 1 : 0,
                            parts.stream().filter(part -> depth(part, p) < 0).count(),
                            p + " in " + solid);
                }
            }
            assertAccepted(walls);
        }
        assertTrue(hollow > 30, hollow + " are hollow");
    }

    @Test
    void wallsThatLeaveNoRoomAreRefused() {
        Solid room = box("room", Vec3.ZERO, new Vec3(6, 3, 4));
        assertEquals(BrushText.WALL_TOO_THICK, hollowed(room, 1.5).refusal().orElseThrow());
        assertEquals(BrushText.TOO_THIN, hollowed(room, 0).refusal().orElseThrow());
        assertEquals(BrushText.TOO_THIN, hollowed(room, Double.NaN).refusal().orElseThrow());
    }
}
