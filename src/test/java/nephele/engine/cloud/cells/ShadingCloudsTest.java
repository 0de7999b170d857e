package nephele.engine.cloud.cells;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import nephele.engine.cloud.ExtinctionField;
import nephele.engine.cloud.MajorantWalk;
import nephele.engine.cloud.field.EllipsoidField;
import nephele.engine.cloud.light.CloudLight;
import nephele.engine.cloud.light.CloudOptics;
import nephele.engine.math.Aabb;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;

/** The cost of shade grows with the clouds on the way of the light, not with pairs of clouds; none of them is missed. */
class ShadingCloudsTest {
    private static final Vec3 LIGHT = new Vec3(-0.48, 0.64, 0.6);

    private static DensityCells ball(Vec3 centre, double radius, int cells) {
        Aabb box = Aabb.around(centre, new Vec3(2 * radius, 2 * radius, 2 * radius));
        return DensityCells.of(new EllipsoidField(box, 0.5), CellBox.of(box, cells));
    }

    private static ShadingClouds.Cast cast(DensityCells cells) {
        return new ShadingClouds.Cast(List.of(cells), false, Vec3.ZERO, 1);
    }

    /** Returns how many pairs of clouds are regarded in a square of clouds. */
    private static int pairs(int side) {
        List<ShadingClouds.Cast> all = new ArrayList<>();
        for (int i = 0; i < side * side; i++) {
            all.add(cast(ball(new Vec3(4 * (i % side), 5, 4 * (i / side)), 1.5, 2)));
        }
        var shading = new ShadingClouds(all, LIGHT);
        int pairs = 0;
        for (int i = 0; i < all.size(); i++) {
            pairs += shading.on(i).size();
        }
        return pairs;
    }

    @Test
    void pairsGrowAsTheNumberOfClouds() {
        assertTrue(pairs(8) > 0);
        assertTrue(pairs(32) <= 20 * pairs(8), pairs(32) + " pairs of 1024 clouds, " + pairs(8) + " of 64");
    }

    @Test
    void noCloudOnTheWayIsMissed() {
        var random = new SplittableRandom(5);
        List<DensityCells> balls = new ArrayList<>();
        for (int i = 0; i < 24; i++) {
            balls.add(ball(
                    new Vec3(random.nextDouble(40), random.nextDouble(40), random.nextDouble(40)),
                    2 + random.nextDouble(6),
                    20));
        }
        var shading =
                new ShadingClouds(balls.stream().map(ShadingCloudsTest::cast).toList(), LIGHT);
        var physics = new CloudLight(CloudOptics.of(1, 0.85));
        double shaded = 0;
        for (int cloud = 0; cloud < 4; cloud++) {
            var around = new LightCells.Around(LIGHT, shading.on(cloud), 2);
            LightCells light = LightCells.of(List.of(balls.get(cloud)), false, physics, around);
            CellBox cells = light.cells();
            for (int cell = 0; cell < cells.count(); cell += 7) {
                int i = cell % cells.nx();
                int j = cell / cells.nx() % cells.ny();
                int k = cell / cells.nx() / cells.ny();
                double own = depth(balls.get(cloud), cells, i, j, k);
                double sum = balls.stream()
                        .mapToDouble(ball -> depth(ball, cells, i, j, k))
                        .sum();
                float found = light.values()[LightCells.VALUES * cell];
                if (found != 0) {
                    assertEquals(sum, found, 1e-5 * (1 + sum), "cloud " + cloud + ", cell " + cell);
                    shaded = Math.max(shaded, sum - own);
                }
            }
        }
        assertTrue(shaded > 1, "the deepest shade is " + shaded);
    }

    private static double depth(DensityCells ball, CellBox cells, int i, int j, int k) {
        return new StackDepths(List.of(ball), false)
                .from(0, cells.centreX(i), cells.centreY(j), cells.centreZ(k), LIGHT.x(), LIGHT.y(), LIGHT.z());
    }

    /** A layer whose extinction rises and falls along x and z. */
    private record Waves() implements ExtinctionField {
        @Override
        public double perMetre(double x, double y, double z) {
            return 0.005 * (1 + Math.sin(x / 150) * Math.cos(z / 150));
        }

        @Override
        public Aabb bounds() {
            return new Aabb(-1e9, 1000, -1e9, 1e9, 1400, 1e9);
        }

        @Override
        public MajorantWalk walk(Ray ray, double fromMetres, double toMetres) {
            throw new UnsupportedOperationException("a layer that is only sampled");
        }
    }

    /** A walk through a layer and the table of its lines agree. */
    @Test
    void linesThroughALayerAreLookedUpAsTheyAreWalked() {
        LayerGrid grid = LayerGrid.ofCloud(1000, 1400, 62.5, 20, 3);
        List<DensityCells> density = new ArrayList<>();
        for (int level = 0; level < 3; level++) {
            density.add(DensityCells.of(new Waves(), grid.box(level, new LayerGrid.Column(0, 0))));
        }
        var depths = new StackDepths(density, true);
        var crossing = new ShadingCloud.LayerCrossing(density, depths, LIGHT);
        double greatest = 0;
        for (int n = 0; n < 200; n++) {
            double x = 7.3 * n - 700;
            double z = 500 - 5.1 * n;
            double y = 999 - n;
            double walked = depths.from(0, x, y, z, LIGHT.x(), LIGHT.y(), LIGHT.z());
            assertEquals(walked, crossing.slanted(x, y, z, 62.5), 0.05 * (0.2 + walked), "point " + n);
            assertEquals(depths.from(0, x, y, z, 0, 1, 0), crossing.upright(x, z, 62.5), 1e-4, "point " + n);
            greatest = Math.max(greatest, walked);
        }
        assertTrue(greatest > 2, "depth " + greatest);
    }
}
