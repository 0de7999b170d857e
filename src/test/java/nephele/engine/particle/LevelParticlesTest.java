package nephele.engine.particle;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import nephele.engine.level.Emitter;
import nephele.engine.level.Emitter.Kind;
import nephele.engine.level.RecordCopy;
import nephele.engine.level.TestLevel;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** The particles of a time depend on nothing but the time. */
@Execution(ExecutionMode.CONCURRENT)
class LevelParticlesTest {
    private static final double MONTH_SECONDS = 30 * 86_400;

    /** At 30 frames a second, at 144, and in random order, each time has the same particles, bit for bit. */
    @Test
    void frameRateAndOrderDoNotMatter() {
        List<Double> times = new ArrayList<>();
        for (int frame = 0; frame < 120; frame++) {
            times.add(frame / 30.0);
            times.add(frame / 144.0);
        }
        LevelParticles inOrder = TestEmitters.particles(TestEmitters.all());
        List<float[]> expected =
                times.stream().map(t -> TestEmitters.numbers(inOrder, t)).toList();
        List<Integer> shuffled = new ArrayList<>();
        for (int i = 0; i < times.size(); i++) {
            shuffled.add(i);
        }
        Collections.shuffle(shuffled, new Random(1));
        LevelParticles anew = TestEmitters.particles(TestEmitters.all());
        for (int i : shuffled) {
            assertArrayEquals(expected.get(i), TestEmitters.numbers(anew, times.get(i)));
        }
    }

    @ParameterizedTest
    @EnumSource(Kind.class)
    void whatStartsAMonthLaterIsTheSameAMonthLater(Kind kind) {
        Emitter now = TestEmitters.of(kind, 60);
        float[] early = TestEmitters.numbers(TestEmitters.particles(List.of(now)), 2.3);
        float[] late = TestEmitters.numbers(
                TestEmitters.particles(List.of(RecordCopy.with(now, "startSeconds", MONTH_SECONDS))),
                MONTH_SECONDS + 2.3);
        assertArrayEquals(early, late, 1e-5f);
    }

    /** A month after the start, a particle moves from frame to frame as it does at first: less than 0.2 m in 1/240 s. */
    @ParameterizedTest
    @EnumSource(Kind.class)
    void motionIsSmoothAMonthAfterTheStart(Kind kind) {
        LevelParticles particles = TestEmitters.particles(List.of(TestEmitters.of(kind, 400)));
        double seconds = MONTH_SECONDS + 1;
        float[] before = TestEmitters.numbers(particles, seconds);
        float[] after = TestEmitters.numbers(particles, seconds + 1.0 / 240);
        assertTrue(before.length > 14, "nothing to see");
        int moved = 0;
        int still = 0;
        for (int i = 0; i < before.length; i += 14) {
            double nearest = nearest(before, i, after);
            moved += nearest < 0.2 ? 1 : 0;
            still += nearest == 0 ? 1 : 0;
        }
        int count = before.length / 14;
        // A few end in between.
        assertTrue(moved >= 0.93 * count, moved + " of " + count);
        assertEquals(0, still);
    }

    private static double nearest(float[] before, int i, float[] after) {
        double nearest = Double.POSITIVE_INFINITY;
        for (int k = 0; k < after.length; k += 14) {
            double x = after[k] - before[i];
            double y = after[k + 1] - before[i + 1];
            double z = after[k + 2] - before[i + 2];
            nearest = Math.min(nearest, Math.sqrt(x * x + y * y + z * z));
        }
        return nearest;
    }

    @ParameterizedTest
    @EnumSource(Kind.class)
    void allIsFiniteWithinTheBoundsAndNotNegative(Kind kind) {
        Emitter emitter = TestEmitters.of(kind, 300);
        LevelParticles particles = TestEmitters.particles(List.of(emitter));
        Aabb bounds = particles.bounds(0).moved(emitter.centre().negated());
        double most = emitter.mostAtOnce();
        int pictures = Stream.of(ParticlePicture.values())
                .mapToInt(ParticlePicture::variants)
                .sum();
        for (double seconds = 0; seconds < 14; seconds += 0.37) {
            ParticleArrays at = particles.at(seconds);
            assertTrue(at.count() <= most, at.count() + " of " + most);
            for (float number : TestEmitters.numbers(particles, seconds)) {
                assertTrue(Float.isFinite(number));
            }
            for (int i = 0; i < at.count(); i++) {
                float reach = at.get(i, ParticleArrays.HALF_WIDTH) + Math.abs(at.get(i, ParticleArrays.ALONG_X));
                float up = at.get(i, ParticleArrays.HALF_WIDTH) + Math.abs(at.get(i, ParticleArrays.ALONG_Y));
                assertTrue(
                        bounds.contains(
                                at.get(i, ParticleArrays.X) + reach,
                                at.get(i, ParticleArrays.Y) + up,
                                at.get(i, ParticleArrays.Z)),
                        "particle " + i);
                assertTrue(
                        bounds.contains(
                                at.get(i, ParticleArrays.X) - reach,
                                at.get(i, ParticleArrays.Y) - up,
                                at.get(i, ParticleArrays.Z)),
                        "particle " + i);
                assertTrue(at.get(i, ParticleArrays.OPACITY) >= 0
                        && at.get(i, ParticleArrays.OPACITY) <= 1
                        && at.get(i, ParticleArrays.HALF_WIDTH) >= 0);
                assertTrue(at.get(i, ParticleArrays.RED) >= 0
                        && at.get(i, ParticleArrays.GREEN) >= 0
                        && at.get(i, ParticleArrays.BLUE) >= 0);
                assertTrue(at.get(i, ParticleArrays.LOOK) >= 0 && at.get(i, ParticleArrays.LOOK) < pictures);
            }
        }
    }

