package nephele.engine.scene.probe;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.function.Function;
import nephele.engine.level.Material;
import nephele.engine.level.TestLevel;
import nephele.engine.math.Vec3;
import nephele.engine.scene.Scene;
import nephele.engine.scene.light.bake.BakedLight;
import nephele.engine.scene.light.bake.IndirectLight;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** The light of probes in rooms whose light map is filled by formulas. */
@Execution(ExecutionMode.CONCURRENT)
class BouncedLightTest {
    private static final double ALBEDO = 0.4;
    private static final Vec3 WHITE = new Vec3(1, 1, 1);

    @Test
    void closedRoomOfEqualLightIsItsAlbedoTimesThat() {
        Vec3 light = new Vec3(1, 0.5, 0.25);
        SkyProbes probes = probes(room(-4, 4), chart -> light);
        for (Vec3 place : List.of(new Vec3(0, 1, 0), new Vec3(-3.9, 0.1, 1.9), new Vec3(2.13, 2.9, -1.99))) {
            float[] values = at(probes, place);
            for (int axis = 0; axis < SkyProbes.VALUES; axis++) {
                assertEquals(0, values[axis], 0, "sky in a closed room");
                assertEquals(ALBEDO * light.x(), red(values, axis), 1e-6);
                assertEquals(ALBEDO * light.y(), values[SkyProbes.VALUES + 3 * axis + 1], 1e-6);
                assertEquals(ALBEDO * light.z(), values[SkyProbes.VALUES + 3 * axis + 2], 1e-6);
            }
        }
    }

    @Test
    void emissionAndTheLobeOfInsulatorsAddToIt() {
        TestLevel level = new TestLevel().material(new Material("wall", grey(0.2), null, 0.5, 0.0, null, grey(3), 1));
        SkyProbes probes = probes(shell(level, -4, 4), chart -> grey(10));
        assertEquals(3 + 10 * (0.2 + 0.8 * 0.05), red(at(probes, new Vec3(0, 1, 0)), 2), 1e-5);
    }

    /** What is at 1 cm from a wall of 10 cm is as dark or bright as its own side. */
    @Test
    void darkRoomBesideABrightOneIsDark() {
        SkyProbes probes = probes(
                room(-4, 4).box("wall", new Vec3(0, 1.5, 0), new Vec3(0.1, 3, 4)),
                chart -> chart.x() < 0 ? grey(1000) : Vec3.ZERO);
        Random random = new Random(5);
        for (int i = 0; i < 400; i++) {
            double away = i % 2 == 0 ? 0.06 : 0.06 + 3.9 * random.nextDouble();
            double y = 0.01 + 2.98 * random.nextDouble();
            double z = -1.99 + 3.98 * random.nextDouble();
            float[] dark = at(probes, new Vec3(away, y, z));
            float[] bright = at(probes, new Vec3(-away, y, z));
            for (int axis = 0; axis < SkyProbes.VALUES; axis++) {
                assertEquals(0, red(dark, axis), 1e-5, "dark side, " + away + " m from the wall's middle");
                assertEquals(ALBEDO * 1000, red(bright, axis), 0.1, "bright side");
            }
        }
    }

    @Test
    void lightChangesSmoothlyThroughADoorway() {
        SkyProbes probes = probes(doorway(), chart -> chart.x() < 0 ? grey(1) : Vec3.ZERO);
        float[] before = at(probes, new Vec3(-2, 1.2, 0.2));
        double largest = 0;
        for (int step = 1; step <= 4000; step++) {
            float[] now = at(probes, new Vec3(-2 + 0.001 * step, 1.2, 0.2));
            for (int value = 0; value < now.length; value++) {
                largest = Math.max(largest, Math.abs(now[value] - before[value]));
            }
            before = now;
        }
        assertTrue(largest < 0.01 * ALBEDO, "in a millimetre by " + largest);
        double towardsDoor = red(before, 3);
        double away = red(before, 0);
        assertTrue(towardsDoor > 0.01 && away < towardsDoor / 4, towardsDoor + " from the door, " + away + " away");
    }

    /** No lattice point is in a cupboard that is narrower than the lattice; those around it are under the open sky. */
    @Test
    void cupboardUnderTheOpenSkyIsDark() {
        TestLevel level = new TestLevel().material("wall", grey(ALBEDO));
        double middle = 0.25 + 0.137;
        for (int axis = 0; axis < 3; axis++) {
            for (int side = -1; side <= 1; side += 2) {
                double[] centre = {middle, middle, middle};
                double[] size = {0.48, 0.48, 0.48};
                centre[axis] += side * 0.19;
                size[axis] = 0.1;
                level.box("wall", vector(centre), vector(size));
            }
        }
        float[] values = at(probes(level, chart -> Vec3.ZERO), new Vec3(middle, middle, middle));
        assertArrayEquals(new float[SkyProbes.LIT_VALUES], values);
    }

