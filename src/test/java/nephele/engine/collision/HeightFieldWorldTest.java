package nephele.engine.collision;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.engine.level.Brush;
import nephele.engine.level.TestTerrain;
import nephele.engine.level.placed.PlacedModels;
import nephele.engine.level.placed.StaticShape;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Aabb;
import nephele.engine.math.ConvexPolyhedron;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import nephele.engine.math.bvh.ItemList;
import nephele.engine.math.heightfield.HeightField;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Ground in a collision world answers the same queries as other colliders. */
class HeightFieldWorldTest {
    private static final RoundedHull PLAYER = RoundedHull.uprightCapsule(0.3, 1.8);

    private static CollisionWorld ground(double out, double slope) {
        HeightField field = HeightField.of(new Vec3(out, 0, -out), 1, 33, 17, (column, row) -> slope * column);
        return CollisionWorld.of(statics(List.of(), TestTerrain.grid("hill", field)));
    }

    private static StaticShapes statics(List<Brush> solids, StaticShape.HeightGrid grid) {
        return new StaticShapes(solids, PlacedModels.NONE, List.of(grid));
    }

    @ParameterizedTest
    @CsvSource({"0, 0", "1e5, 0", "0, 0.5", "-1e5, 1", "0, 3"})
    void aFallingCapsuleStopsASkinAboveTheSlope(double out, double slope) {
        CollisionWorld world = ground(out, slope);
        Sweep sweep = new Sweep();
        double x = 7.25;
        Vector3d from = new Vector3d(out + x, slope * x + 20, -out + 6.5);
        assertTrue(sweep.cast(world, PLAYER, from, new Vector3d(0, -40, 0)));
        double cosine = 1 / Math.sqrt(1 + slope * slope);
        double gap = (0.3 + Sweep.SKIN_METRES) / cosine;
        assertEquals(20 - 0.6 - gap, 40 * sweep.fraction(), 1e-7);
        assertEquals(cosine, sweep.normal().y(), 1e-9);
        assertEquals(-slope * cosine, sweep.normal().x(), 1e-9);
        assertEquals("hill", world.collider(sweep.collider()).solidId());
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 1e-300})
    void aSweepOfNoLengthMeetsNothing(double length) {
        Sweep sweep = new Sweep();
        Vector3d at = new Vector3d(7.5, 0.9 + Sweep.SKIN_METRES, 6.5);
        boolean isMet = sweep.cast(ground(0, 0), PLAYER, at, new Vector3d(length, 0, 0));
        assertFalse(isMet);
        assertEquals(1, sweep.fraction());
    }

    /** A capsule slides along edges and diagonals of flat ground without contact at the edges between triangles. */
    @ParameterizedTest
    @CsvSource({"1, 0", "0, 1", "1, 1", "1, -1", "0.3, 0.7"})
    void aCapsuleSlidesOverFlatGroundUncaught(double x, double z) {
        Sweep sweep = new Sweep();
        Vector3d at = new Vector3d(16, 0.9 + Sweep.SKIN_METRES + 1e-6, 8);
        assertFalse(sweep.cast(ground(0, 0), PLAYER, at, new Vector3d(7 * x, 0, 7 * z)));
    }

    /** It stops below the surface, where the sheet is thickest; its box does not overlap the triangle's. */
    @Test
    void aShapeFromBelowMeetsTheUndersideOfTheSheet() {
        Sweep sweep = new Sweep();
        double middle = 1 - Math.sqrt(0.5);
        Vector3d from = new Vector3d(4 + middle, -0.5, 5 - middle);
        assertTrue(sweep.cast(ground(0, 0), RoundedHull.sphere(0.1), from, new Vector3d(0, 0.385, 0)));
        assertEquals(0.4 - Collider.TRIANGLE_DEPTH_METRES - Sweep.SKIN_METRES, 0.385 * sweep.fraction(), 1e-6);
    }

    @Test
    void aShapeInTheGroundKnowsHowDeepAndFindsItsWayOut() {
        CollisionWorld world = ground(0, 0);
        Depenetration depenetration = new Depenetration();
        Vector3d at = new Vector3d(7.4, 0.9 - 0.01, 6.2);
        assertEquals(0.01, depenetration.depth(world, PLAYER, at), 1e-9);
        assertFalse(depenetration.isFree(world, PLAYER, at));
        assertTrue(depenetration.isFree(world, PLAYER, new Vector3d(7.4, 0.9 + 1e-12, 6.2)));
        Vector3d out = new Vector3d();
        assertTrue(depenetration.find(world, PLAYER, at, out));
        assertEquals(0.01 + Sweep.SKIN_METRES, out.y, 1e-9);
    }

    @ParameterizedTest
    @CsvSource({"4, 4", "4.5, 4", "4, 4.5", "4.5, 4.5", "4.2, 4.9"})
    void aRayMeetsTheGroundOnCornersEdgesAndDiagonals(double x, double z) {
        RayCast cast = new RayCast();
        CollisionWorld world = ground(0, 0.5);
        Ray ray = new Ray(x, 10, z, 0, -1, 0);
        assertTrue(cast.cast(world, ray, 100));
        assertEquals(10 - 0.5 * x, cast.distance(), 1e-12);
        assertEquals(0, cast.face(ray));
        assertFalse(cast.cast(world, ray, 7));
        assertFalse(cast.cast(world, new Ray(x, -10, z, 0, 1, 0), 100));
    }

    /** Solids come first, then the triangles; removed and added solids do not change the other indices. */
    @Test
    void groundStandsBesideSolidsAndIsReplacedLikeThem() {
        HeightField field = HeightField.of(Vec3.ZERO, 1, 5, 5, (column, row) -> 0);
        ConvexPolyhedron box = ConvexPolyhedron.box(new Aabb(1, -1, 1, 2, 3, 2));
        Brush brush = new Brush("box", box, List.of());
        CollisionWorld world = CollisionWorld.of(statics(List.of(brush), TestTerrain.grid("ground", field)));
        assertEquals(33, world.size());
        RayCast cast = new RayCast();
        assertTrue(cast.cast(world, new Ray(1.5, 9, 1.25, 0, -1, 0), 100));
        assertEquals(0, cast.collider());
        assertTrue(cast.cast(world, new Ray(0.25, 9, 0.75, 0, -1, 0), 100));
        assertEquals(1, cast.collider());

        ItemList cut = new ItemList();
        cut.accept(1);
        CollisionWorld open = world.replacing(cut, List.of());
        assertFalse(cast.cast(open, new Ray(0.25, 9, 0.75, 0, -1, 0), 100));
        assertTrue(cast.cast(open, new Ray(0.75, 9, 0.25, 0, -1, 0), 100));
        assertEquals(2, cast.collider());
        CollisionWorld more =
                open.with(List.of(new Collider("more", ConvexPolyhedron.box(new Aabb(0, 5, 0, 4, 6, 4)))));
        assertTrue(cast.cast(more, new Ray(0.75, 9, 0.25, 0, -1, 0), 100));
        assertEquals(33, cast.collider());
    }
}