    /** Flakes that fall three metres live 2.73 s, so that 2.73 times the rate of them are there. */
    @Test
    void theRateIsExact() {
        LevelParticles snow = TestEmitters.particles(List.of(TestEmitters.of(Kind.SNOW, 100)));
        for (double seconds = 3; seconds < 9; seconds += 0.71) {
            assertEquals(100 * 3 / 1.1, snow.at(seconds).count(), 3);
        }
        LevelParticles explosion = TestEmitters.particles(List.of(TestEmitters.of(Kind.EXPLOSION, 80)));
        assertEquals(80, explosion.at(12.1).count());
        assertEquals(0, explosion.at(17.5).count());
    }

    @Test
    void nothingIsThereBeforeTheStartAndAtRateZero() {
        for (Kind kind : Kind.values()) {
            LevelParticles later =
                    TestEmitters.particles(List.of(RecordCopy.with(TestEmitters.of(kind, 60), "startSeconds", 5)));
            assertEquals(0, later.at(4.99).count());
            assertEquals(
                    0,
                    TestEmitters.particles(List.of(TestEmitters.of(kind, 0)))
                            .at(3)
                            .count());
        }
    }

    /** The window of indices holds every particle that has been born and has not ended, and no other. */
    @ParameterizedTest
    @EnumSource(
            value = Kind.class,
            names = {"EXPLOSION", "QUADS"},
            mode = EnumSource.Mode.EXCLUDE)
    void theWindowOfIndicesLeavesNoLivingParticleOut(Kind kind) {
        Emitter emitter = TestEmitters.of(kind, 40);
        ParticleLaw law = ParticleLaw.of(emitter);
        EmitterParticles particles = new EmitterParticles(emitter, null);
        for (double seconds = 0; seconds < 12; seconds += 0.013) {
            ParticleArrays found = new ParticleArrays(1000);
            particles.addTo(found, 0, seconds);
            int expected = 0;
            for (long index = 0; index <= 40 * seconds; index++) {
                double age = seconds - particles.birthSeconds(index);
                expected += age >= 0 && law.at(index, age, seconds, new ParticleState()) ? 1 : 0;
            }
            assertEquals(expected, found.count(), kind + " at " + seconds);
        }
    }

    /** Whatever a time and a rate multiply to: no endless loop, no NaN, no more particles than there can be. */
    @ParameterizedTest
    @EnumSource(Kind.class)
    void everyFiniteTimeHasFiniteParticles(Kind kind) {
        for (double rate : new double[] {Double.MIN_VALUE, 1e-300, 1, 60, 2000}) {
            Emitter emitter = TestEmitters.of(kind, rate);
            LevelParticles particles = TestEmitters.particles(List.of(emitter));
            for (double seconds : new double[] {
                Double.MIN_VALUE, 1e-300, 1, 1e9, 0x1p63 / rate, 1e15, 1e18, 1e300, Double.MAX_VALUE, -Double.MAX_VALUE
            }) {
                if (Double.isFinite(seconds)) {
                    assertTrue(particles.at(seconds).count() <= emitter.mostAtOnce() + 1, kind + " at " + seconds);
                    for (float number : TestEmitters.numbers(particles, seconds)) {
                        assertTrue(Float.isFinite(number), kind + " at " + seconds);
                    }
                }
            }
        }
    }

    /** A drop over the roof ends on it; beside it, drops reach the floor; a roof above the box stops nothing. */
    @Test
    void rainAndSnowDoNotFallThroughRoofs() {
        StaticShapes statics = StaticShapes.of(new TestLevel()
                .box(null, new Vec3(0, -0.5, 0), new Vec3(20, 1, 20))
                .box(null, new Vec3(1.5, 2, 0), new Vec3(3, 0.2, 6))
                .box(null, new Vec3(0, 9, 0), new Vec3(20, 0.2, 20))
                .level());
        for (Kind kind : List.of(Kind.RAIN, Kind.SNOW)) {
            Emitter emitter =
                    new Emitter("e", kind, new Vec3(0, 3, 0), new Vec3(6, 6.4, 6), kind == Kind.RAIN ? 4000 : 700);
            LevelParticles particles = new LevelParticles(List.of(emitter), statics);
            int below = 0;
            int low = 0;
            ParticleArrays at = particles.at(20);
            for (int i = 0; i < at.count(); i++) {
                assertTrue(at.get(i, ParticleArrays.Y) > -3, "in the floor");
                // The grid's cells are 0.125 m wide.
                below += at.get(i, ParticleArrays.X) > 0.07
                                && at.get(i, ParticleArrays.X) < 2.93
                                && Math.abs(at.get(i, ParticleArrays.Z)) < 2.93
                                && at.get(i, ParticleArrays.Y) < -0.9
                        ? 1
                        : 0;
                low += at.get(i, ParticleArrays.X) < -0.07 && at.get(i, ParticleArrays.Y) < -2.4 ? 1 : 0;
            }
            assertEquals(0, below, kind + " below the roof");
            assertTrue(low > 20, low + " near the floor");
        }
    }
}