    @Test
    void deferredPointsComeLater() {
        Function<Vec3, Vec3> light = chart -> grey(chart.y() + 2 * chart.z());
        SkyProbes all = probes(room(-4, 4), light);
        SkyProbes few = probes(room(-4, 4), light);
        few.begin(Map.of());
        at(few, new Vec3(-3, 1, 0));
        Vec3 other = new Vec3(3, 1.1, 0.2);
        float[] values = new float[SkyProbes.LIT_VALUES];
        few.begin(Map.of());
        assertFalse(few.at(other.x(), other.y(), other.z(), values, 0));
        float[] expected = at(all, other);
        for (int axis = 0; axis < SkyProbes.VALUES; axis++) {
            assertEquals(red(expected, axis), red(values, axis), 0.3 * ALBEDO * 6, "from the points known so far");
        }
        for (int frame = 0; frame < 8; frame++) {
            few.begin(Map.of());
            at(few, other);
        }
        assertTrue(few.at(other.x(), other.y(), other.z(), values, 0));
        assertArrayEquals(expected, values, 1e-6f);
        few.cut();
        few.begin(Map.of());
        assertTrue(few.at(0, 1, 0, values, 0));
    }

    @Test
    void layersAreDimmedApart() {
        Scene one = ChartLight.scene(room(-4, 4), chart -> grey(1));
        IndirectLight.Layer shining = one.light().indirect().layers().get(0);
        var lamp = new IndirectLight.Layer(
                "lamp", IndirectLight.Course.DIRECT, shining.texels(), shining.vertices(), shining.grounds());
        SkyProbes probes = probes(new Scene(
                one.level(),
                one.assets(),
                one.statics(),
                one.materials(),
                one.solids(),
                one.cut(),
                new BakedLight(
                        one.light().visibility(),
                        new IndirectLight(IndirectLight.SkyLight.BAKED, List.of(shining, lamp))),
                one.mirrors(),
                one.lights()));
        Vec3 place = new Vec3(0.3, 1, 0.2);
        assertEquals(2 * ALBEDO, red(at(probes, place), 1), 1e-6);
        long before = probes.version();
        probes.begin(Map.of("lamp", 0.25));
        assertEquals(1.25 * ALBEDO, red(at(probes, place), 1), 1e-6);
        assertTrue(probes.version() != before);
    }

    private static double red(float[] values, int axis) {
        return values[SkyProbes.VALUES + 3 * axis];
    }

    private static float[] at(SkyProbes probes, Vec3 place) {
        float[] values = new float[SkyProbes.LIT_VALUES];
        probes.at(place.x(), place.y(), place.z(), values, 0);
        return values;
    }

    private static Vec3 grey(double value) {
        return WHITE.scaled(value);
    }

    private static Vec3 vector(double[] xyz) {
        return new Vec3(xyz[0], xyz[1], xyz[2]);
    }

    /** A closed room, 3 m high and 4 m deep. */
    private static TestLevel room(double fromX, double toX) {
        return shell(new TestLevel().material("wall", grey(ALBEDO)), fromX, toX);
    }

    private static TestLevel shell(TestLevel level, double fromX, double toX) {
        double x = (fromX + toX) / 2;
        double width = toX - fromX;
        return level.box("wall", new Vec3(x, -0.05, 0), new Vec3(width + 0.2, 0.1, 4.2))
                .box("wall", new Vec3(x, 3.05, 0), new Vec3(width + 0.2, 0.1, 4.2))
                .box("wall", new Vec3(fromX - 0.05, 1.5, 0), new Vec3(0.1, 3, 4.2))
                .box("wall", new Vec3(toX + 0.05, 1.5, 0), new Vec3(0.1, 3, 4.2))
                .box("wall", new Vec3(x, 1.5, -2.05), new Vec3(width, 3, 0.1))
                .box("wall", new Vec3(x, 1.5, 2.05), new Vec3(width, 3, 0.1));
    }

    /** Two rooms and a doorway of 1 m between them. */
    private static TestLevel doorway() {
        return room(-4, 4)
                .box("wall", new Vec3(0, 1.5, -1.25), new Vec3(0.1, 3, 1.5))
                .box("wall", new Vec3(0, 1.5, 1.25), new Vec3(0.1, 3, 1.5))
                .box("wall", new Vec3(0, 2.5, 0), new Vec3(0.1, 1, 1));
    }

    private static SkyProbes probes(TestLevel level, Function<Vec3, Vec3> light) {
        return probes(ChartLight.scene(level, light));
    }

    private static SkyProbes probes(Scene scene) {
        return new SkyProbes(scene.statics(), () -> new LitSurfaces(scene), SkyProbes.Sampling.USUAL);
    }
}
