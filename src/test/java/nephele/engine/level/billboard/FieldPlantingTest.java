package nephele.engine.level.billboard;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import nephele.engine.asset.TestAssets;
import nephele.engine.level.Billboards;
import nephele.engine.level.BoxFace;
import nephele.engine.level.Level;
import nephele.engine.level.Solid;
import nephele.engine.level.TestLevel;
import nephele.engine.level.TextureMapping;
import nephele.engine.level.placed.NoFiles;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Vec3;
import nephele.engine.math.heightfield.HeightField;
import nephele.engine.math.heightfield.HeightFieldSurface;
import org.junit.jupiter.api.Test;

class FieldPlantingTest {
    private static Solid box(String id, Vec3 centre, Vec3 size) {
        return new Solid.Box(id, null, false, TextureMapping.FACE, centre, size, Map.of());
    }

    private static FieldPlanting.Ground ground() {
        Level level = new TestLevel()
                .solid(box("floor", new Vec3(0, -0.5, 0), new Vec3(20, 1, 20)))
                .solid(box("block", new Vec3(5, 1, 5), new Vec3(4, 2, 4)))
                .solid(new Solid.Wedge(
                        "ramp",
                        null,
                        false,
                        TextureMapping.FACE,
                        new Vec3(-5, 1, -5),
                        new Vec3(4, 2, 4),
                        BoxFace.PLUS_X,
                        Map.of()))
                .level();
        return new FieldPlanting.SurfaceGround(StaticShapes.of(level));
    }

    private static Billboards.Field field(int count, double maxSlope, Billboards.HeightLimits heights) {
        return new Billboards.Field(null, 4, count, 0.6, null, maxSlope, heights);
    }

    private static List<Vec3> plant(Billboards.Field field) {
        return FieldPlanting.plant(field, ground(), NoFiles.AT_ALL);
    }

    @Test
    void theGroundIsTheHighestSurface() {
        assertEquals(0, ground().at(0, 0).at().y(), 1e-12);
        assertEquals(2, ground().at(5, 5).at().y(), 1e-12);
        assertEquals(1, ground().at(-5, -5).at().y(), 1e-12);
        assertEquals(
                0.4,
                1
                        - ground().at(-5, -5).normal().y()
                                * ground().at(-5, -5).normal().y()
                        + 0.2,
                1e-12);
        assertNull(ground().at(11, 0));
        assertEquals(-10, ground().bounds().minX());
        assertEquals(10, ground().bounds().maxZ());
    }

    @Test
    void everyPlaceIsOnTheGround() {
        FieldPlanting.Ground ground = ground();
        List<Vec3> places = plant(field(300, 90, null));
        assertEquals(300, places.size());
        places.forEach(p -> assertEquals(ground.at(p.x(), p.z()).at().y(), p.y(), 1e-12));
        assertTrue(places.stream().anyMatch(p -> p.y() > 1.9));
    }

    @Test
    void steepAndHighPlacesStayEmpty() {
        List<Vec3> flat = plant(field(300, 20, new Billboards.HeightLimits(-0.1, 1.5)));
        assertEquals(300, flat.size());
        flat.forEach(p -> assertEquals(0, p.y(), 1e-12));
    }

    @Test
    void noMoreThanFitArePlanted() {
        List<Vec3> onBlock = plant(field(300, 20, new Billboards.HeightLimits(1.9, 2.1)));
        assertTrue(onBlock.size() > 25 && onBlock.size() < 60, onBlock.size() + " fit");
    }

    /** A density map lies over the ground as seen from above, its left side at the least x, its upper side at the least z. */
    @Test
    void theDensityMapLiesOverTheGroundAsSeenFromAbove() {
        TestAssets maps = new TestAssets()
                .picture("left.png", 8, 8, (x, y) -> x < 4 ? 0xffffff : 0)
                .picture("upper.png", 8, 8, (x, y) -> y < 4 ? 0xffffff : 0);
        List<Vec3> left = plant("left.png", maps);
        List<Vec3> upper = plant("upper.png", maps);
        assertTrue(left.size() > 20 && upper.size() > 20);
        left.forEach(p -> assertTrue(p.x() <= 0, p.toString()));
        upper.forEach(p -> assertTrue(p.z() <= 0, p.toString()));
    }

    private static List<Vec3> plant(String map, TestAssets maps) {
        return FieldPlanting.plant(new Billboards.Field(null, 4, 50, 0.6, map, 90, null), ground(), maps);
    }

    /** A roof of 30 degrees: its ridge runs along z at x = 8. */
    private static final HeightField ROOF = HeightField.of(
            new Vec3(-2, 3, 4), 1, 21, 11, (column, row) -> (10 - Math.abs(column - 10)) * Math.tan(Math.PI / 6));

    @Test
    void billboardsOfATerrainStandOnItsTriangles() {
        var field = new Billboards.Field("roof", 1, 40, 0.8, null, 90, null);
        List<Vec3> feet = FieldPlanting.plant(field, new FieldPlanting.TerrainGround(ROOF), null);
        assertEquals(40, feet.size());
        for (Vec3 foot : feet) {
            assertEquals(HeightFieldSurface.y(ROOF, foot.x(), foot.z()), foot.y(), 1e-9);
        }
    }

    @Test
    void besideTheTerrainAndOnItsSlopesIsNoGround() {
        var ground = new FieldPlanting.TerrainGround(ROOF);
        assertNull(ground.at(-2.1, 5));
        assertEquals(Math.cos(Math.PI / 6), ground.at(3.3, 9.2).normal().y(), 1e-6);
        var flat = new Billboards.Field("roof", 1, 40, 0.8, null, 20, null);
        List<Vec3> feet = FieldPlanting.plant(flat, ground, null);
        assertTrue(feet.stream().allMatch(foot -> Math.abs(foot.x() - 8) <= 1), feet.toString());
    }
}
