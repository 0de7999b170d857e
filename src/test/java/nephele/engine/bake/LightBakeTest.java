package nephele.engine.bake;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ForkJoinPool;
import java.util.stream.IntStream;
import nephele.engine.asset.TestAssets;
import nephele.engine.level.Material;
import nephele.engine.level.Sky;
import nephele.engine.level.TestLevel;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.math.Vec3;
import nephele.engine.scene.light.bake.IndirectLight.Course;
import nephele.engine.scene.light.bake.IndirectLight.Layer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A bake has the light that laws give it, the same bytes however it is run, and nothing of it passes a wall. */
class LightBakeTest {
    private static final LightBake.Settings COARSE = new LightBake.Settings(0.05, 256);

    /** A store that remembers every block, as a file does. */
    private record Kept(Map<Integer, float[]> blocks) implements LightBake.Checkpoint {
        @Override
        public Optional<float[]> known(int block) {
            return Optional.ofNullable(blocks.get(block));
        }

        @Override
        public void store(int block, float[] values) {
            blocks.put(block, values.clone());
        }
    }

    /** A closed room whose walls are as thick as the narrowest that levels have. */
    private static TestLevel room(TestLevel level, String material) {
        double wall = 0.1;
        level.box(material, new Vec3(0, -1.05, 0), new Vec3(2.2, wall, 2.2));
        level.box(material, new Vec3(0, 1.05, 0), new Vec3(2.2, wall, 2.2));
        level.box(material, new Vec3(-1.05, 0, 0), new Vec3(wall, 2, 2.2));
        level.box(material, new Vec3(1.05, 0, 0), new Vec3(wall, 2, 2.2));
        level.box(material, new Vec3(0, 0, -1.05), new Vec3(2, 2, wall));
        return level.box(material, new Vec3(0, 0, 1.05), new Vec3(2, 2, wall));
    }

    private static LightBake bake(TestLevel level, LightBake.Checkpoint checkpoint) {
        LightBake bake = LightBake.of(PlacedLevel.of(level.level(), TestAssets.NONE), COARSE);
        bake.run(checkpoint, done -> {});
        return bake;
    }

    private static float[] radiance(LightBake bake, Course course) {
        return bake.light().layers().stream()
                .filter(layer -> layer.course() == course)
                .map(Layer::texels)
                .findFirst()
                .orElseThrow()
                .radiance();
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.1, 0.5, 0.9})
    void aClosedRoomOfOneAlbedoAndEmissionIsEvenlyBright(double albedo) {
        Material wall = new Material("wall", TestLevel.grey(albedo), null, null, null, null, TestLevel.grey(2), 1);
        float[] radiance = radiance(
                bake(room(new TestLevel().skyLight().material(wall), "wall"), LightBake.Checkpoint.NONE),
                Course.INDIRECT);
        double wanted = 2 / (1 - albedo);
        double sum = 0;
        int count = 0;
        for (float value : radiance) {
            if (value > 0) {
                assertEquals(wanted, value, 0.2 * wanted);
                sum += value;
                count++;
            }
        }
        assertTrue(count > 1000, "texels inside: " + count);
        assertEquals(wanted, sum / count, 0.004 * wanted);
    }

    @Test
    void nothingOfTheNoonSunPassesAWallOfTenCentimetres() {
        TestLevel level = room(
                new TestLevel()
                        .skyLight()
                        .castingSun(new Vec3(0.1, 1, 0.2), 100)
                        .sky(new Sky.Constant(TestLevel.grey(10))),
                "");
        level.box("", new Vec3(0, -1.3, 0), new Vec3(6, 0.4, 6));
        LightBake bake = bake(level, LightBake.Checkpoint.NONE);
        int dark = 0;
        for (Course course : Course.values()) {
            for (float value : radiance(bake, course)) {
                assertTrue(value < 1e-5 * 100 || value > 1e-2, "between dark and outside: " + value);
                dark += value < 1e-3 ? 1 : 0;
            }
        }
        assertTrue(dark > 2 * 6 * 81 * 3, "dark values: " + dark);
    }

    @Test
    void oneThreadAndAnInterruptedBakeGiveTheSameLight() throws Exception {
        Material glow = new Material("glow", TestLevel.grey(0.5), null, null, null, null, TestLevel.grey(2), 1);
        TestLevel level = room(new TestLevel().skyLight().sky(new Sky.Constant(TestLevel.grey(1))), "")
                .material(glow);
        level.box("glow", new Vec3(0, -0.8, 0.3), new Vec3(0.5, 0.3, 0.5));
        var kept = new Kept(new ConcurrentHashMap<>());
        float[] many = radiance(bake(level, kept), Course.INDIRECT);
        var alone = new ForkJoinPool(1);
        kept.blocks.keySet().removeIf(block -> block % 2 == 0);
        float[] one =
                alone.submit(() -> radiance(bake(level, kept), Course.INDIRECT)).get();
        alone.shutdown();
        assertArrayEquals(many, one);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 40})
    void blocksAreGatheredFromAPlaceOn(double x) throws Exception {
        TestLevel level = new TestLevel().skyLight().sky(new Sky.Constant(TestLevel.grey(1)));
        level.box("", Vec3.ZERO, new Vec3(3, 3, 3)).box("", new Vec3(40, 0, 0), new Vec3(3, 3, 3));
        LightBake bake = LightBake.of(PlacedLevel.of(level.level(), TestAssets.NONE), new LightBake.Settings(1, 1));
        int[] order = bake.blocksFrom(new Vec3(x, 5, 0));
        List<Integer> gathered = new ArrayList<>();
        LightBake.Checkpoint noted = new LightBake.Checkpoint() {
            @Override
            public Optional<float[]> known(int block) {
                return Optional.empty();
            }

            @Override
            public void store(int block, float[] values) {
                gathered.add(block);
            }
        };
        var alone = new ForkJoinPool(1);
        alone.submit(() -> bake.gather(order, noted, done -> {})).get();
        alone.shutdown();
        assertEquals(Arrays.stream(order).boxed().toList(), gathered);
        assertEquals(bake.blocks(), Set.copyOf(gathered).size());
        for (int i = 0; i < bake.blocks() / 2; i++) {
            boolean isNear = IntStream.range(LightBake.firstOf(order[i]), bake.lastOf(order[i]))
                    .anyMatch(receiver ->
                            Math.abs(bake.allReceivers().place(receiver).x() - x) < 2);
            assertTrue(isNear, "block " + i + " of " + bake.blocks());
        }
    }
}
